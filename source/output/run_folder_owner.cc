// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "posix_file.h"
#include "run_files.h"
#include "run_folder_names.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/output/run_folder.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>
#include <system_error>

namespace orthocone
{
namespace fs = std::filesystem;

namespace
{
/// The mark of a run's folder: a name and a first line that nobody else writes. `parameters.prm` would not
/// do, as users of deal.II call their own files so.
constexpr const char *marker = "orthocone-run.txt";
constexpr const char *marker_line = "orthocone run folder: parameter file and tables of probes";
constexpr const char *identity = "parameters.prm";
constexpr const char *checkpoint_folder = "checkpoint";
constexpr const char *checkpoint_file = "checkpoint/state";
constexpr const char *checkpoint_start = "orthocone-checkpoint ";
} // namespace

namespace run_folder
{
void fail(const fs::path &file, const std::string &task, const std::string &cause)
{
  throw FileError(shown_path(file.string()) + ": " + task + " (" + cause + ")");
}

std::vector<std::string> names_in(const fs::path &folder)
{
  std::vector<std::string> names;
  if (fs::is_directory(folder))
    for (const auto &entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace
{
/// The folders below which only the system writes (Filesystem Hierarchy Standard).
bool is_of_system(const std::string &top)
{
  static const std::set<std::string> names{"bin",   "boot",   "dev",  "etc",  "lib", "lib32",
                                           "lib64", "libx32", "proc", "sbin", "sys", "usr"};
  return names.count(top) > 0;
}
} // namespace

void require_not_of_system(const fs::path &folder)
{
  std::error_code code;
  fs::path place = fs::weakly_canonical(folder, code);
  if (code)
    place = fs::absolute(folder, code).lexically_normal();
  const fs::path inner = place.relative_path();
  const auto refuse = [&](const char *const why)
  { fail(folder, "cannot be the run folder", std::string(why) + "; --output DIR takes another one"); };
  if (inner.empty())
    refuse("it is the root of the file system");
  const auto depth = std::distance(inner.begin(), inner.end());
  const bool is_shared_memory = depth > 2 && *inner.begin() == "dev" && *std::next(inner.begin()) == "shm";
  if (is_of_system(inner.begin()->string()) && !is_shared_memory)
    refuse("it belongs to the system");
  if (depth == 1 && !names_in(place).empty() && !fs::exists(fs::symlink_status(place / marker, code)))
    refuse("it is a folder for everybody, contains other files, and no run has marked it");
}
} // namespace run_folder

using run_folder::fail;
using run_folder::FileKind;
using run_folder::names_in;
using run_folder::run_file;
using run_folder::RunFile;

namespace
{
bool is_of_kind(const std::string &name, const FileKind kind)
{
  const RunFile *const file = run_file(name);
  return file != nullptr && file->kind == kind;
}

bool begins_with(const std::string &text, const char *const beginning)
{
  return text.compare(0, std::strlen(beginning), beginning) == 0;
}

/// Whether a file is of one of the lines among named_files(), which has the name "line-NAME-#.csv" there.
bool is_of_a_line(const std::string &name, const std::vector<std::string> &named)
{
  const std::string whole = run_folder::without_part(name);
  return std::any_of(named.begin(), named.end(),
                     [&](const std::string &line)
                     {
                       return begins_with(line, "line-") && line.find('*') == std::string::npos &&
                              RunFile{line.c_str(), FileKind::line_file, ""}.fits(whole);
                     });
}

std::string with_line_ends(const std::vector<std::string> &lines)
{
  std::string text;
  for (const std::string &line : lines)
    text += line + "\n";
  return text;
}
} // namespace

bool RunFolder::is_of_a_run() const
{
  // Runs of earlier versions left no marker, but a checkpoint.
  const auto starts_with = [&](const char *const name, const std::string &beginning)
  { return has(name) && posix::head(place_of(name), beginning.size()) == beginning; };
  return starts_with(marker, marker_line) || starts_with(checkpoint_file, checkpoint_start);
}

/// The marker's lines behind its first one: the parameter file, and named_files().
std::vector<std::string> RunFolder::marked_lines() const
{
  std::vector<std::string> lines;
  if (has(marker))
    lines = split(read(marker), '\n');
  if (!lines.empty())
    lines.erase(lines.begin());
  return lines;
}

void RunFolder::mark(const std::string &parameter_file, const std::vector<std::string> &named)
{
  if (is_nowhere())
    return;
  std::vector<std::string> lines{marker_line, parameter_file};
  lines.insert(lines.end(), named.begin(), named.end());
  if (const std::string text = with_line_ends(lines); !has(marker) || read(marker) != text)
    replace(marker, text, false);
}

/// Names of the tables of the folder's run.
std::vector<std::string> RunFolder::own_tables() const
{
  std::vector<std::string> names = run_folder::fixed_names(FileKind::table);
  const std::vector<std::string> others = has(marker) ? marked_lines() : names_in(path_);
  std::copy_if(others.begin(), others.end(), std::back_inserter(names),
               [](const std::string &name)
               { return is_of_kind(name, FileKind::probe_table) && run_file(name)->fits(name); });
  return names;
}

/// Names of the files of lines that the folder's run has left, also of those that are half written.
std::set<std::string> RunFolder::own_line_files() const
{
  const std::vector<std::string> marked = marked_lines();
  std::set<std::string> own;
  for (const std::string &name : names_in(path_))
    if (is_of_kind(name, FileKind::line_file) && is_of_a_line(name, marked))
      own.insert(name);
  return own;
}

/// All files that the folder's run has left. The checkpoint is the first one, because it is useless without
/// the others.
std::vector<std::string> RunFolder::files() const
{
  std::vector<std::string> names;
  for (const std::string &entry : names_in(path_ / checkpoint_folder))
    if (const std::string name = std::string(checkpoint_folder) + "/" + entry;
        is_of_kind(name, FileKind::checkpoint))
      names.push_back(name);
  for (const std::string &table : own_tables())
    for (const std::string &name : {table, table + ".part"})
      if (fs::exists(fs::symlink_status(place_of(name))))
        names.push_back(name);
  for (const std::string &name : names_in(path_))
    if (is_of_kind(name, FileKind::file))
      names.push_back(name);
  const std::set<std::string> of_lines = own_line_files();
  names.insert(names.end(), of_lines.begin(), of_lines.end());
  return names;
}

void RunFolder::require_own(const std::vector<std::string> &named) const
{
  if (is_nowhere())
    return;
  std::vector<std::string> foreign;
  const bool is_own = is_of_a_run();
  if (!is_own)
    foreign = files();
  if (const auto status = fs::symlink_status(path_ / checkpoint_folder);
      fs::exists(status) && !fs::is_directory(status))
    foreign.emplace_back(checkpoint_folder);
  if (foreign.empty() && has(marker) && !is_own)
    foreign.emplace_back(marker);
  const std::vector<std::string> own = own_tables();
  for (const std::string &table : named)
    if (has(table) && std::find(own.begin(), own.end(), table) == own.end())
      foreign.push_back(table);
  const std::set<std::string> of_lines = own_line_files();
  for (const std::string &name : names_in(path_))
    if (is_of_a_line(name, named) && of_lines.count(name) == 0)
      foreign.push_back(name);
  if (!foreign.empty())
    fail(path_, "cannot be the run folder",
         "it holds a " + foreign.front() + ", and no run has left it there; --output DIR takes another one");
}

std::optional<std::string> RunFolder::start_anew(const std::string &parameters,
                                                 const std::string &parameter_file,
                                                 const std::vector<std::string> &named)
{
  if (is_nowhere())
    return std::nullopt;
  require_own(named);
  const std::vector<std::string> old = files();
  // Before anything is removed, everything must be removable, and there must be room for the new parameters.
  for (const std::string &file : old)
    if (fs::is_directory(fs::symlink_status(place_of(file))))
      fail(path_ / file, "cannot be replaced", "a folder of this name is in its place");
  const std::vector<std::string> before = marked_lines();
  if (!has(marker))
    replace(marker, std::string(marker_line) + "\n", false);
  const fs::path part = write_part(identity, parameters, false);
  for (const std::string &name : old)
    if (begins_with(name, checkpoint_folder))
      remove(name);
  // From here on the folder belongs to the new run, which has no checkpoint yet.
  posix::rename(part, place_of(identity));
  for (const std::string &name : old)
    if (name != identity)
      remove(name);
  mark(parameter_file, named);
  growing_.clear();
  const bool is_other = !before.empty() && !before.front().empty() && before.front() != parameter_file;
  return is_other ? std::optional<std::string>(before.front()) : std::nullopt;
}
} // namespace orthocone
