// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/face/load_limit.h"
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
constexpr Eigen::Index n_nodes_a_side = 5, n_flat = n_nodes_a_side * n_nodes_a_side;

/// Whether a pressing force and a force along x (1) or y (2) are beyond what a flat contact can carry.
bool is_beyond(const OrthotropicFriction &law, const double pressing, const unsigned int along,
               const double pulling)
{
  const DenseCompliance compliance(grid_compliance(n_nodes_a_side));
  const ContactSystem system(compliance, FrictionLaws(n_flat, law));
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(3 * n_flat, 2);
  for (Eigen::Index node = 0; node < n_flat; ++node)
  {
    motions(3 * node, 0) = 1;
    motions(3 * node + along, 1) = 1;
  }
  const FreeFace face(motions, Eigen::Vector2d(pressing, pulling));
  return is_beyond_every_force(ContactStep(system, NodeVector::Zero(3 * n_flat), face));
}
} // namespace

// Friction carries mu P, also where it is tiny in the other direction. That rounding proves nothing is shown
// by the rows `across` of run_book, whose balance is found but for its last digits.
TEST(LoadLimit, IsThatOfAllNodesTogether)
{
  for (const OrthotropicFriction &law : {OrthotropicFriction{1e-6, 0.3, 1e-6, 0.3}, case_b, case_c})
    for (const double pressing : {1e-3, 29.187661106980531, 906.2287, 1e6})
      for (const double share : {0., 0.048, 0.16, 0.22, 0.5, 0.99, 0.999999})
      {
        EXPECT_FALSE(is_beyond(law, pressing, 1, share * law.mu_x * pressing)) << pressing << " " << share;
        EXPECT_FALSE(is_beyond(law, pressing, 2, -share * law.mu_y * pressing)) << pressing << " " << share;
      }
  for (const OrthotropicFriction &law : {case_b, case_c})
    for (const double share : {1.0001, 2.})
    {
      EXPECT_TRUE(is_beyond(law, 906.2287, 1, -share * law.mu_x * 906.2287)) << share;
      EXPECT_TRUE(is_beyond(law, 906.2287, 2, share * law.mu_y * 906.2287)) << share;
    }
  EXPECT_TRUE(is_beyond(case_b, -1, 1, 0)); // it pulls
}
} // namespace orthocone::test
