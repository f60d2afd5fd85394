// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/asymmetry.h>

#include <orthocone/parameters/values.h>
#include <orthocone/scene/first_contact.h>
#include <orthocone/scene/friction_field.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/obstacle.h>

namespace orthocone
{
namespace
{
/// Why the body or its cells are not as symmetric as a model; empty if they are.
std::string of_shape(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  const bool is_box = parameters.geometry.shape == BodyShape::box;
  if (symmetry.is_axisymmetric())
    return is_box ? "Geometry/Shape = " + to_word(parameters.geometry.shape) + " is no body of revolution"
                  : "";
  const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
  const unsigned int n = is_box ? parameters.mesh.cells[direction] : parameters.mesh.core_cells;
  if (n % 2 == 0)
    return {};
  return is_box ? "Mesh/Cells has an odd number along " + std::string(direction == 0 ? "x" : "y") + ", " +
                      std::to_string(n)
                : "Mesh/Core cells = " + std::to_string(n) + " is odd";
}

std::string of_load(const LoadOptions &load, const ModelSymmetry &symmetry)
{
  constexpr unsigned int first_rotation = 3;
  for (unsigned int component = 0; component < n_rigid_components; ++component)
    if (drives(load, component) && !symmetry.leaves(component))
      return std::string("the load program ") +
             (component < first_rotation ? "moves the top along " : "turns the top about ") +
             "xyz"[component % first_rotation];
  return {};
}

/// Isotropic and the same everywhere, the material is as symmetric as the shape.
std::string first_of(const Parameters &parameters, const FrictionField &friction, const Obstacle &obstacle,
                     const SurfaceSample &sample, const ModelSymmetry &symmetry)
{
  if (std::string why = of_shape(parameters, symmetry); !why.empty())
    return why;
  if (std::string why = friction.asymmetry(symmetry, sample); !why.empty())
    return why;
  if (std::string why = obstacle.asymmetry(symmetry, sample); !why.empty())
    return why;
  return of_load(parameters.load, symmetry);
}
} // namespace

std::string Asymmetry::of_planes() const
{
  const auto &[x, y] = about_planes;
  return x.empty() || x == y ? y : y.empty() ? x : x + " and " + y;
}

Asymmetry asymmetry_of(const Parameters &parameters)
{
  const FrictionField friction(parameters.friction);
  const auto obstacle = make_obstacle(parameters.obstacle);
  SurfaceSample sample;
  if (varies_over_surface(parameters))
  {
    sample = surface_sample(parameters);
    friction.check(sample.places);
    obstacle->check(sample.places);
    require_contact_before_force(parameters, *obstacle, sample.places);
  }
  const auto why = [&](const ModelSymmetry &symmetry)
  { return first_of(parameters, friction, *obstacle, sample, symmetry); };
  return {{{why(SymmetryPlanes{true, false}), why(SymmetryPlanes{false, true})}},
          why(ModelSymmetry::of_revolution())};
}
} // namespace orthocone
