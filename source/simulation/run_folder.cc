// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_folder.h>

#include "posix_file.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <regex>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// Tells a folder of a run from others: a name and a first line that nobody else writes. `parameters.prm`
/// would not do, as users of deal.II call their own files so.
constexpr const char *marker = "orthocone-run.txt";
constexpr const char *marker_line = "orthocone run folder: parameter file and tables of probes";
constexpr const char *identity = "parameters.prm";
constexpr const char *checkpoint_folder = "checkpoint";
constexpr const char *probe_names = "probe-.*\\.csv";
const std::vector<std::string> fixed_tables{"checks.csv", "cycles.csv", "history.csv", "timing.csv"};

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
  if (fs::is_directory(folder))
    for (const auto &entry : fs::directory_iterator(folder))
      if (const std::string name = entry.path().filename().string(); std::regex_match(name, expression))
        names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string with_line_ends(const std::vector<std::string> &lines)
{
  std::string text;
  for (const std::string &line : lines)
    text += line + "\n";
  return text;
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
  identity_ = posix::identity(path_);
}

/// A folder may be moved while a run writes there, and another one take its name.
void RunFolder::require_same_folder() const
{
  if (posix::identity(path_) != identity_)
    throw FileError(path() + ": is no longer the folder that the run has begun in; was it moved or removed?");
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

/// What the marker has behind its first line: the parameter file, and tables of probes.
std::vector<std::string> RunFolder::marked_lines() const
{
  std::vector<std::string> lines;
  if (has(marker))
    lines = split(read(marker), '\n');
  if (!lines.empty())
    lines.erase(lines.begin());
  return lines;
}

void RunFolder::mark(const std::string &parameter_file, const std::vector<std::string> &probes) const
{
  std::vector<std::string> lines{marker_line, parameter_file};
  lines.insert(lines.end(), probes.begin(), probes.end());
  if (const std::string text = with_line_ends(lines); !has(marker) || read(marker) != text)
    replace(marker, text, false);
}

/// Names that the tables of the folder's run have.
std::vector<std::string> RunFolder::own_tables() const
{
  std::vector<std::string> names = fixed_tables;
  const std::vector<std::string> probes = has(marker) ? marked_lines() : matching(path_, probe_names);
  const std::regex expression(probe_names);
  std::copy_if(probes.begin(), probes.end(), std::back_inserter(names),
               [&](const std::string &name) { return std::regex_match(name, expression); });
  return names;
}

/// All that the folder's run has left, the checkpoint first: without its other files it is worth nothing.
std::vector<std::string> RunFolder::files() const
{
  std::vector<std::string> names;
  for (const std::string &name : matching(path_ / checkpoint_folder, "state(\\.part)?"))
    names.push_back(std::string(checkpoint_folder) + "/" + name);
  for (const std::string &table : own_tables())
    for (const std::string &name : {table, table + ".part"})
      if (fs::exists(fs::symlink_status(path_ / name)))
        names.push_back(name);
  for (const std::string &name :
       matching(path_, "((contact|volume)(-\\d{4,9}\\.vtu|\\.pvd)|summary\\.json|(input|parameters)\\.prm|"
                       "input\\.json|log\\.txt|report\\.html)(\\.part)?"))
    names.push_back(name);
  return names;
}

void RunFolder::require_own(const std::vector<std::string> &probes) const
{
  std::vector<std::string> foreign;
  if (!is_of_a_run())
    foreign = files();
  if (has(checkpoint_folder) && !fs::is_directory(path_ / checkpoint_folder))
    foreign.emplace_back(checkpoint_folder);
  if (foreign.empty() && has(marker) && !is_of_a_run())
    foreign.emplace_back(marker);
  const std::vector<std::string> own = own_tables();
  for (const std::string &probe : probes)
    if (has(probe) && std::find(own.begin(), own.end(), probe) == own.end())
      foreign.push_back(probe);
  if (!foreign.empty())
    fail(path_, "cannot be the run folder",
         "it holds a " + foreign.front() + ", and no run has left it there; --output DIR takes another one");
}

std::optional<std::string> RunFolder::start_anew(const std::string &parameters,
                                                 const std::string &parameter_file,
                                                 const std::vector<std::string> &probes) const
{
  require_own(probes);
  const std::vector<std::string> old = files();
  // Before anything is removed, everything must be removable, and there must be room for the new parameters.
  for (const std::string &file : old)
    if (fs::is_directory(path_ / file))
      fail(path_ / file, "cannot be replaced", "a folder of this name is in its place");
  const std::vector<std::string> before = marked_lines();
  if (!has(marker))
    replace(marker, std::string(marker_line) + "\n", false);
  const fs::path part = write_part(identity, parameters, false);
  for (const std::string &name : old)
    if (begins_with(name, checkpoint_folder))
      remove(name);
  // From here on the folder is that of the new run, which has not come to a checkpoint yet.
  posix::rename(part, path_ / identity);
  for (const std::string &name : old)
    if (name != identity)
      remove(name);
  mark(parameter_file, probes);
  growing_.clear();
  const bool is_other = !before.empty() && !before.front().empty() && before.front() != parameter_file;
  return is_other ? std::optional<std::string>(before.front()) : std::nullopt;
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
  require_same_folder();
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
  require_same_folder();
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
  require_same_folder();
  std::error_code code;
  fs::remove(path_ / name, code);
  if (code)
    fail(path_ / name, "cannot be removed", code.message());
}

TableMarks RunFolder::tables() const
{
  TableMarks marks;
  for (const auto &[name, file] : growing_)
    if (name != "log.txt")
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
  for (const std::string &name : own_tables())
    if (const auto kept = marks.find(name); kept == marks.end())
    {
      if (has(name))
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
