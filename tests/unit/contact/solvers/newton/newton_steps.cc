// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The maps of the Newton solvers, which are no public headers.
#include "contact/solvers/newton/newton_steps.h"
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// The state of one node on a way, its status there, and the map's error.
struct OnTheWay
{
  Index n_unknowns;
  double error;
};

/// Halves the way from force `a` to force `b` of one node until its status changes between neighbours.
double jump_between(const ContactStep &step, Map *const map, const NodeVector &displacement, Vector3d a,
                    Vector3d b)
{
  const auto at = [&](const Vector3d &force)
  {
    NodeVector forces = NodeVector::Zero(displacement.size());
    forces.head<3>() = force;
    const Linearization linearization = map(step, forces, displacement, 1);
    return OnTheWay{linearization.conditions.nodes[0].n_unknowns, linearization.error};
  };
  OnTheWay at_a = at(a), at_b = at(b);
  EXPECT_NE(at_a.n_unknowns, at_b.n_unknowns);
  for (unsigned int i = 0; i < 50; ++i)
  {
    const Vector3d middle = (a + b) / 2;
    const OnTheWay at_middle = at(middle);
    (at_middle.n_unknowns == at_a.n_unknowns ? a : b) = middle;
    (at_middle.n_unknowns == at_a.n_unknowns ? at_a : at_b) = at_middle;
  }
  return std::abs(at_b.error - at_a.error);
}
} // namespace

/// From stick to slip in all directions, and from slip to no contact. A line search could not cross a jump.
TEST(LineSearch, MapsAreContinuousWhereNodesChangeTheirStatus)
{
  for (Map *const map : {linearize, linearize_on_elliptic_cone})
    for (const OrthotropicFriction &law : case_laws)
    {
      const GridProblem grid(law);
      NodeVector displacement = grid.zero();
      displacement.head<3>() << 0, 2e-3, -1e-3;
      for (const double angle : {0.3, 1.2, 2., 4., 5.5})
      {
        const Vector3d slipping(1, 3 * law.mu_x * std::cos(angle), 3 * law.mu_y * std::sin(angle));
        const Vector3d open = slipping - 20 * Vector3d::UnitX();
        EXPECT_LT(jump_between(grid.problem, map, displacement, Vector3d::UnitX(), slipping), 1e-12);
        EXPECT_LT(jump_between(grid.problem, map, displacement, slipping, open), 1e-12);
      }
    }
}
} // namespace orthocone::test
