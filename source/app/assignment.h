// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"
#include "thread_chooser.h"

#include <orthocone/output/run_folder.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/model_choice.h>

#include <filesystem>
#include <iostream>
#include <string>

namespace orthocone
{
/// The task of a run, and its messages before it has a log.
struct Assignment
{
  const CommandLine &line;
  const ParameterFile &file;
  const ModelChoice model;
  ThreadChooser threads;
  std::string lines{}; ///< for log.txt, which begins when the run is known to begin

  void report(const std::string &text)
  {
    lines += text + "\n";
    if (!line.quiet)
      std::cout << text << std::endl;
  }
};

/// Path of the parameter file, which distinguishes it from others of the same name.
std::string path_of(const CommandLine &line);

/// The folder of the results.
std::filesystem::path run_folder_of(const CommandLine &line);

/// Throws InputError, with the name of the parameter file, where a lower body is not under all of the upper
/// one: require_cover().
void require_bodies_that_meet(const CommandLine &line, const Parameters &parameters,
                              const ModelSymmetry &symmetry);

/// Writes the parameters into the run folder: as the user wrote them, and complete. Throws FileError.
void keep_parameters(const RunFolder &folder, Assignment &task, const Parameters &parameters);

/// The same for a run that goes on, perhaps with more cycles, probes or fields than it began with.
void update_parameters(const RunFolder &folder, const Assignment &task, const Parameters &parameters);
} // namespace orthocone
