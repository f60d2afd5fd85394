// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/asymmetry.h>

#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/parameters/lower_body.h>
#include <orthocone/parameters/values.h>
#include <orthocone/scene/first_contact.h>
#include <orthocone/scene/friction_field.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/obstacle.h>

namespace orthocone
{
namespace
{
/// Why the body or its cells do not have the symmetry of a model; empty if they do.
std::string of_shape(const Parameters &parameters, const SymmetryPlanes &of_file,
                     const ModelSymmetry &symmetry)
{
  const bool is_box = parameters.geometry.shape == BodyShape::box;
  if (symmetry.is_axisymmetric())
    return parameters.geometry.shape == BodyShape::cylinder
               ? ""
               : "Geometry/Shape = " + to_word(parameters.geometry.shape) + " is no body of revolution";
  const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
  if (parameters.geometry.is_from_file())
    return (direction == 0 ? of_file.normal_to_x : of_file.normal_to_y)
               ? ""
               : std::string("Geometry/Symmetry surfaces has none in ") + "xy"[direction] + " = 0";
  const unsigned int n = is_box ? parameters.mesh.cells[direction] : parameters.mesh.core_cells;
  if (n % 2 == 0)
    return {};
  return is_box ? "Mesh/Cells has an odd number along " + std::string(direction == 0 ? "x" : "y") + ", " +
                      std::to_string(n)
                : "Mesh/Core cells = " + std::to_string(n) + " is odd";
}

/// Whether a force drives the held face along z, which must not begin to press before there is contact.
bool has_forces(const LoadOptions &load)
{
  constexpr unsigned int normal = 2;
  return is_driven_by_force(load, normal);
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

/// Why the material does not have the symmetry of a model. The axes of an orthotropic material are x, y and
/// z, and a file mirrors its regions.
std::string of_material(const MaterialOptions &material, const ModelSymmetry &symmetry)
{
  return symmetry.is_axisymmetric() && material.is_orthotropic()
             ? "Material/Law = orthotropic has axes along x and y"
             : "";
}

/// Why the lower body does not have the symmetry of a model; empty if it does, or if there is none.
std::string of_lower(const Parameters &parameters, const SymmetryPlanes &of_file,
                     const ModelSymmetry &symmetry)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return {};
  if (symmetry.is_axisymmetric())
    return "Obstacle/Kind = body has no section (r, z)";
  return with_lower_sections(of_shape(lower_parameters(parameters), of_file, symmetry));
}

SymmetryPlanes planes_of_file(const GeometryOptions &geometry)
{
  return geometry.is_from_file() ? ImportedMesh(geometry).planes() : SymmetryPlanes();
}

SymmetryPlanes planes_of_lower_file(const Parameters &parameters)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return {};
  return of_lower_body([&] { return planes_of_file(parameters.lower.geometry); });
}

std::string first_of(const Parameters &parameters, const FrictionField &friction, const Obstacle &obstacle,
                     const SurfaceSample &sample, const ModelSymmetry &symmetry)
{
  if (std::string why = of_material(parameters.material, symmetry); !why.empty())
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
  const SymmetryPlanes of_file = planes_of_file(parameters.geometry);
  const SymmetryPlanes of_lower_file = planes_of_lower_file(parameters);
  SurfaceSample sample;
  if (varies_over_surface(parameters) || (parameters.geometry.is_from_file() && has_forces(parameters.load)))
  {
    sample = surface_sample(parameters);
    friction.check(sample.places);
    obstacle->check(sample.places);
    require_contact_before_force(parameters, *obstacle, sample);
  }
  const auto why = [&](const ModelSymmetry &symmetry)
  {
    std::string of_body = of_shape(parameters, of_file, symmetry);
    if (of_body.empty())
      of_body = of_lower(parameters, of_lower_file, symmetry);
    return of_body.empty() ? first_of(parameters, friction, *obstacle, sample, symmetry) : of_body;
  };
  return {{{why(SymmetryPlanes{true, false}), why(SymmetryPlanes{false, true})}},
          why(ModelSymmetry::of_revolution()),
          of_file,
          of_lower_file};
}
} // namespace orthocone
