// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/lower_body.h>

#include "material_checks.h"
#include "shape_checks.h"

#include <orthocone/base/text.h>

#include <array>

namespace orthocone
{
Parameters lower_parameters(const Parameters &parameters)
{
  Parameters lower = parameters;
  lower.geometry = parameters.lower.geometry;
  lower.mesh = parameters.lower.mesh;
  lower.mesh.backend = BodyBackend::condensed;
  lower.material = parameters.lower.material;
  lower.lower = {};
  lower.obstacle = {};
  lower.output.probes.clear();
  return lower;
}

std::string with_lower_sections(const std::string &sentence)
{
  static const std::array<std::pair<std::string, std::string>, 3> names{
      {{"Geometry/", "Lower geometry/"}, {"Mesh/", "Lower mesh/"}, {"Material/", "Lower material/"}}};
  std::string changed = sentence;
  for (const auto &[name, of_lower] : names)
    for (std::size_t at = changed.find(name); at != std::string::npos;
         at = changed.find(name, at + of_lower.size()))
      changed.replace(at, name.size(), of_lower);
  return changed;
}

namespace
{
/// Refuses refinement by what a run finds, which knows one body only.
void check_one_mesh(const MeshOptions &mesh)
{
  const std::string with = " with Obstacle/Kind = body: allowed is ";
  if (mesh.accuracy != 0)
    throw InputError("Mesh/Accuracy = " + to_text(mesh.accuracy) + " %" + with +
                     "0; the search refines one body alone");
  if (mesh.adaptive != 0)
    throw InputError("Mesh/Adaptive = " + std::to_string(mesh.adaptive) + with +
                     "0; cells are halved in one body alone (Mesh/Refinements halves all)");
  if (!mesh.refined_cells.empty())
    throw InputError("Mesh/Refined cells is set" + with +
                     "nothing; faces of both bodies are joined without hanging nodes");
}
} // namespace

void check_lower_body(const Parameters &parameters)
{
  constexpr unsigned int most_of_solids = 3;
  if (parameters.obstacle.kind != ObstacleKind::body)
    return;
  check_one_mesh(parameters.mesh);
  const Parameters lower = lower_parameters(parameters);
  if (lower.mesh.degree > most_of_solids)
    throw InputError("Lower mesh/Degree = " + std::to_string(lower.mesh.degree) +
                     ": allowed is a whole number from 1 to 3");
  of_lower_body(
      [&]
      {
        check_quadrature(lower.mesh);
        check_shape(lower);
        check_material(lower);
      });
}
} // namespace orthocone
