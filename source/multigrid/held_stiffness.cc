// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "held_stiffness.h"

#include "node_values.h"

namespace orthocone
{
void HeldStiffness::add_displacement(Vector &displacement, const Vector &free) const
{
  displacement += free;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_here() && relations_[i].hold == Hold::normal)
      displacement.local_element(nodes_[i].dofs[2]) -= relations_[i].follows.dot(tangential(free, nodes_[i]));
}

void HeldStiffness::vmult(Vector &result, const Vector &free) const
{
  Vector displacement = stiffness_.make_vector();
  add_displacement(displacement, free);
  stiffness_.vmult(result, displacement);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_here() && relations_[i].hold == Hold::normal)
      add_tangential<double>(result, nodes_[i], relations_[i].robin * tangential(free, nodes_[i]));
  test(result);
}

/// Turns forces into the left sides of the relations' equations.
void HeldStiffness::test(Vector &forces) const
{
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_here() && relations_[i].hold == Hold::normal)
      add_tangential<double>(forces, nodes_[i],
                             relations_[i].coupling * forces.local_element(nodes_[i].dofs[2]));
  clear_held(forces);
}

void HeldStiffness::clear_held(Vector &vector) const
{
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_here() && relations_[i].hold != Hold::nothing)
    {
      vector.local_element(nodes_[i].dofs[2]) = 0;
      if (relations_[i].hold == Hold::all)
        set_tangential<double>(vector, nodes_[i], Eigen::Vector2d::Zero());
    }
}

HeldStiffness::Vector HeldStiffness::given() const
{
  Vector displacement = stiffness_.make_vector();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_here() && relations_[i].hold != Hold::nothing)
    {
      displacement.local_element(nodes_[i].dofs[2]) = relations_[i].displacement[2];
      add_tangential<double>(displacement, nodes_[i], relations_[i].displacement.head<2>());
    }
  return displacement;
}

HeldStiffness::Vector HeldStiffness::right_side(const Vector &forces, const Eigen::VectorXd &residual) const
{
  Vector right_side = forces;
  right_side *= -1;
  for (Eigen::Index i = 0; i < residual.size(); ++i)
    right_side.local_element(i) += residual[i];
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    if (!nodes_[i].is_here())
      continue;
    add_tangential<double>(right_side, nodes_[i], relations_[i].force.head<2>());
    if (relations_[i].hold == Hold::nothing)
      right_side.local_element(nodes_[i].dofs[2]) += relations_[i].force[2];
  }
  test(right_side);
  return right_side;
}
} // namespace orthocone
