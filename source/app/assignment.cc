// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "assignment.h"

#include "commands.h"

#include <orthocone/base/text.h>
#include <orthocone/output/history.h>
#include <orthocone/scene/lower_body.h>

#include <algorithm>
#include <sstream>

namespace orthocone
{
namespace fs = std::filesystem;

namespace
{
std::string complete_text(const Parameters &parameters)
{
  std::ostringstream text;
  write_parameters(parameters, text);
  return text.str();
}

std::string input_name(const CommandLine &line)
{
  return is_json(line.parameter_file) ? "input.json" : "input.prm";
}

/// A path without detours such as a/../b, which would create the folder a.
fs::path without_detours(const fs::path &path)
{
  const auto goes_back = [](const fs::path &part, const fs::path &next)
  { return part != ".." && next == ".."; };
  if (std::adjacent_find(path.begin(), path.end(), goes_back) == path.end())
    return path;
  std::error_code code;
  const fs::path direct = fs::weakly_canonical(path, code);
  return code ? path : direct;
}
} // namespace

std::string path_of(const CommandLine &line)
{
  return shown_path(fs::absolute(line.parameter_file).lexically_normal().string());
}

fs::path run_folder_of(const CommandLine &line)
{
  if (!line.output_folder.empty())
    return without_detours(line.output_folder);
  const fs::path stem = fs::path(line.parameter_file).stem();
  return "output" / (stem == "." || stem == ".." ? fs::path(line.parameter_file).filename() : stem);
}

void require_bodies_that_meet(const CommandLine &line, const Parameters &parameters,
                              const ModelSymmetry &symmetry)
{
  naming_file(line, [&] { require_cover(parameters, symmetry); });
}

void keep_parameters(const RunFolder &folder, Assignment &task, const Parameters &parameters)
{
  const std::string path = path_of(task.line);
  if (const auto earlier =
          folder.start_anew(complete_text(parameters), path, probe_files(parameters.output.probes)))
    task.report("warning: " + folder.path() + " held the results of another file, " + *earlier +
                "; those of this run take their place (--output DIR keeps both)");
  folder.write(input_name(task.line), task.file.text);
}

void update_parameters(const RunFolder &folder, const Assignment &task, const Parameters &parameters)
{
  const std::string text = complete_text(parameters);
  if (folder.has(input_name(task.line)) && folder.has("parameters.prm") &&
      folder.read("parameters.prm") == text)
    return;
  folder.write("parameters.prm", text);
  folder.write(input_name(task.line), task.file.text);
}
} // namespace orthocone
