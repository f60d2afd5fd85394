// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "matrix_free_stiffness.h"

#include <orthocone/surface/contact_surface.h>

#include <Eigen/Dense>

namespace orthocone
{
/// The first n entries that this process owns.
template<typename Number>
Eigen::Map<Eigen::Matrix<Number, Eigen::Dynamic, 1>> entries(BodyVector<Number> &vector, const Eigen::Index n)
{
  return {vector.begin(), n};
}
template<typename Number>
Eigen::Map<const Eigen::Matrix<Number, Eigen::Dynamic, 1>> entries(const BodyVector<Number> &vector,
                                                                   const Eigen::Index n)
{
  return {vector.begin(), n};
}

/// Entries of a vector at the tangential degrees of freedom of a contact node; 0 where symmetry holds them.
template<typename Number>
Eigen::Matrix<Number, 2, 1> tangential(const BodyVector<Number> &vector, const ContactNode &node)
{
  return {node.is_free[0] ? vector.local_element(node.dofs[0]) : 0,
          node.is_free[1] ? vector.local_element(node.dofs[1]) : 0};
}

/// Sets these entries, except those that symmetry holds.
template<typename Number>
void set_tangential(BodyVector<Number> &vector, const ContactNode &node,
                    const Eigen::Matrix<Number, 2, 1> &value)
{
  for (unsigned int d = 0; d < 2; ++d)
    if (node.is_free[d])
      vector.local_element(node.dofs[d]) = value[d];
}

template<typename Number>
void add_tangential(BodyVector<Number> &vector, const ContactNode &node,
                    const Eigen::Matrix<Number, 2, 1> &value)
{
  set_tangential<Number>(vector, node, tangential(vector, node) + value);
}
} // namespace orthocone
