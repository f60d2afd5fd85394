// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "refined_body.h"

#include "multigrid/counterface_conditions.h"
#include "multigrid/counterface_sum.h"

#include <orthocone/body/node_compliance.h>
#include <orthocone/surface/hierarchical_half_space.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// A body on a half-space so many times as stiff, with and without dense matrices.
struct BodyOnHalfSpace
{
  BodyOnHalfSpace(const MeshOptions &mesh, const SymmetryPlanes &planes, const double stiffness,
                  const double angle = 0)
      : refined(default_geometry, mesh, planes, LocalAxes(angle)),
        body(refined.body.condensed.frame(), refined.stiffness, const_cast<VCycle &>(refined.cycle),
             node_compliance(surface(), planes, default_material), 1e-12),
        half_space({stiffness * default_material.young_modulus, 0.3}, surface(), planes, LocalAxes(angle)),
        sum(body, half_space),
        dense(half_space_compliance({stiffness * default_material.young_modulus, 0.3}, surface(), planes,
                                    LocalAxes(angle)) +
              *refined.body.condensed.compliance().dense())
  {
  }

  const ContactSurface &surface() const { return refined.body.discretization.contact_surface(); }

  RefinedBody refined;
  MultigridCompliance body;
  HierarchicalHalfSpace half_space;
  CounterfaceSum sum;
  DenseCompliance dense;
};
} // namespace

TEST(CounterfaceSum, IsTheSumOfBothMatrices)
{
  const BodyOnHalfSpace both(even_mesh(2, 1), quarter, 2, 90);
  const auto &frame = both.refined.body.condensed.frame();
  NodeVector force = random_numbers(3 * both.sum.n_nodes(), 3);
  for (std::size_t i = 0; i < frame.nodes().size(); ++i) // none where symmetry holds a direction
    for (unsigned int d = 0; d < 3; ++d)
      if (const Eigen::Vector3d held = frame.global_in_local(i).row(d); !frame.nodes()[i].is_free[d])
        force.segment<3>(3 * static_cast<Index>(i)) -=
            held * held.dot(force.segment<3>(3 * static_cast<Index>(i)));
  NodeVector moved, expected;
  both.sum.vmult(moved, force);
  both.dense.vmult(expected, force);
  EXPECT_LE((moved - expected).norm(), 1e-9 * expected.norm());
  EXPECT_GE(both.sum.softness(), 0.99 * both.dense.softness());
  const ContactChange held = both.sum.held_at(both.body.body_displacement(force));
  EXPECT_LE((held.force - force).norm(), 1e-8 * force.norm());
  EXPECT_LE((held.displacement - expected).norm(), 1e-8 * expected.norm());
}

// A hundred times softer, as stiff, and ten thousand times stiffer than the body.
TEST(CounterfaceConditions, SolvesWhatNodesAskFor)
{
  for (const double stiffness : {0.01, 1., 1e4})
    for (const double angle : {0., 30.})
    {
      const BodyOnHalfSpace both(angle == 0 ? even_mesh(1, 1) : even_mesh(2, 0), full, stiffness, angle);
      const ContactConditions conditions{mixed_conditions(both.refined, node_stiffness), MatrixXd(),
                                         VectorXd()};
      const auto solver = both.sum.condition_solver(both.sum.softness());
      EXPECT_LE(error_of(conditions, solver->solve(conditions, 1e-10), both.dense), 1e-7) << stiffness;
    }
}

TEST(CounterfaceConditions, MovesAFaceThatForcesDrive)
{
  const BodyOnHalfSpace both(even_mesh(2, 0), full, 1);
  const auto &frame = both.refined.body.condensed.frame();
  ContactConditions conditions{mixed_conditions(both.refined, node_stiffness), MatrixXd(), VectorXd(2)};
  conditions.face.resize(3 * both.sum.n_nodes(), 2);
  conditions.face << frame.moved_with(moved_by(1, 0, 0)).normalized(),
      frame.moved_with(moved_by(0, 0, 1)).normalized();
  conditions.face_right_side << 3, -2;
  conditions.face_stiffness = 10 * MatrixXd::Identity(2, 2);
  const ContactChange change = both.sum.condition_solver(both.sum.softness())->solve(conditions, 1e-10);
  EXPECT_LE(error_of(conditions, change, both.dense), 1e-7);
  EXPECT_LE((conditions.face.transpose() * change.force - conditions.face_stiffness * change.face -
             conditions.face_right_side)
                .norm(),
            1e-9);
}

/// What the body lacked before, it no longer lacks.
TEST(CounterfaceConditions, RestoresEquilibrium)
{
  const BodyOnHalfSpace both(even_mesh(2, 1), quarter, 1);
  ContactConditions conditions{mixed_conditions(both.refined, node_stiffness), MatrixXd(), VectorXd()};
  conditions.residual = random_numbers(both.refined.body.discretization.n_free(), 11);
  const ContactChange change = both.sum.condition_solver(both.sum.softness())->solve(conditions, 1e-8);
  EXPECT_LE((conditions.residual + change.body.residual).norm(), 1e-6 * conditions.residual.norm());
  const VectorXd forces = both.refined.body.condensed.frame().on_free_unknowns(change.force);
  EXPECT_LE(
      (forces - both.refined.body.stiffness.vmult(change.body.displacement) - change.body.residual).norm(),
      1e-9 * forces.norm());
}
} // namespace orthocone::test
