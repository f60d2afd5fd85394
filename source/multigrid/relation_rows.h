// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "node_relation.h"
#include "node_values.h"

#include <vector>

namespace orthocone
{
/// The relations of contact nodes on vectors of a body, for operators that know K by its products alone: an
/// assembled matrix would have its rows changed, and here a product with K is followed by what they become.
struct RelationRows
{
  const std::vector<ContactNode> &nodes;
  const std::vector<NodeRelation> &relations; ///< one for each node, or none: contact holds nothing

  /// Calls `action(i)` for the nodes of this process that are held along their normal alone. There friction
  /// resists: the rows of the tangential directions are (K u)_t + coupling (K u)_z + robin u_t.
  template<typename Action>
  void for_resisting(const Action &action) const
  {
    for (std::size_t i = 0; i < relations.size(); ++i)
      if (nodes[i].is_here() && relations[i].hold == Hold::normal)
        action(i);
  }

  /// Sets directions that are held to zero: what is in their rows is the reaction of contact.
  template<typename Number>
  void clear_held(BodyVector<Number> &vector) const
  {
    for (std::size_t i = 0; i < relations.size(); ++i)
    {
      if (!nodes[i].is_here() || relations[i].hold == Hold::nothing)
        continue;
      vector.local_element(nodes[i].dofs[2]) = 0;
      if (relations[i].hold == Hold::all)
        set_tangential<Number>(vector, nodes[i], Eigen::Matrix<Number, 2, 1>::Zero());
    }
  }
};
} // namespace orthocone
