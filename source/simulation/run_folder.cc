// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_folder.h>

#include "posix_file.h"

#include <orthocone/parameters/errors.h>

#include <algorithm>
#include <regex>
#include <vector>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

constexpr const char *marker = "parameters.prm";
constexpr const char *checkpoint_folder = "checkpoint";

[[noreturn]] void fail(const fs::path &file, const std::string &task, const std::string &cause)
{
  throw FileError(file.string() + ": " + task + " (" + cause + ")");
}

/// Names of the files in a folder that match a pattern, sorted.
std::vector<std::string> matching(const fs::path &folder, const std::string &pattern)
{
  const std::regex expression(pattern);
  std::vector<std::string> names;
  if (fs::exists(folder))
    for (const auto &entry : fs::directory_iterator(folder))
      if (const std::string name = entry.path().filename().string(); std::regex_match(name, expression))
        names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

/// All that a run may leave, the checkpoint first: without its other files it is worth nothing.
std::vector<std::string> files_of_a_run(const fs::path &folder)
{
  std::vector<std::string> names;
  for (const std::string &name : matching(folder / checkpoint_folder, "state(\\.part)?"))
    names.push_back(std::string(checkpoint_folder) + "/" + name);
  for (const std::string &name : matching(
           folder,
           "((contact|volume)(-\\d{4,9}\\.vtu|\\.pvd)|probe-.*\\.csv|(history|timing|checks|cycles)\\.csv|"
           "summary\\.json|(input|parameters)\\.prm|input\\.json|log\\.txt|report\\.html)(\\.part)?"))
    names.push_back(name);
  return names;
}

std::vector<std::string> tables(const fs::path &folder)
{
  return matching(folder, "probe-.*\\.csv|(history|timing|checks|cycles)\\.csv");
}
} // namespace

RunFolder::RunFolder(const fs::path &path)
    : path_(path)
{
  std::error_code code;
  if (fs::exists(path_, code) && !fs::is_directory(path_, code))
    fail(path_, "cannot be the run folder",
         "a file of this name is in its place; --output DIR takes another one");
  fs::create_directories(path_, code);
  if (code)
    fail(path_, "cannot be created as the run folder", code.message());
  lock();
}

RunFolder::~RunFolder()
{
  posix::close(lock_);
}

void RunFolder::lock()
{
  const auto result = posix::lock_folder(path_);
  if (result.is_taken)
    fail(path_, "cannot be the run folder",
         "another run is writing there; wait for it, or take another one by --output DIR");
  lock_ = result.descriptor;
}

void RunFolder::start_anew(const std::string &parameters) const
{
  const std::vector<std::string> files = files_of_a_run(path_);
  if (!files.empty() && !has(marker) && !has(std::string(marker) + ".part"))
    fail(path_, "cannot be the run folder",
         "it holds a " + files.front() + " that no run left there, for " + marker +
             " is missing; --output DIR takes another one");
  // Before anything is removed, everything must be removable, and there must be room for the new parameters.
  for (const std::string &file : files)
    if (fs::is_directory(path_ / file))
      fail(path_ / file, "cannot be replaced", "a folder of this name is in its place");
  const fs::path part = write_part(marker, parameters, false);
  for (const std::string &name : files)
    if (name.compare(0, std::string(checkpoint_folder).size(), checkpoint_folder) == 0)
      remove(name);
  // From here on the folder is that of the new run, which has not come to a checkpoint yet.
  posix::rename(part, path_ / marker);
  for (const std::string &name : files)
    if (name != marker)
      remove(name);
}

void RunFolder::remove_fields_after(const unsigned int step) const
{
  for (const std::string &name : matching(path_, "(contact|volume)-\\d{4,9}\\.vtu"))
    if (std::stoull(name.substr(name.find('-') + 1)) > step)
      remove(name);
}

/// The new content beside the file; nothing stays if it cannot be written.
fs::path RunFolder::write_part(const std::string &name, const std::string &content, const bool durably) const
{
  const fs::path part = path_ / (name + ".part");
  std::error_code code;
  fs::create_directories(part.parent_path(), code);
  if (code)
    fail(part.parent_path(), "cannot be created", code.message());
  try
  {
    posix::write(part, content);
    if (durably)
      posix::synchronize(part);
    return part;
  }
  catch (const FileError &)
  {
    fs::remove(part, code);
    throw;
  }
}

void RunFolder::replace(const std::string &name, const std::string &content, const bool durably) const
{
  const fs::path part = write_part(name, content, durably);
  try
  {
    posix::rename(part, path_ / name);
  }
  catch (const FileError &)
  {
    std::error_code code;
    fs::remove(part, code);
    throw;
  }
}

void RunFolder::write(const std::string &name, const std::string &content) const
{
  replace(name, content, false);
  not_on_disk_.insert(name);
}

void RunFolder::write_durably(const std::string &name, const std::string &content) const
{
  for (const std::string &file : not_on_disk_)
    if (has(file))
      posix::synchronize(path_ / file);
  not_on_disk_.clear();
  posix::synchronize(path_);
  replace(name, content, true);
  posix::synchronize((path_ / name).parent_path());
  posix::synchronize(path_);
}

void RunFolder::append(const std::string &name, const std::string &content) const
{
  posix::append(path_ / name, content);
  not_on_disk_.insert(name);
}

std::string RunFolder::read(const std::string &name) const
{
  return posix::read(path_ / name);
}

bool RunFolder::has(const std::string &name) const
{
  std::error_code code;
  return fs::exists(path_ / name, code);
}

void RunFolder::remove(const std::string &name) const
{
  std::error_code code;
  fs::remove(path_ / name, code);
  if (code)
    fail(path_ / name, "cannot be removed", code.message());
}

std::map<std::string, std::uintmax_t> RunFolder::table_sizes() const
{
  std::map<std::string, std::uintmax_t> sizes;
  for (const std::string &name : tables(path_))
    sizes[name] = fs::file_size(path_ / name);
  return sizes;
}

void RunFolder::require_tables(const std::map<std::string, std::uintmax_t> &sizes) const
{
  const auto present = table_sizes();
  for (const auto &[name, size] : sizes)
    if (const auto found = present.find(name); found == present.end() || found->second < size)
      fail(path_ / name, "cannot be continued",
           found == present.end() ? "it is missing" : "it is shorter than when the checkpoint was written");
    else if (size > 0 && read(name)[size - 1] != '\n')
      fail(path_ / name, "cannot be continued", "it was changed since the checkpoint was written");
}

void RunFolder::cut_tables(const std::map<std::string, std::uintmax_t> &sizes) const
{
  require_tables(sizes);
  for (const auto &[name, size] : table_sizes())
    if (const auto kept = sizes.find(name); kept == sizes.end())
      remove(name);
    else
      posix::cut(path_ / name, kept->second);
}

std::string RunFolder::path(const std::string &name) const
{
  return name.empty() ? path_.string() : (path_ / name).string();
}
} // namespace orthocone
