// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>
#include <orthocone/surface/sparse_compliance.h>

#include "some_conditions.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr Index n_nodes = 40;

/// A chain of rigid bodies, two nodes between neighbours: nodes of one body feel each other.
MatrixXd chain_of_bodies()
{
  std::srand(1);
  MatrixXd motions = MatrixXd::Zero(3 * n_nodes, 6 * (n_nodes / 2 + 1));
  for (Index node = 0; node < n_nodes; ++node)
    motions.block<3, 12>(3 * node, 6 * (node / 2)).setRandom();
  return motions * motions.transpose();
}

DenseView view_of(const MatrixXd &w)
{
  return {w.data(), w.rows(), w.cols()};
}
} // namespace

TEST(SparseCompliance, PaysWhereMostBlocksAreZero)
{
  const MatrixXd w = chain_of_bodies();
  EXPECT_TRUE(SparseCompliance::pays_for(view_of(w)));
  EXPECT_TRUE(compliance_of_matrix(view_of(w))->is_sparse());
  EXPECT_EQ(compliance_of_matrix(view_of(w))->dense()->data(), w.data());
  MatrixXd full = w;
  full.array() += 1e-3;
  EXPECT_FALSE(SparseCompliance::pays_for(view_of(full)));
  EXPECT_FALSE(compliance_of_matrix(full)->is_sparse());
  EXPECT_FALSE(SparseCompliance::pays_for(view_of(MatrixXd::Identity(15, 15)))); // elimination is as fast
}

TEST(SparseCompliance, HasTheProductsOfItsMatrix)
{
  const MatrixXd w = chain_of_bodies();
  const SparseCompliance compliance{view_of(w)};
  const VectorXd force = VectorXd::Random(3 * n_nodes), displacement = w * force;
  const auto springs = compliance.on_springs(0.1);
  NodeVector product, with_springs;
  compliance.vmult(product, force);
  springs->vmult(with_springs, force);
  EXPECT_LT((product - displacement).norm(), 1e-13 * displacement.norm());
  EXPECT_LT((with_springs - displacement - 0.1 * force).norm(), 1e-13 * displacement.norm());
  EXPECT_TRUE(springs->is_sparse());
  for (Index node = 0; node < n_nodes; ++node)
  {
    const Eigen::Vector3d here = displacement.segment<3>(3 * node);
    EXPECT_LT((compliance.displacement_at(node, force) - here).norm(), 1e-13 * displacement.norm());
    EXPECT_LT((DenseCompliance(view_of(w)).displacement_at(node, force) - here).norm(),
              1e-13 * displacement.norm());
  }
}

TEST(SparseCompliance, SolvesConditionsToRounding)
{
  const MatrixXd w = chain_of_bodies() + 1e-3 * MatrixXd::Identity(3 * n_nodes, 3 * n_nodes);
  for (const Index n_motions : {0, 3})
  {
    const ContactConditions conditions = some_conditions(n_nodes, n_motions);
    const SparseCompliance compliance{view_of(w)};
    const ContactChange change = compliance.condition_solver(compliance.softness())->solve(conditions, 0.1);
    EXPECT_LT(error_of(conditions, w, change), 1e-8) << n_motions;
  }
}

/// Newton's step is no number then, or anything: only that it ends is promised.
TEST(SparseCompliance, ASingularSystemEnds)
{
  const MatrixXd w = chain_of_bodies();
  ContactConditions conditions = some_conditions(n_nodes, 0);
  for (NodeCondition &node : conditions.nodes)
  {
    node.n_unknowns = 3;
    node.basis.setIdentity();
    node.rows.setIdentity();
    node.diagonal.setZero();
  }
  const SparseCompliance compliance{view_of(w)};
  const ContactChange change = compliance.condition_solver(compliance.softness())->solve(conditions, 0.1);
  EXPECT_EQ(change.force.size(), 3 * n_nodes);
}
} // namespace orthocone::test
