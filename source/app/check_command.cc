// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "check_command.h"

#include "commands.h"
#include "scene_picture.h"

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/cost_text.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/output/model_text.h>
#include <orthocone/output/scene_description.h>
#include <orthocone/scene/computed_steps.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/mesh_files.h>
#include <orthocone/scene/model_advice.h>

#include <cmath>
#include <iostream>

namespace orthocone
{
namespace
{
void print_warnings(const Parameters &parameters, const ModelChoice &model, const std::string &lack)
{
  for (const std::string &warning : scene_warnings(parameters, model.symmetry))
    std::cout << "warning: " << warning << "\n";
  for (const std::string &warning : parameter_warnings(parameters))
    std::cout << "warning: " << warning << "\n";
  if (!lack.empty())
    std::cout << "warning: " << lack << "\n";
  if (!std::cout.flush())
    throw FileError("standard output: cannot be written");
}

/// Prints the model without its mesh, which a search will choose as a part of the run.
void print_unknown_mesh(const Parameters &parameters, const ModelChoice &model)
{
  std::cout << describe_model(model) << "mesh           is chosen by the run, for errors of "
            << to_text(parameters.mesh.accuracy) << " %"
            << (parameters.mesh.accuracy_of == all_quantities
                    ? ""
                    : " of " + counted_text(parameters.mesh.accuracy_of))
            << "\n"
            << describe_materials(parameters) << describe_friction(parameters)
            << describe_obstacle(parameters) << describe_held(parameters) << describe_steps(parameters.load);
  print_warnings(parameters, model, "");
}

/// Says that the memory is too small for the model, and whether a factorization cannot count it: then a
/// bigger machine would not help.
std::string why_too_large(const CostModel &costs, const std::string &lack)
{
  try
  {
    costs.require_countable();
  }
  catch (const TooLargeError &error)
  {
    return lack.empty() ? error.what() : lack + "\nwarning: " + error.what();
  }
  return lack;
}

ComputedSteps computed_steps(const Parameters &parameters)
{
  return {least_computed_parts(parameters.load, parameters.wear),
          LoadProgram(parameters.load).n_solved_parts()};
}

/// Prints a model whose mesh has so many unknowns that making it takes too long for a check.
void print_large_model(const Parameters &parameters, const ModelChoice &model, const CostModel &costs)
{
  const MemoryLimit limit = memory_limit();
  const bool is_condensed = parameters.mesh.backend != BodyBackend::multigrid;
  const Estimate cost = is_condensed ? costs.least() : costs.multigrid();
  std::cout << describe_model(model) << describe(costs.size()) << "\n"
            << describe_materials(parameters) << describe_friction(parameters)
            << describe_obstacle(parameters) << describe_held(parameters) << describe_steps(parameters.load)
            << describe(cost, computed_steps(parameters), limit, is_condensed) << "\n";
  const std::string lack = lack_of_memory(cost.gigabytes, limit);
  print_warnings(parameters, model, is_condensed ? why_too_large(costs, lack) : lack);
}

/// Compares the contact that is to be expected with the nodes there.
void print_expected_contact(const Parameters &parameters, const ModelChoice &model, const Body &body)
{
  constexpr double least_nodes = 4; // docs/accuracy.md, "Zones that the mesh does not resolve"
  const auto expected = expected_contact(parameters);
  if (!expected)
    return;
  const double across = nodes_across(*expected, body.unknowns().contact_surface(), model.symmetry);
  std::cout << "contact        " << describe(*expected) << ", about " << std::round(across)
            << (std::round(across) == 1 ? " node across\n" : " nodes across\n");
  const std::string advice = model.symmetry.is_section() ? "" : half_space_advice(parameters, *expected);
  if (!advice.empty())
    std::cout << "simpler model  " << advice << "\n";
  if (across < least_nodes)
    std::cout
        << "warning: Mesh: the contact to be expected has " << std::round(across)
        << " nodes across, and four are the least; pressure, slip and dissipation may be wrong by tens of "
           "percent: take "
        << kind_of(parameters.geometry).finer_cells(parameters) << "\n";
}

void print_lower_mesh(const Parameters &parameters, const ModelChoice &model)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return;
  const Body lower(parameters.lower, model.symmetry);
  std::cout << describe_lower_mesh(parameters, lower.unknowns()) << "\n";
}

void print_model(const Parameters &parameters, const ModelChoice &model, const CostModel &costs)
{
  const ComputedSteps n_steps = computed_steps(parameters);
  const MemoryLimit limit = memory_limit();
  const Body body(parameters, model.symmetry);
  std::cout << describe_model(parameters, model, body.unknowns()) << "\n";
  print_lower_mesh(parameters, model);
  print_expected_contact(parameters, model, body);
  try
  {
    const Estimate cost =
        parameters.mesh.backend == BodyBackend::multigrid ? costs.multigrid() : costs.condensed(body);
    std::cout << describe(cost, n_steps, limit, false) << "\n";
    print_warnings(parameters, model, lack_of_memory(cost.gigabytes, limit));
  }
  catch (const TooLargeError &error)
  {
    std::cout << describe(costs.least(), n_steps, limit, true) << "\n";
    print_warnings(parameters, model, error.what());
  }
}
void require_one_process(const CommandLine &line)
{
  if (!line.picture.empty() && n_ranks() > 1)
    throw InputError("command line: --picture = " + shown_path(line.picture) + " with " +
                     std::to_string(n_ranks()) + " processes: allowed is one process");
}

/// Draws the scene, after what is printed of it.
void draw(const CommandLine &line, const Parameters &parameters, const ModelChoice &model,
          const bool has_mesh)
{
  draw_scene(scene_description(parameters, model, has_mesh), line.parameter_file, line.picture);
  std::cout << "picture        " << shown_path(line.picture) << "\n" << std::flush;
}
} // namespace

int check(const CommandLine &line, const Parameters &given)
{
  constexpr double largest_meshed = 1e6; // unknowns
  require_one_process(line);
  const ModelChoice model = resolve(line, given);
  Parameters parameters = given;
  if (given.mesh.accuracy == 0)
    parameters.mesh = resolved_mesh(given, model.symmetry.is_axisymmetric());
  const BackendChoice backend = given.mesh.accuracy == 0
                                    ? choose_backend(parameters, model.symmetry, memory_limit().gigabytes)
                                    : BackendChoice{parameters.mesh.backend};
  parameters.mesh.backend = backend.backend;
  if (!backend.reason.empty())
    std::cout << backend.reason << "\n";
  std::cout << describe_mesh_files(parameters);
  if (parameters.mesh.adaptive != 0)
    std::cout << "adaptive       " << parameters.mesh.adaptive
              << " rounds of refinement by the run; the lines below describe the mesh before them\n";
  const CostModel costs(parameters, model.symmetry);
  if (costs.size().dofs <= largest_meshed)
    require_bodies_that_meet(line, parameters, model.symmetry);
  if (given.mesh.accuracy != 0)
    print_unknown_mesh(given, model);
  else if (costs.size().dofs > largest_meshed)
    print_large_model(parameters, model, costs);
  else
    print_model(parameters, model, costs);
  if (!line.picture.empty())
    draw(line, parameters, model, given.mesh.accuracy == 0 && costs.size().dofs <= largest_meshed);
  return static_cast<int>(ExitCode::done);
}
} // namespace orthocone
