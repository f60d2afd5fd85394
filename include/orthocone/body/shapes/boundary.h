// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/types.h>

#include <set>

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
  axis = 6,            ///< of a section
  further_contact = 7, ///< of the second contact surface; the others follow in their order
  end_of_contact = 16, ///< behind the last one
  first_support = 16,  ///< of Geometry/Supports; the others follow in their order
};

constexpr unsigned int most_contact_surfaces = 1 + Boundary::end_of_contact - Boundary::further_contact;

inline dealii::types::boundary_id contact_boundary(const unsigned int surface)
{
  return surface == 0 ? dealii::types::boundary_id(Boundary::contact_surface)
                      : static_cast<dealii::types::boundary_id>(Boundary::further_contact + surface - 1);
}

inline bool is_contact(const dealii::types::boundary_id id)
{
  return id == Boundary::contact_surface ||
         (id >= Boundary::further_contact && id < Boundary::end_of_contact);
}

inline std::set<dealii::types::boundary_id> contact_boundaries()
{
  std::set<dealii::types::boundary_id> all;
  for (unsigned int surface = 0; surface < most_contact_surfaces; ++surface)
    all.insert(contact_boundary(surface));
  return all;
}

/// The number of a contact surface by its boundary id.
inline unsigned int contact_number(const dealii::types::boundary_id id)
{
  return id == Boundary::contact_surface ? 0 : id - Boundary::further_contact + 1;
}
} // namespace orthocone
