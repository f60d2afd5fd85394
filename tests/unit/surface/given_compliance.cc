// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/given_compliance.h>

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
DenseView view(const MatrixXd &w)
{
  return {w.data(), w.rows(), w.cols()};
}

/// Nodes in a row that feel each other, each direction by itself.
MatrixXd row_of_nodes(const Index n)
{
  MatrixXd w = MatrixXd::Zero(3 * n, 3 * n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      w.block<3, 3>(3 * i, 3 * j) = std::exp(-0.5 * std::abs(static_cast<double>(i - j))) *
                                    Eigen::Vector3d(1, 1.2, 1.3).asDiagonal().toDenseMatrix();
  return w;
}

VectorXd some_direction(const Index size)
{
  std::mt19937 numbers(1);
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(size, [&] { return normal(numbers); }).normalized();
}

/// What is said of a matrix; empty where it is a compliance.
std::string said_of(const MatrixXd &w)
{
  try
  {
    check_compliance(view(w));
    return "";
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
}
} // namespace

/// An eigenvalue is pushed below zero by a millionth of the largest one, or to just above it.
TEST(GivenCompliance, ATinyNegativeEigenvalueOfASmallMatrixIsFound)
{
  for (const Index n : {1, 2, 30, 200})
  {
    const MatrixXd w = row_of_nodes(n);
    const VectorXd v = some_direction(3 * n);
    const double least = 1 / v.dot(w.llt().solve(v)); // w - least v v^T is singular
    EXPECT_EQ(said_of(w - least * (1 - 1e-5) * v * v.transpose()), "") << n;
    EXPECT_EQ(said_of(w - least * v * v.transpose()), "") << n;
    const double clearly = 1e-5 * static_cast<double>(n);
    EXPECT_NE(said_of(w - least * (1 + clearly) * v * v.transpose()).find("indefinite"), std::string::npos)
        << n;
  }
}

TEST(GivenCompliance, AClearlyNegativeEigenvalueOfALargeMatrixIsFound)
{
  const Index n = 300;
  const MatrixXd w = row_of_nodes(n);
  const double largest = w.norm() / 10; // below the largest eigenvalue's bound, above a tenth of it
  EXPECT_EQ(said_of(w), "");
  const VectorXd v = some_direction(3 * n);
  EXPECT_NE(said_of(w - largest * v * v.transpose()).find("indefinite"), std::string::npos);
}

TEST(GivenCompliance, RigidBodiesAreSingularNotIndefinite)
{
  for (const Index n : {4, 150})
  {
    std::srand(1);
    const MatrixXd motions = MatrixXd::Random(3 * n, 6);
    EXPECT_EQ(said_of(motions * motions.transpose()), "") << n;
  }
}

TEST(GivenCompliance, EntriesThatNoBodyHas)
{
  MatrixXd w = row_of_nodes(4);
  w(0, 4) = 0.1;
  EXPECT_THROW(given_compliance(view(w), NodeVector::Zero(12)), std::invalid_argument);
  w = row_of_nodes(4);
  w(2, 11) = w(11, 2) = 1.4;
  EXPECT_EQ(said_of(w).find("W is indefinite: an entry of nodes 0 and 3"), 0u);
  w = row_of_nodes(4);
  w(7, 7) = -0.1;
  EXPECT_EQ(said_of(w).find("W has the entry -0.1 on its diagonal"), 0u);
  w(7, 7) = std::nan("");
  EXPECT_EQ(said_of(w), "W has entries that are no numbers");
  EXPECT_NE(said_of(MatrixXd::Zero(3, 3)), "");
  w = row_of_nodes(2);
  w.row(4).setZero(); // but not its column
  EXPECT_THROW(given_compliance(view(w), NodeVector::Zero(6)), std::invalid_argument);
}

/// A direction in which a node cannot move gets a compliance of its own, and all others keep theirs.
TEST(GivenCompliance, NodesThatCannotMove)
{
  MatrixXd w = row_of_nodes(3);
  w.row(4).setZero();
  w.col(4).setZero();
  NodeVector q = NodeVector::Constant(9, -0.1);
  q[4] = 0;
  const GivenCompliance given = given_compliance(view(w), q);
  const DenseCompliance &compliance = *given.compliance;
  EXPECT_EQ(immobile_directions(view(w)), std::vector<Index>{4});
  EXPECT_EQ(immobile_directions(*compliance.dense()), std::vector<Index>{});
  MatrixXd rest = *compliance.dense() - w;
  EXPECT_GT(rest(4, 4), 0);
  rest(4, 4) = 0;
  EXPECT_EQ(rest.norm(), 0);
  q[4] = 0.1;
  EXPECT_THROW(given_compliance(view(w), q), std::invalid_argument);
}

/// Nothing is copied where nothing is to be changed.
TEST(GivenCompliance, UsesTheMemoryOfTheMatrix)
{
  const MatrixXd w = row_of_nodes(3);
  EXPECT_EQ(given_compliance(view(w), NodeVector::Zero(9)).compliance->dense()->data(), w.data());
}

/// A rigid body on four nodes whose W another program computed in single precision, or with less care.
TEST(GivenCompliance, TakesTheSymmetricPartOfRoundedEntriesAndSaysSo)
{
  std::srand(1);
  const MatrixXd motions = MatrixXd::Random(12, 6);
  const MatrixXd w = motions * motions.transpose();
  EXPECT_TRUE(given_compliance(view(w), NodeVector::Zero(12)).notes().empty());
  for (const double error : {1e-7, 1e-5, 4e-4})
  {
    MatrixXd tilted = w + error * w.diagonal().minCoeff() * MatrixXd::Random(12, 12);
    const GivenCompliance given = given_compliance(view(tilted), NodeVector::Zero(12));
    EXPECT_GT(given.asymmetry, 0.1 * error);
    EXPECT_LT(given.asymmetry, 2 * error);
    EXPECT_EQ((*given.compliance->dense() - (tilted + tilted.transpose()) / 2).norm(), 0);
    ASSERT_FALSE(given.notes().empty());
    EXPECT_NE(given.notes()[0].find("symmetric part"), std::string::npos);
  }
}

TEST(GivenCompliance, RefusesMoreThanRoundingWithARemedy)
{
  MatrixXd w = row_of_nodes(2);
  w(0, 4) += 1.1e-3 * 1.3; // of the largest entry of both nodes
  try
  {
    given_compliance(view(w), NodeVector::Zero(6));
    FAIL();
  }
  catch (const std::invalid_argument &error)
  {
    const std::string said = error.what();
    EXPECT_EQ(said.find("W is not symmetric: mirror images of nodes 0 and 1 differ by 0.0011"), 0u) << said;
    EXPECT_NE(said.find("(W + W^T)/2"), std::string::npos) << said;
  }
  w(0, 4) -= 0.2e-3 * 1.3;
  EXPECT_NEAR(given_compliance(view(w), NodeVector::Zero(6)).asymmetry, 0.9e-3, 1e-12);
}

/// One node on a body that hardly turns, whose least eigenvalue rounding has pushed below zero.
TEST(GivenCompliance, TakesAnEigenvalueThatSinglePrecisionLeavesBelowZero)
{
  const Eigen::Vector3d v = Eigen::Vector3d(1, 2, -1).normalized();
  const MatrixXd flat = MatrixXd::Identity(3, 3) - v * v.transpose();
  const auto below = [&](const double value) { return MatrixXd(flat - value * v * v.transpose()); };
  EXPECT_EQ(said_of(below(1e-9)), "");
  const MatrixXd slightly = below(1.2e-7);
  const double relative = 1.2e-7 / slightly.diagonal().maxCoeff();
  const GivenCompliance given = given_compliance(view(slightly), NodeVector::Zero(3));
  EXPECT_NEAR(given.indefiniteness, relative, 1e-12);
  ASSERT_EQ(given.notes().size(), 1u);
  EXPECT_EQ(given.notes()[0].find("W is indefinite"), 0u);
  EXPECT_NE(said_of(below(1e-6)).find("W is indefinite"), std::string::npos);
}
} // namespace orthocone::test
