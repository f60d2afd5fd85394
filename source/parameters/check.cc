// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/text.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
/// Thickness of the thinnest of `n` intervals, each `grading` times as thick as the one before, relative to
/// all.
double thinnest(const unsigned int n, const double grading)
{
  double sum = 0;
  double thickness = 1;
  double least = 1;
  for (unsigned int i = 0; i < n; ++i, thickness *= grading)
  {
    sum += thickness;
    least = std::min(least, thickness);
  }
  return least / sum;
}

void check_mesh(const MeshOptions &mesh)
{
  constexpr double least_thickness = 1e-6;
  if (mesh.n_quadrature_points() <= mesh.degree)
    throw InputError(
        "Mesh/Quadrature points = " + std::to_string(mesh.quadrature_points) +
        ": with Mesh/Degree = " + std::to_string(mesh.degree) +
        " allowed is 0 or more than the degree (fewer points leave deformations without stiffness)");
  if (thinnest(mesh.n_rings(), mesh.rim_grading) < least_thickness)
    throw InputError("Mesh/Rim grading = " + to_text(mesh.rim_grading) + " with " +
                     std::to_string(mesh.n_rings()) +
                     " rings: allowed is what leaves every ring 1e-6 of their common thickness");
  if (thinnest((mesh.layers + 1) / 2, mesh.layer_grading) < least_thickness)
    throw InputError("Mesh/Layer grading = " + to_text(mesh.layer_grading) + " with " +
                     std::to_string(mesh.layers) +
                     " layers: allowed is what leaves every layer 1e-6 of the height");
}

/// The first mesh entry that a resolution or an accuracy would choose, but that was set beside it; or "".
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
                         entry == "Mesh/Volumetric quadrature";
    if (!is_free && value != defaults[i].second)
      return entry + " = " + value + " is set beside it: allowed is the default " + defaults[i].second;
  }
  return {};
}

/// One choice of the mesh at a time: an accuracy, a resolution, or the single entries.
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

void check_load(const LoadOptions &load)
{
  constexpr double most_steps = 1e6;
  if (load.preload.empty() && load.legs.empty())
    throw InputError(
        "Load program/Legs is empty and Load program/Preload is empty: allowed is at least one leg, "
        "such as '0 0 -0.1 : 5'");
  if (load.preload.empty() && load.cycles == 0)
    throw InputError(
        "Load program/Cycles = 0 and Load program/Preload is empty: allowed is at least one cycle or "
        "a preload");
  double n_steps = 0;
  for (const Leg &leg : load.preload)
    n_steps += leg.steps;
  for (const Leg &leg : load.legs)
    n_steps += static_cast<double>(load.cycles) * leg.steps;
  if (n_steps > most_steps)
    throw InputError("Load program: Preload, Legs and Cycles = " + std::to_string(load.cycles) + " make " +
                     to_text(n_steps) + " load steps: allowed are 1000000");
  if (load.stop_when_periodic > 0 && load.jump_when_periodic > 0)
    throw InputError("Load program/Stop when periodic = " + to_text(load.stop_when_periodic) +
                     " and Load program/Jump when periodic = " + to_text(load.jump_when_periodic) +
                     ": allowed is one of them, the other 0 (a run that stops has nothing to jump)");
}

void check_compression(const LoadOptions &load, const double height)
{
  for (const auto *const legs : {&load.preload, &load.legs})
    for (const Leg &leg : *legs)
      if (leg.target[2] <= -height)
        throw InputError(
            std::string("Load program/") + (legs == &load.legs ? "Legs" : "Preload") +
            ": u_z = " + to_text(leg.target[2]) +
            " mm presses the body flat: allowed is more than -Geometry/Height = " + to_text(-height) + " mm");
}

void check_probes(const std::vector<Probe> &probes, const double radius)
{
  constexpr double rounding = 1e-12;
  for (const Probe &probe : probes)
    if (std::hypot(probe.position[0], probe.position[1]) > (1 + rounding) * radius)
      throw InputError("Output/Probes: '" + probe.name + "' at (" + to_text(probe.position[0]) + ", " +
                       to_text(probe.position[1]) +
                       ") is off the contact surface: allowed are points within " +
                       "Geometry/Radius = " + to_text(radius) + " of the axis");
}
} // namespace

void check_parameters(const Parameters &parameters)
{
  check_mesh_choice(parameters.mesh);
  check_mesh(parameters.mesh);
  check_load(parameters.load);
  check_compression(parameters.load, parameters.geometry.height);
  check_probes(parameters.output.probes, parameters.geometry.radius);
}
} // namespace orthocone
