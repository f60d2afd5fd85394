// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "commands.h"

#include "launch.h"

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/output/checkpoint.h>
#include <orthocone/output/step_problem.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/first_contact.h>
#include <orthocone/scene/line_points.h>
#include <orthocone/scene/lower_body.h>
#include <orthocone/scene/model_choice.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>

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

void require_bodies_that_meet(const CommandLine &line, const Parameters &parameters,
                              const ModelSymmetry &symmetry)
{
  naming_file(line,
              [&]
              {
                require_hold(parameters, symmetry);
                require_cover(parameters, symmetry);
                require_bodies_side_by_side(parameters, symmetry);
                require_fitting_surface(parameters, symmetry);
                require_lines_inside(parameters, symmetry);
              });
}

void require_file_for_all(const std::string &path)
{
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (n_ranks() > 1 && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(shown_path(path) + ": is no regular file: allowed with " + std::to_string(n_ranks()) +
                     " processes is a file that all of them can read");
}

void require_same_for_all(const CommandLine &line, const Parameters &parameters)
{
  if (n_ranks() == 1)
    return;
  std::ostringstream of_this_rank;
  write_parameters(parameters, of_this_rank);
  of_this_rank << input_files_checksum(parameters) << line.output_folder << line.threads << line.check
               << line.resume << line.insist;
  if (any_rank(of_this_rank.str() != of_first_rank(of_this_rank.str())))
    throw InputError(shown_path(line.parameter_file) + ": not all of the " + std::to_string(n_ranks()) +
                     " processes have the same entries and options: allowed is one command for all");
}

void require_shareable(const Parameters &parameters, const ModelChoice &model)
{
  if (n_ranks() == 1)
    return;
  const auto refuse = [](const std::string &entry, const std::string &value, const std::string &allowed)
  {
    throw InputError(entry + " = " + value + " with " + std::to_string(n_ranks()) +
                     " processes: allowed is " + allowed + ", or one process");
  };
  const std::string found = " (one process writes the result of its search to parameters.prm)";
  if (!kind_of(parameters.geometry).is_meshed())
    throw InputError(parameters.geometry.shape_entry() + " with " + std::to_string(n_ranks()) +
                     " processes: allowed is one process, because they share meshes only");
  if (parameters.mesh.accuracy != 0)
    refuse("Mesh/Accuracy", to_text(parameters.mesh.accuracy), "0" + found);
  if (parameters.load.accuracy != 0)
    refuse("Load program/Accuracy", to_text(parameters.load.accuracy), "0" + found);
  if (parameters.mesh.backend == BodyBackend::condensed)
    refuse("Mesh/Backend", "condensed", "multigrid");
  if (model.symmetry.is_plane_strain())
    refuse("Geometry/Kind", "plane strain",
           "solid (processes share multigrid only, which solves no sections)");
  if (model.symmetry.is_axisymmetric())
    refuse("Mesh/Model", model.symmetry.name(),
           "full, half or quarter (processes share multigrid only, which solves no sections)");
  if (parameters.mesh.backend == BodyBackend::automatic && !multigrid_can(parameters, model.symmetry))
    refuse("Mesh/Backend", "auto",
           "a scene that multigrid can compute, with Contact solver/Method = newton, one isotropic material, "
           "Obstacle/Kind = rigid and Output/Problems = 0");
}
} // namespace orthocone
