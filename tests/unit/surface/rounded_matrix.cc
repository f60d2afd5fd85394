// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "surface/rounded_matrix.h"

#include <gtest/gtest.h>

#include <limits>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// A matrix that falls off along its rows, as a compliance does. Only the lower half has numbers.
MatrixXd lower_half(const Index n)
{
  MatrixXd matrix = MatrixXd::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < n; ++i)
      matrix(i, j) = std::cos(static_cast<double>(i * j)) / static_cast<double>(1 + i - j);
  return matrix;
}
} // namespace

// Sizes of one tile, of whole tiles, and of tiles that are cut.
TEST(RoundedMatrix, ProductsAreOffByTheRoundingOfEntries)
{
  constexpr double scale = 3e-9, bound = 2e-5; // of the largest entry of a tile, which is 1 at most
  for (const Index n : {1, 3, 64, 130, 256, 600})
  {
    const MatrixXd matrix = lower_half(n);
    const VectorXd x = VectorXd::Random(n);
    const MatrixXd scaled = scale * matrix;
    const RoundedMatrix rounded(DenseView(scaled.data(), n, n), scale);
    const Eigen::VectorXf found = rounded * x.cast<float>();
    const VectorXd exact = matrix.selfadjointView<Eigen::Lower>() * x;
    EXPECT_LT((found.cast<double>() - exact).lpNorm<Eigen::Infinity>(), bound * x.lpNorm<1>() + 1e-6) << n;
  }
}

/// More threads than columns of tiles, too.
TEST(RoundedMatrix, ThreadsShareAProduct)
{
  constexpr Index n = 300;
  const MatrixXd matrix = lower_half(n);
  const RoundedMatrix rounded(DenseView(matrix.data(), n, n), 1);
  const Eigen::VectorXf x = Eigen::VectorXf::Random(n), alone = rounded.product(x, 1);
  for (const Index n_threads : {2, 3, 7})
  {
    const Eigen::VectorXf shared = rounded.product(x, n_threads);
    EXPECT_LT((shared - alone).norm(), 1e-6F * alone.norm()) << n_threads;
    EXPECT_EQ((shared - rounded.product(x, n_threads)).norm(), 0) << n_threads;
  }
}

TEST(RoundedMatrix, TilesHaveAScaleOfTheirOwn)
{
  constexpr Index n = 128;
  constexpr double small = 1e-7; // 0 with one scale for all
  MatrixXd matrix = MatrixXd::Constant(n, n, small);
  matrix.topLeftCorner(n / 2, n / 2).setConstant(1);
  const RoundedMatrix rounded(DenseView(matrix.data(), n, n), 1);
  const Eigen::VectorXf found = rounded * Eigen::VectorXf::Unit(n, 0);
  EXPECT_NEAR(found[n - 1], small, 1e-4 * small);
}

TEST(RoundedMatrix, OfZerosGivesZeros)
{
  const MatrixXd matrix = MatrixXd::Zero(70, 70);
  const RoundedMatrix rounded(DenseView(matrix.data(), 70, 70), 1);
  EXPECT_EQ((rounded * Eigen::VectorXf::Ones(70)).norm(), 0);
}
} // namespace orthocone::test
