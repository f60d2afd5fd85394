// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "commands.h"

#include "launch.h"
#include "shareable.h"

#include <orthocone/base/memory.h>
#include <orthocone/base/message.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/output/step_problem.h>

#include <iostream>
#include <string>

namespace orthocone
{
int fail(const ExitCode code, const std::string &message)
{
  leave_word_to_first_rank();
  std::cerr << shown_message("orthocone: " + message) +
                   "\n"; // in one piece, or words of mpirun may get in between
  return static_cast<int>(code);
}

ModelChoice resolve(const CommandLine &line, const Parameters &parameters)
{
  try
  {
    check_parameters(parameters);
    const ModelChoice choice = choose_model(parameters);
    require_shareable(parameters, choice);
    require_writable_problems(parameters, choice.symmetry);
    require_refined_cells(parameters.geometry, parameters.mesh, choice.symmetry);
    return choice;
  }
  catch (const InputError &error)
  {
    throw InputError(shown_path(line.parameter_file) + ": " + error.what());
  }
  catch (const TooLargeError &error)
  {
    throw InputError(shown_path(line.parameter_file) + ": " + error.what());
  }
}
} // namespace orthocone
