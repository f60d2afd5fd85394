// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/body.h>

#include <orthocone/body/shapes/shape_kind.h>

namespace orthocone
{
Body::Shape Body::shape_of(const BodyOptions &options, const ModelSymmetry &symmetry)
{
  if (!kind_of(options.geometry).is_meshed())
    return Shape(std::in_place_type<GridSurface>, options.geometry, options.mesh);
  if (symmetry.is_section())
    return Shape(std::in_place_type<Section>, options, symmetry);
  return Shape(std::in_place_type<Solid>, options, symmetry);
}

Body::Body(const BodyOptions &options, const ModelSymmetry &symmetry)
    : materials_(options),
      shape_(shape_of(options, symmetry))
{
}

const BodyUnknowns &Body::unknowns() const
{
  if (const auto *const surface = std::get_if<GridSurface>(&shape_))
    return *surface;
  return *visit([](const auto &space) -> const BodyUnknowns * { return &space; });
}

unsigned int Body::n_levels() const
{
  return visit([](const auto &space) { return space.dof_handler().get_triangulation().n_global_levels(); });
}

double Body::stretch() const
{
  return visit([](const auto &space) { return orthocone::stretch(space.dof_handler().get_triangulation()); });
}

std::vector<unsigned int> Body::cell_numbers() const
{
  if (const auto *const solid = std::get_if<Solid>(&shape_))
    return solid->mesh.cell_numbers();
  return section().mesh.cell_numbers();
}

void Body::make_pattern(dealii::SparsityPattern &pattern) const
{
  visit([&](const auto &space) { make_stiffness_pattern(space, pattern); });
}

Stiffness Body::stiffness(const Materials &materials) const
{
  // A stiffness cannot be moved, which std::visit might do.
  if (const auto *const solid = std::get_if<Solid>(&shape_))
    return Stiffness(solid->discretization, materials);
  return Stiffness(section().discretization, materials);
}
} // namespace orthocone
