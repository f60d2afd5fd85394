// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "material_checks.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/parameters/gmsh_file.h>

#include <cmath>
#include <set>

namespace orthocone
{
namespace
{
/// Requires the leading minors of the compliance, each times the moduli of its axes, to be positive
/// (docs/theory.md, section 2, "Materials").
void check_orthotropic(const MaterialOptions &material)
{
  const auto &[e_x, e_y, e_z] = material.young_moduli;
  const auto &[nu_xy, nu_xz, nu_yz] = material.poisson_ratios;
  const double xy = nu_xy * nu_xy * e_y / e_x, xz = nu_xz * nu_xz * e_z / e_x, yz = nu_yz * nu_yz * e_z / e_y;
  const double all = 1 - xy - xz - yz - 2 * nu_xy * nu_yz * nu_xz * e_z / e_x;
  if (xy < 1 && xz < 1 && yz < 1 && all > 0)
    return;
  const std::string ratios = to_text(nu_xy) + ", " + to_text(nu_xz) + ", " + to_text(nu_yz);
  throw InputError("Material/Poisson ratios = " + ratios +
                   " with these Young moduli do not store energy under every strain: allowed are |nu_xy| < "
                   "sqrt(E_x/E_y) = " +
                   to_text(std::sqrt(e_x / e_y)) +
                   ", |nu_xz| < sqrt(E_x/E_z) = " + to_text(std::sqrt(e_x / e_z)) +
                   ", |nu_yz| < sqrt(E_y/E_z) = " + to_text(std::sqrt(e_y / e_z)) +
                   " and 1 - nu_xy^2 E_y/E_x - nu_xz^2 E_z/E_x - nu_yz^2 E_z/E_y - 2 nu_xy nu_yz nu_xz "
                   "E_z/E_x > 0");
}

void check_regions(const Parameters &parameters)
{
  const GeometryOptions &geometry = parameters.geometry;
  if (parameters.material.regions.empty())
    return;
  if (!geometry.is_from_file())
    throw InputError("Material/Regions is set without a mesh file: allowed is nothing, or Geometry/Shape = "
                     "file, whose physical volumes they name");
  const GmshFile file = read_gmsh_file(geometry.mesh_file);
  std::set<const PhysicalGroup *> seen;
  FaultList faults;
  for (const MaterialRegion &region : parameters.material.regions)
  {
    const PhysicalGroup *const group = file.find(3, region.volume);
    const std::string given = "'" + shown(region.volume) + "' ";
    if (group == nullptr || group->n_elements == 0)
      faults.add(given + (group == nullptr ? "is no physical volume" : "has no cells"));
    else if (!seen.insert(group).second)
      faults.add(given + "is a volume that stands there before, by its name or its number");
  }
  faults.throw_if_any("Material/Regions: ",
                      ": allowed in " + file.path + " are " + file.list(3) + ", each once");
}
} // namespace

void check_material(const Parameters &parameters)
{
  if (parameters.material.is_orthotropic())
    check_orthotropic(parameters.material);
  check_regions(parameters);
}
} // namespace orthocone
