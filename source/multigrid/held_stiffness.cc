// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "held_stiffness.h"

namespace orthocone
{
void HeldStiffness::add_displacement(Vector &displacement, const Vector &free) const
{
  displacement += free;
  const auto follow = [&](const std::size_t i)
  {
    const ContactNode &node = rows_.nodes[i];
    displacement.local_element(node.dofs[2]) -= rows_.relations[i].follows.dot(tangential(free, node));
  };
  rows_.for_resisting(follow);
}

// The operator is T K F + R: F makes the displacement u of the free one y (u_z = -follows . y_t), K the
// forces that the body asks of contact for it, R = robin the part of friction that grows with slip, and T the
// left sides of the equations (f_t + coupling f_z, and nothing in held rows). What is held has a zero row and
// no part in y.
void HeldStiffness::vmult(Vector &result, const Vector &free) const
{
  Vector displacement = stiffness_.make_vector();
  add_displacement(displacement, free);
  stiffness_.vmult(result, displacement);
  const auto resist = [&](const std::size_t i)
  {
    const ContactNode &node = rows_.nodes[i];
    add_tangential<double>(result, node, rows_.relations[i].robin * tangential(free, node));
  };
  rows_.for_resisting(resist);
  test(result);
}

/// Turns forces into the left sides of the relations' equations.
void HeldStiffness::test(Vector &forces) const
{
  const auto couple = [&](const std::size_t i)
  {
    const ContactNode &node = rows_.nodes[i];
    const double normal = forces.local_element(node.dofs[2]);
    add_tangential<double>(forces, node, rows_.relations[i].coupling * normal);
  };
  rows_.for_resisting(couple);
  rows_.clear_held(forces);
}

// Newton's step gives held nodes displacements that are not zero: gaps are closed, and slip goes back to
// where a node sticks. They are the inhomogeneous part of u, which stays out of the Krylov space.
HeldStiffness::Vector HeldStiffness::given() const
{
  Vector displacement = stiffness_.make_vector();
  for (std::size_t i = 0; i < rows_.nodes.size(); ++i)
    if (rows_.nodes[i].is_here() && rows_.relations[i].hold != Hold::nothing)
    {
      displacement.local_element(rows_.nodes[i].dofs[2]) = rows_.relations[i].displacement[2];
      add_tangential<double>(displacement, rows_.nodes[i], rows_.relations[i].displacement.head<2>());
    }
  return displacement;
}

// What the operator must give: the known part of friction less T of the forces that the given displacement
// asks for already, with what the body lacks of its equilibrium.
HeldStiffness::Vector HeldStiffness::right_side(const Vector &forces, const Eigen::VectorXd &residual) const
{
  Vector right_side = forces;
  right_side *= -1;
  entries(right_side, residual.size()) += residual;
  for (std::size_t i = 0; i < rows_.nodes.size(); ++i)
  {
    if (!rows_.nodes[i].is_here())
      continue;
    add_tangential<double>(right_side, rows_.nodes[i], rows_.relations[i].force.head<2>());
    if (rows_.relations[i].hold == Hold::nothing)
      right_side.local_element(rows_.nodes[i].dofs[2]) += rows_.relations[i].force[2];
  }
  test(right_side);
  return right_side;
}
} // namespace orthocone
