// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "posix_file.h"
#include "run_folder_names.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>
#include <orthocone/simulation/run_folder.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <regex>

namespace orthocone
{
namespace fs = std::filesystem;

namespace run_folder
{
void fail(const fs::path &file, const std::string &task, const std::string &cause)
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
} // namespace run_folder

using run_folder::fail;
using run_folder::matching;

namespace
{
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
} // namespace orthocone
