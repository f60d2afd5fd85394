// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/types.h>

namespace orthocone
{
/// Boundary ids of the body mesh.
enum Boundary : dealii::types::boundary_id
{
  contact_surface = 1,
  top_face = 2,
  lateral_surface = 3,
  plane_normal_to_x = 4,
  plane_normal_to_y = 5,
  axis = 6,           ///< of a section
  first_support = 16, ///< of Geometry/Supports; the others follow in their order
};
} // namespace orthocone
