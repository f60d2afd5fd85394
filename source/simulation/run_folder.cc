// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_folder.h>

#include "posix_file.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <algorithm>
#include <cstring>
#include <regex>
#include <vector>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// Tells a folder of a run from others: a name and a first line that nobody else writes. `parameters.prm`
/// would not do, as users of deal.II call their own files so.
constexpr const char *marker = "orthocone-run.txt";
constexpr const char *marker_line = "orthocone run folder, made by the parameter file\n";
constexpr const char *identity = "parameters.prm";
constexpr const char *checkpoint_folder = "checkpoint";
constexpr const char *table_names = "probe-.*\\.csv|(history|timing|checks|cycles)\\.csv";

bool begins_with(const std::string &text, const char *const beginning)
{
  return text.compare(0, std::strlen(beginning), beginning) == 0;
}

[[noreturn]] void fail(const fs::path &file, const std::string &task, const std::string &cause)
{
  throw FileError(shown_path(file.string()) + ": " + task + " (" + cause + ")");
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
           std::string("((contact|volume)(-\\d{4,9}\\.vtu|\\.pvd)|summary\\.json|(input|parameters)\\.prm|"
                       "input\\.json|log\\.txt|report\\.html|") +
               table_names + ")(\\.part)?"))
    names.push_back(name);
  return names;
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

bool RunFolder::is_of_a_run() const
{
  // Runs of earlier versions left no marker, but a checkpoint.
  return (has(marker) && begins_with(read(marker), marker_line)) ||
         (has("checkpoint/state") && begins_with(read("checkpoint/state"), "orthocone-checkpoint "));
}

std::optional<std::string> RunFolder::marked_parameter_file() const
{
  if (!has(marker))
    return std::nullopt;
  const std::string text = read(marker);
  const std::size_t first = std::min(text.size(), std::strlen(marker_line));
  return text.substr(first, text.find('\n', first) - first);
}

void RunFolder::require_own() const
{
  const std::vector<std::string> files = files_of_a_run(path_);
  if ((!files.empty() || has(marker)) && !is_of_a_run())
    fail(path_, "cannot be the run folder",
         "it holds a " + (files.empty() ? marker : files.front()) +
             ", and no run has left it there; --output DIR takes another one");
}

std::optional<std::string> RunFolder::start_anew(const std::string &parameters,
                                                 const std::string &parameter_file) const
{
  require_own();
  const std::vector<std::string> files = files_of_a_run(path_);
  // Before anything is removed, everything must be removable, and there must be room for the new parameters.
  for (const std::string &file : files)
    if (fs::is_directory(path_ / file))
      fail(path_ / file, "cannot be replaced", "a folder of this name is in its place");
  const auto before = marked_parameter_file();
  if (!has(marker))
    replace(marker, marker_line, false);
  const fs::path part = write_part(identity, parameters, false);
  replace(marker, marker_line + parameter_file + "\n", false);
  for (const std::string &name : files)
    if (begins_with(name, checkpoint_folder))
      remove(name);
  // From here on the folder is that of the new run, which has not come to a checkpoint yet.
  posix::rename(part, path_ / identity);
  for (const std::string &name : files)
    if (name != identity)
      remove(name);
  growing_.clear();
  return before && !before->empty() && *before != parameter_file ? before : std::nullopt;
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
  auto known = growing_.find(name);
  if (known == growing_.end())
  {
    // Where a run goes on, log.txt is there.
    const auto size = posix::append(path_ / name, content, std::nullopt);
    known = growing_.emplace(name, Growing()).first;
    known->second.size = size;
  }
  else
    known->second.size = posix::append(path_ / name, content, known->second.size);
  known->second.crc.process_bytes(content.data(), content.size());
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

bool RunFolder::ends_with(const std::string &name, const std::string &end) const
{
  return posix::tail(path_ / name, end.size()) == end;
}

void RunFolder::remove(const std::string &name) const
{
  std::error_code code;
  fs::remove(path_ / name, code);
  if (code)
    fail(path_ / name, "cannot be removed", code.message());
}

TableMarks RunFolder::tables() const
{
  const std::regex expression(table_names);
  TableMarks marks;
  for (const auto &[name, file] : growing_)
    if (std::regex_match(name, expression))
      marks[name] = {file.size, file.crc.checksum()};
  return marks;
}

void RunFolder::require_tables(const TableMarks &marks) const
{
  for (const auto &[name, mark] : marks)
  {
    if (!has(name))
      fail(path_ / name, "cannot be continued", "it is missing");
    const std::string content = read(name);
    if (content.size() < mark.size)
      fail(path_ / name, "cannot be continued", "it is shorter than when the checkpoint was written");
    boost::crc_32_type crc;
    crc.process_bytes(content.data(), mark.size);
    if (crc.checksum() != mark.checksum)
      fail(path_ / name, "cannot be continued", "it was changed since the checkpoint was written");
    growing_[name] = {mark.size, crc};
  }
}

void RunFolder::cut_tables(const TableMarks &marks) const
{
  require_tables(marks);
  for (const std::string &name : matching(path_, table_names))
    if (const auto kept = marks.find(name); kept == marks.end())
    {
      remove(name);
      growing_.erase(name);
    }
    else
      posix::cut(path_ / name, kept->second.size);
}

std::string RunFolder::path(const std::string &name) const
{
  return shown_path(name.empty() ? path_.string() : (path_ / name).string());
}
} // namespace orthocone
