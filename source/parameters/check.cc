// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "material_checks.h"
#include "shape_checks.h"
#include "solver_entries.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/parameters/computed_steps.h>
#include <orthocone/parameters/gap_file.h>
#include <orthocone/parameters/lower_body.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/values.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
/// The first mesh entry that was set although a resolution or an accuracy chooses it, or "".
std::string changed_mesh_entry(const MeshOptions &mesh)
{
  Parameters given;
  given.mesh = mesh;
  const auto values = entry_values(given);
  const auto defaults = entry_values(Parameters());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto &[entry, value] = values[i];
    const bool is_free = entry == "Mesh/Model" || entry == "Mesh/Resolution" || entry == "Mesh/Accuracy" ||
                         entry == "Mesh/Volumetric quadrature" || entry == "Mesh/Backend";
    if (!is_free && value != defaults[i].second)
      return entry + " = " + shown(value) + " is set beside it: allowed is " +
             (defaults[i].second.empty() ? "nothing" : "the default " + defaults[i].second);
  }
  return {};
}

/// Requires one choice of the mesh at a time: an accuracy, a resolution, or the single entries.
void check_mesh_choice(const MeshOptions &mesh)
{
  const bool is_custom = mesh.resolution == MeshResolution::custom;
  if (mesh.accuracy != 0 && !is_custom)
    throw InputError("Mesh/Accuracy = " + to_text(mesh.accuracy) +
                     " % with Mesh/Resolution = " + to_word(mesh.resolution) +
                     ": allowed is one of them; an accuracy chooses the mesh by itself");
  if (const std::string entry = changed_mesh_entry(mesh);
      !entry.empty() && (mesh.accuracy != 0 || !is_custom))
    throw InputError((is_custom ? "Mesh/Accuracy = " + to_text(mesh.accuracy) + " %"
                                : "Mesh/Resolution = " + to_word(mesh.resolution)) +
                     " chooses the mesh, but " + entry + ", or " +
                     (is_custom ? "Accuracy = 0" : "Resolution = custom"));
}

/// Refuses what a body without a dense compliance cannot do.
void check_backend(const Parameters &parameters)
{
  if (parameters.mesh.backend != BodyBackend::multigrid)
    return;
  const std::string method = parameters.contact_solver.method;
  if (entries::is_method_for_dense(method))
    throw InputError(
        "Contact solver/Method = " + method +
        " needs a dense compliance, and Mesh/Backend = multigrid has none: allowed is newton, or "
        "Backend = condensed");
  if (parameters.obstacle.kind != ObstacleKind::rigid)
    throw InputError("Obstacle/Kind = " + to_word(parameters.obstacle.kind) +
                     " with Mesh/Backend = multigrid: what is below is no part of "
                     "the body that its cycles solve; allowed is auto or condensed, or Kind = rigid");
  if (!parameters.material.is_uniform_and_isotropic())
    throw InputError((parameters.material.is_orthotropic()
                          ? "Material/Law = orthotropic"
                          : "Material/Regions = " + entries::regions_text(parameters.material.regions)) +
                     " with Mesh/Backend = multigrid, whose products have one pair of Lame's constants: "
                     "allowed is Backend = condensed");
}

/// All digits of a number of steps.
std::string counted(const double n)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << n;
  return text.str();
}

/// Bounds what is computed, and what is counted: cycles that may be jumped are not computed.
void check_number_of_steps(const LoadOptions &load, const WearOptions &wear)
{
  LoadOptions all = load;
  all.jump_when_periodic = 0;
  const double n_all = least_computed_parts(all, WearOptions{}), n_least = least_computed_parts(load, wear);
  if (n_least <= most_solved_parts && n_all <= most_counted_parts)
    return;
  const auto has_parts = [](const std::vector<Leg> &legs)
  { return std::any_of(legs.begin(), legs.end(), [](const Leg &leg) { return leg.parts > 1; }); };
  const std::string unit =
      has_parts(load.preload) || has_parts(load.legs) ? " parts of load steps" : " load steps";
  const std::string made = "Load program: Preload, Legs and Cycles = " + std::to_string(load.cycles) +
                           " make " + counted(n_all) + unit;
  if (!may_jump(load, wear))
    throw InputError(made + ": allowed are 1000000");
  if (n_least <= most_solved_parts)
    throw InputError(made + ": allowed are 4000000000 where cycles are jumped");
  throw InputError(made + ", of which at least " + counted(n_least) +
                   " are computed however many cycles are jumped: allowed are 1000000 computed ones");
}

void check_load(const LoadOptions &load, const WearOptions &wear)
{
  if (load.preload.empty() && load.legs.empty())
    throw InputError(
        "Load program/Legs is empty and Load program/Preload is empty: allowed is at least one leg, "
        "such as '0 0 -0.1 : 5'");
  if (load.preload.empty() && load.cycles == 0)
    throw InputError(
        "Load program/Cycles = 0 and Load program/Preload is empty: allowed is at least one cycle or "
        "a preload");
  check_number_of_steps(load, wear);
  if (load.stop_when_periodic > 0 && load.jump_when_periodic > 0)
    throw InputError("Load program/Stop when periodic = " + to_text(load.stop_when_periodic) +
                     " and Load program/Jump when periodic = " + to_text(load.jump_when_periodic) +
                     ": allowed is one of them, the other 0 (a run that stops has nothing to jump)");
}

void check_wear(const WearOptions &wear, const LoadOptions &load)
{
  if (wear.law == WearKind::none)
    return;
  if (wear.coefficient == 0)
    throw InputError("Wear/Coefficient = 0 with Wear/Law = " + to_word(wear.law) +
                     ": allowed is a number > 0, in mm^3/(N mm) = 1/MPa, or Law = none");
  for (const auto &[entry, value] : {std::pair("Stop when periodic", load.stop_when_periodic),
                                     std::pair("Jump when periodic", load.jump_when_periodic)})
    if (value > 0)
      throw InputError(std::string("Load program/") + entry + " = " + to_text(value) +
                       " with Wear/Law = " + to_word(wear.law) +
                       ": allowed is 0, because no cycle of a surface that wears ends as "
                       "it began (Wear/Largest depth of a jump jumps cycles)");
}

void check_compression(const LoadOptions &load, const GeometryOptions &geometry)
{
  if (geometry.is_from_file())
    return; // the mesh does not exist yet
  for (const auto *const legs : {&load.preload, &load.legs})
    for (const Leg &leg : *legs)
      if (const auto u_z = leg.motion(2); u_z && *u_z <= -geometry.held_height())
        throw InputError(std::string("Load program/") + (legs == &load.legs ? "Legs" : "Preload") +
                         ": u_z = " + to_text(*u_z) + " mm presses the body flat: allowed is more than -" +
                         height_entry(geometry) + " = " + to_text(-geometry.held_height()) + " mm");
}

void check_obstacle(const ObstacleOptions &obstacle)
{
  if (!obstacle.gap_file.empty())
    read_gap_file(obstacle.gap_file);
}
} // namespace

void check_parameters(const Parameters &parameters)
{
  check_mesh_choice_of_shape(parameters);
  check_mesh_choice(parameters.mesh);
  check_quadrature(parameters.mesh);
  check_backend(parameters);
  check_load(parameters.load, parameters.wear);
  check_wear(parameters.wear, parameters.load);
  check_compression(parameters.load, parameters.geometry);
  check_shape(parameters);
  check_material(parameters);
  check_lower_body(parameters);
  check_obstacle(parameters.obstacle);
}
} // namespace orthocone
