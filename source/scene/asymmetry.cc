// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/asymmetry.h>

#include <orthocone/body/materials/material.h>
#include <orthocone/body/shapes/shape.h>
#include <orthocone/scene/first_contact.h>
#include <orthocone/scene/friction_field.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/obstacle.h>

#include <algorithm>
#include <initializer_list>
#include <memory>

namespace orthocone
{
namespace
{
/// The shape of the lower body; null if there is none.
std::unique_ptr<Shape> lower_shape(const Parameters &parameters)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return nullptr;
  return make_shape(parameters.lower.geometry, parameters.lower.mesh);
}

/// The same as Shape::asymmetry() of the lower body; empty if there is none.
std::string asymmetry_of_lower(const Shape *const lower, const ModelSymmetry &symmetry)
{
  if (lower == nullptr)
    return {};
  return symmetry.is_axisymmetric() ? "Obstacle/Kind = body has no section (r, z)"
                                    : lower->asymmetry(symmetry);
}

/// Where fields are compared, or nothing where none varies and no force presses.
SurfaceSample checked_sample(const Parameters &parameters, const FrictionField &friction,
                             const Obstacle &obstacle)
{
  constexpr unsigned int normal = 2;
  const std::vector<Load> &loads = parameters.load.loads;
  const bool has_interference =
      std::any_of(loads.begin(), loads.end(), [](const Load &load) { return load.kind->drives_overlap(); });
  if (!varies_over_surface(parameters) && !LoadProgram(parameters.load).is_driven_by_force(normal) &&
      !has_interference)
    return {};
  SurfaceSample sample = surface_sample(parameters);
  friction.check(sample.points);
  obstacle.check(sample.points);
  require_driven_overlap(parameters, obstacle, sample.points);
  require_contact_before_force(parameters, obstacle, sample);
  return sample;
}

std::string first_of(const std::initializer_list<std::string> reasons)
{
  for (const std::string &reason : reasons)
    if (!reason.empty())
      return reason;
  return {};
}
} // namespace

std::string Asymmetry::of_planes() const
{
  const auto &[x, y] = about_planes;
  return x.empty() || x == y ? y : y.empty() ? x : x + " and " + y;
}

Asymmetry asymmetry_of(const Parameters &parameters)
{
  const auto shape = make_shape(parameters.geometry, parameters.mesh);
  const auto lower = lower_shape(parameters);
  const Material material(parameters.material), lower_material(parameters.lower.material);
  const FrictionField friction(parameters.friction);
  const auto obstacle = make_obstacle(parameters.obstacle);
  const LoadProgram program(parameters.load);
  const SurfaceSample sample = checked_sample(parameters, friction, *obstacle);
  const auto why = [&](const ModelSymmetry &symmetry)
  {
    return first_of({shape->asymmetry(symmetry), asymmetry_of_lower(lower.get(), symmetry),
                     material.asymmetry(symmetry), lower ? lower_material.asymmetry(symmetry) : "",
                     friction.asymmetry(symmetry, sample, *obstacle), obstacle->asymmetry(symmetry, sample),
                     program.asymmetry(symmetry)});
  };
  const SymmetryPlanes of_file = shape->own_planes(),
                       of_lower_file = lower ? lower->own_planes() : SymmetryPlanes();
  if (parameters.geometry.is_plane_strain())
    return {{{why(plane_strain(parameters, true, true)), ""}},
            "Geometry/Kind = plane strain",
            why(plane_strain(parameters, true)),
            why(plane_strain(parameters, false)),
            of_file,
            of_lower_file};
  const bool may_twist = parameters.geometry.top_face != TopFace::guided; // which holds no twist
  return {{{why(SymmetryPlanes{true, false}), why(SymmetryPlanes{false, true})}},
          why(ModelSymmetry::of_revolution(may_twist)),
          "Geometry/Kind = solid",
          why(ModelSymmetry::of_revolution()),
          of_file,
          of_lower_file};
}
} // namespace orthocone
