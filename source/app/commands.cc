// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "commands.h"

#include "launch.h"
#include "shareable.h"

#include <orthocone/base/memory.h>
#include <orthocone/base/message.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/output/step_problem.h>

#include <iostream>
#include <string>

namespace orthocone
{
int fail(const Ending &ending)
{
  leave_word_to_first_rank();
  std::cerr << shown_message("orthocone: " + ending.message) +
                   "\n"; // in one piece, or words of mpirun may get in between
  return static_cast<int>(ending.code);
}

ModelChoice resolve(const CommandLine &line, const Parameters &parameters)
{
  return naming_file(line,
                     [&]
                     {
                       check_parameters(parameters);
                       const ModelChoice choice = choose_model(parameters);
                       require_shareable(parameters, choice);
                       require_writable_problems(parameters, choice.symmetry);
                       require_refined_cells(parameters.geometry, parameters.mesh, choice.symmetry);
                       return choice;
                     });
}
} // namespace orthocone
