// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "refined_body.h"

#include "multigrid/held_stiffness.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(WholeBodyConditions, SolvesWhatNodesAskFor)
{
  for (const auto &[angle, on_coarsest] : {std::pair{0., CoarseMethod::factorized},
                                           {30., CoarseMethod::factorized},
                                           {30., CoarseMethod::algebraic}})
  {
    const RefinedBody refined(default_geometry, angle == 0 ? even_mesh(1, 1) : even_mesh(2, 0), full,
                              LocalAxes(angle), on_coarsest);
    const WholeBodyConditions solver(refined.body.condensed.frame(), refined.stiffness,
                                     const_cast<VCycle &>(refined.cycle));
    const ContactConditions conditions{mixed_conditions(refined, node_stiffness), MatrixXd(), VectorXd()};
    EXPECT_LE(error_of(conditions, solver.solve(conditions, 1e-10), refined.body.condensed.compliance()),
              1e-7);
  }
}

/// A face that forces drive along x and z: the change of force balances it.
TEST(WholeBodyConditions, MovesAFaceThatForcesDrive)
{
  const RefinedBody refined(default_geometry, even_mesh(2, 0), full);
  const auto &frame = refined.body.condensed.frame();
  const WholeBodyConditions solver(frame, refined.stiffness, const_cast<VCycle &>(refined.cycle));
  ContactConditions conditions{mixed_conditions(refined, node_stiffness), MatrixXd(), VectorXd(2)};
  conditions.face.resize(3 * static_cast<Index>(refined.nodes().size()), 2);
  conditions.face << frame.moved_with(moved_by(1, 0, 0)).normalized(),
      frame.moved_with(moved_by(0, 0, 1)).normalized();
  conditions.face_right_side << 3, -2;
  const ContactChange change = solver.solve(conditions, 1e-10);
  EXPECT_LE(error_of(conditions, change, refined.body.condensed.compliance()), 1e-7);
  EXPECT_LE((conditions.face.transpose() * change.force - conditions.face_right_side).norm(), 1e-9);
}

/// What the body lacked before, it no longer lacks.
TEST(WholeBodyConditions, RestoresEquilibrium)
{
  const RefinedBody refined(default_geometry, even_mesh(2, 1), quarter);
  const WholeBodyConditions solver(refined.body.condensed.frame(), refined.stiffness,
                                   const_cast<VCycle &>(refined.cycle));
  ContactConditions conditions{mixed_conditions(refined, node_stiffness), MatrixXd(), VectorXd()};
  conditions.residual = random_numbers(refined.body.discretization.n_free(), 11);
  const ContactChange change = solver.solve(conditions, 1e-8);
  EXPECT_LE((conditions.residual + change.body.residual).norm(), 1e-7 * conditions.residual.norm());
  const VectorXd forces = refined.body.condensed.frame().on_free_unknowns(change.force);
  EXPECT_LE((forces - refined.body.stiffness.vmult(change.body.displacement) - change.body.residual).norm(),
            1e-9 * forces.norm());
}
} // namespace orthocone::test
