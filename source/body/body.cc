// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/body.h>

namespace orthocone
{
Body::Shape Body::shape_of(const BodyOptions &options, const ModelSymmetry &symmetry)
{
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
  return std::visit([](const auto &shape) -> const BodyUnknowns & { return shape.discretization; }, shape_);
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
  return std::visit([](const auto &shape) { return shape.mesh.cell_numbers(); }, shape_);
}

void Body::make_pattern(dealii::SparsityPattern &pattern) const
{
  std::visit([&](const auto &shape) { make_stiffness_pattern(shape.discretization, pattern); }, shape_);
}

Stiffness Body::stiffness(const Materials &materials) const
{
  // A stiffness cannot be moved, which std::visit might do.
  if (const auto *const solid = std::get_if<Solid>(&shape_))
    return Stiffness(solid->discretization, materials);
  return Stiffness(std::get<Section>(shape_).discretization, materials);
}
} // namespace orthocone
