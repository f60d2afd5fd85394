// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "run_files.h"

#include <algorithm>

namespace orthocone::run_folder
{
namespace
{
constexpr const char *placeholders = "*#";

/// Whether a text may be a part of a plain name: nothing in it leads to another folder, or ends the name for
/// the system.
bool is_plain(const std::string &text)
{
  return text.find('/') == std::string::npos && text.find('\0') == std::string::npos;
}

bool is_step_number(const std::string &text)
{
  constexpr std::size_t least_digits = 4;
  constexpr std::size_t most_digits = 9;
  return text.size() >= least_digits && text.size() <= most_digits &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

/// The part of a name in place of the first placeholder of a pattern, or of the step behind a "*"; nothing
/// where the rest differs.
std::optional<std::string> filled_in(const std::string &pattern, const std::string &name)
{
  const std::size_t place = pattern.find_first_of(placeholders);
  const std::string before = pattern.substr(0, place);
  const std::string after = pattern.substr(place + 1);
  if (pattern[place] == '*' && after.find_first_of(placeholders) != std::string::npos)
  {
    const std::size_t dash = name.rfind(after.front());
    const bool fits = dash != std::string::npos && dash > place && name.compare(0, place, before) == 0 &&
                      is_plain(name.substr(place, dash - place));
    return fits ? filled_in(after, name.substr(dash)) : std::nullopt;
  }
  if (after.find_first_of(placeholders) != std::string::npos)
  {
    const std::size_t end = name.find_first_not_of("0123456789", place);
    const auto process = end == std::string::npos ? std::nullopt : filled_in(after, name.substr(end));
    const bool fits = name.compare(0, place, before) == 0 && process && !process->empty() &&
                      process->find_first_not_of("0123456789") == std::string::npos;
    return fits ? std::optional(name.substr(place, end - place)) : std::nullopt;
  }
  if (name.size() < before.size() + after.size() || name.compare(0, before.size(), before) != 0 ||
      name.compare(name.size() - after.size(), after.size(), after) != 0)
    return std::nullopt;
  return name.substr(before.size(), name.size() - before.size() - after.size());
}

bool has_placeholder(const std::string &pattern)
{
  return pattern.find_first_of(placeholders) != std::string::npos;
}

} // namespace

std::string without_part(const std::string &name)
{
  const std::string part = ".part";
  const bool is_part =
      name.size() > part.size() && name.compare(name.size() - part.size(), part.size(), part) == 0;
  return is_part ? name.substr(0, name.size() - part.size()) : name;
}

const std::vector<RunFile> &run_files()
{
  constexpr std::uintmax_t gigabyte = 1000000000;
  static const std::vector<RunFile> files{
      {"orthocone-run.txt", FileKind::marker, "marks the folder, names parameter file and tables of probes"},
      {"checkpoint/state", FileKind::checkpoint, "the state from which --resume goes on", 4 * gigabyte},
      {"checks.csv", FileKind::table, "results of the checks of each step"},
      {"cycles.csv", FileKind::table, "one row for each cycle"},
      {"history.csv", FileKind::table, "one row a step"},
      {"timing.csv", FileKind::table, "seconds of each step"},
      {"probe-*.csv", FileKind::probe_table, "one row for each step, of one contact node"},
      {"line-*-#.csv", FileKind::line_file, "fields along a line after a step, one row for each point"},
      {"contact.pvd", FileKind::file, "names the files of the contact surface"},
      {"contact-#.vtu", FileKind::file, "fields on the contact surface"},
      {"volume.pvd", FileKind::file, "names the files of the volume"},
      {"volume-#.vtu", FileKind::file, "fields of the modelled part"},
      {"volume-#.pvtu", FileKind::file, "names the pieces that several processes have written"},
      {"volume-#.*.vtu", FileKind::file, "fields of the part of a process"},
      {"lower.pvd", FileKind::file, "names the files of the lower body"},
      {"lower-#.vtu", FileKind::file, "fields of the lower body"},
      {"problem-#.hdf5", FileKind::file, "the contact problem of a step, and its solution if it was found"},
      {"input.prm", FileKind::file, "the parameter file as given"},
      {"input.json", FileKind::file, "the parameter file as given"},
      {"parameters.prm", FileKind::file, "all values used"},
      {"log.txt", FileKind::file, "what the screen shows"},
      {"summary.json", FileKind::file, "times, peaks, warnings, versions"},
      {"report.html", FileKind::file, "made by tools/report.py"}};
  return files;
}

bool RunFile::fits(const std::string &name) const
{
  if (!has_placeholder(pattern))
    return name == pattern;
  const std::optional<std::string> text = filled_in(pattern, name);
  return text && is_plain(*text) &&
         (std::string(pattern).find('#') == std::string::npos || is_step_number(*text));
}

const RunFile *run_file(const std::string &name)
{
  const std::vector<RunFile> &files = run_files();
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const RunFile &file) { return file.fits(without_part(name)); });
  return found == files.end() ? nullptr : &*found;
}

std::vector<std::string> fixed_names(const FileKind kind)
{
  std::vector<std::string> names;
  for (const RunFile &file : run_files())
    if (file.kind == kind && !has_placeholder(file.pattern))
      names.emplace_back(file.pattern);
  return names;
}

std::optional<unsigned long> step_of(const std::string &name)
{
  for (const RunFile &file : run_files())
    if (std::string(file.pattern).find('#') != std::string::npos && file.fits(name))
      return std::stoul(*filled_in(file.pattern, name));
  return std::nullopt;
}
} // namespace orthocone::run_folder
