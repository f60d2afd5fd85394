// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/grid_half_space.h>

#include "surface/rectangle_kernel.h"
#include "surface/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr HalfSpace body_of_steel{210000, 0.3}, body_of_rubber{10, 0.5};

/// The values of a kernel, to be compared.
Eigen::Matrix<double, 6, 1> values_of(const HalfSpaceKernel &kernel)
{
  return (Eigen::Matrix<double, 6, 1>() << kernel.one, kernel.xx, kernel.xy, kernel.yy, kernel.x, kernel.y)
      .finished();
}

/// W block by block.
MatrixXd dense_grid(const GridHalfSpace &half_space)
{
  const SurfaceGrid &grid = half_space.grid();
  MatrixXd w(3 * grid.n_nodes(), 3 * grid.n_nodes());
  for (Index a = 0; a < grid.n_nodes(); ++a)
    for (Index b = 0; b < grid.n_nodes(); ++b)
      w.block<3, 3>(3 * a, 3 * b) =
          half_space.block(a % grid.n_x - b % grid.n_x, a / grid.n_x - b / grid.n_x);
  return w;
}
} // namespace

// 1 / R over a square and itself: 4/3 (1 - sqrt 2) + 4 log(1 + sqrt 2).
TEST(MeanOverRectangles, OfASquareIsItsPotential)
{
  const double exact = 4. / 3 * (1 - std::sqrt(2.)) + 4 * std::log(1 + std::sqrt(2.));
  const HalfSpaceKernel kernel = mean_over_rectangles(1, 1, 0, 0);
  EXPECT_NEAR(kernel.one, exact, 1e-14);
  EXPECT_NEAR(kernel.xx, exact / 2, 1e-14) << "no direction differs from the other one";
  EXPECT_NEAR(std::abs(kernel.xy) + std::abs(kernel.x) + std::abs(kernel.y), 0, 1e-14);
}

// A rectangle is made of four: its kernel is the mean of theirs. Some are by closed forms and some by the
// Gauss rule.
TEST(MeanOverRectangles, AddUp)
{
  constexpr double width = 1, height = 0.7;
  for (const auto &[x, y] : std::vector<std::pair<double, double>>{{0, 0},
                                                                   {2, 0},
                                                                   {2, -1.4},
                                                                   {0, 1.4},
                                                                   {6, 4.2},
                                                                   {14, 0},
                                                                   {-10, 9.8},
                                                                   {18, 14},
                                                                   {22, -0.7},
                                                                   {40, 21}})
  {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (const double from_x : {-0.5, 0.5})
      for (const double from_y : {-0.5, 0.5})
        for (const double to_x : {-0.5, 0.5})
          for (const double to_y : {-0.5, 0.5})
            sum += values_of(mean_over_rectangles(width, height, x + width * (to_x - from_x),
                                                  y + height * (to_y - from_y)));
    const auto whole = values_of(mean_over_rectangles(2 * width, 2 * height, x, y));
    EXPECT_LT((sum / 16 - whole).norm(), 2e-10 * whole[0]) << x << ", " << y;
  }
}

TEST(GridHalfSpace, ProductsAreThoseOfADenseMatrix)
{
  for (const SurfaceGrid &grid : {SurfaceGrid{9, 5, 0.3, 0.2},
                                  {4, 11, 1, 1},
                                  {1, 6, 2, 0.5},
                                  {9, 5, 0.3, 0.2, true},
                                  {4, 11, 1, 1, true},
                                  {8, 6, 0.2, 0.5, true}})
    for (const auto &counterface : {std::optional<HalfSpace>(), std::optional<HalfSpace>(body_of_rubber)})
    {
      const GridHalfSpace half_space(grid, body_of_steel, counterface);
      const MatrixXd w = dense_grid(half_space);
      const VectorXd force = VectorXd::LinSpaced(w.cols(), -1, 2).array().sin();
      VectorXd moved;
      half_space.vmult(moved, force);
      EXPECT_LT((moved - w * force).norm(), 1e-12 * (w * force).norm());
      EXPECT_LT((w - w.transpose()).norm(), 1e-12 * w.norm());
      EXPECT_GT(w.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
      EXPECT_EQ(half_space.diagonal_block(0), (w.block<3, 3>(0, 0)));
      EXPECT_LT((half_space.displacement_at(3, force) - moved.segment<3>(9)).norm(), 1e-12 * moved.norm());
    }
}

// A wave of pressure along x moves the surface of a periodic half-space as Johnson (Contact Mechanics, 13.2)
// has it: by 2 (1 - nu^2) / (E k) along itself, and a quarter of a wave apart by (1 + nu) (1 - 2 nu) / (E k)
// along x, to the side that the image of a single patch shows, too.
TEST(GridHalfSpace, MovesAsAWaveDoesWhereItIsPeriodic)
{
  constexpr Index n = 64;
  const SurfaceGrid grid{n, 4, 0.1, 0.3, true};
  const GridHalfSpace half_space(grid, body_of_steel);
  const double k = 2 * M_PI / (n * grid.width), nu = body_of_steel.poisson_ratio,
               normal = 2 * (1 - nu * nu) / (body_of_steel.young_modulus * k),
               along = (1 + nu) * (1 - 2 * nu) / (body_of_steel.young_modulus * k);
  VectorXd force = VectorXd::Zero(3 * grid.n_nodes()), moved;
  for (Index node = 0; node < grid.n_nodes(); ++node)
    force[3 * node] = grid.width * grid.height * std::cos(k * grid.width * static_cast<double>(node % n));
  half_space.vmult(moved, force);
  constexpr double of_patches = 2e-3; // (k width)^2 / 6: the wave is a stair
  EXPECT_NEAR(moved[0], normal, of_patches * normal);
  EXPECT_NEAR(moved[3 * (n / 4) + 1] / along, -1, of_patches);
  EXPECT_NEAR(moved[3 * (3 * n / 4) + 1] / along, 1, of_patches);
}

// Near a force its images are far: what they do is the same for all that is near, but for the square of its
// distance. The mean traction compresses a layer as thick as the longer period.
TEST(GridHalfSpace, IsThatOfASinglePatchNearIt)
{
  const SurfaceGrid single{64, 64, 1, 1}, periodic{64, 64, 1, 1, true};
  const GridHalfSpace alone(single, body_of_steel), among(periodic, body_of_steel);
  for (const auto &[i, j] : std::vector<std::pair<Index, Index>>{{1, 0}, {0, 1}, {2, 3}, {-3, 1}})
  {
    const Matrix3d of_one = alone.block(0, 0) - alone.block(i, j),
                   of_all = among.block(0, 0) - among.block(i, j);
    EXPECT_LT((of_all - of_one).norm(), 2e-3 * of_one.norm()) << i << ", " << j;
  }
  const VectorXd force = VectorXd::Ones(3 * periodic.n_nodes());
  VectorXd moved;
  among.vmult(moved, force);
  const double nu = body_of_steel.poisson_ratio, soft = (1 + nu) / body_of_steel.young_modulus;
  EXPECT_NEAR(moved[0], 64 * soft * (1 - 2 * nu) / (1 - nu), 1e-9 * moved[0]);
  EXPECT_NEAR(moved[1], 64 * 2 * soft, 1e-9 * moved[1]);
}

// What pressure does to one of two equal bodies along the plane, it does to the other one as well.
TEST(GridHalfSpace, EqualBodiesDecouple)
{
  const SurfaceGrid grid{4, 4, 1, 1};
  const GridHalfSpace one(grid, body_of_steel), two(grid, body_of_steel, body_of_steel),
      soft(grid, body_of_rubber);
  const Matrix3d single = one.block(2, 1), both = two.block(2, 1);
  EXPECT_GT(std::abs(single(0, 1)), 0.05 * single(0, 0));
  EXPECT_LT(both.topRightCorner(1, 2).norm(), 1e-15 * both(0, 0));
  EXPECT_NEAR(both(0, 0), 2 * single(0, 0), 1e-12 * both(0, 0));
  EXPECT_LT(soft.block(2, 1).topRightCorner(1, 2).norm(), 1e-15) << "at nu = 0.5 nothing couples either";
}

// A force that presses a node draws the surface around it nearer, and one along x pushes in what lies ahead
// of it (Johnson, Contact Mechanics, (3.19) and (3.75)).
TEST(GridHalfSpace, CouplesAsBoussinesqAndCerruti)
{
  const GridHalfSpace half_space({8, 1, 1, 1}, body_of_steel);
  const Matrix3d ahead = half_space.block(5, 0);
  EXPECT_LT(ahead(1, 0), 0);
  EXPECT_GT(ahead(0, 1), 0);
  const double shear = body_of_steel.young_modulus / 2 / 1.3;
  EXPECT_NEAR(ahead(0, 1), 0.4 / (4 * M_PI * shear * 5), 0.02 * ahead(0, 1));
}

// The conditions of stuck nodes ask for the forces that move them in a given way: some iterations of GMRES,
// which do not grow with the grid, since the preconditioner is the symbol of the plane.
TEST(GridHalfSpace, HoldsNodesAsTheDenseMatrixDoes)
{
  const SurfaceGrid grid{12, 10, 0.3, 0.4};
  const GridHalfSpace half_space(grid, body_of_steel);
  const MatrixXd w = dense_grid(half_space);
  ContactConditions conditions;
  VectorXd wanted = VectorXd::Zero(w.rows());
  std::vector<Index> held;
  for (Index node = 0; node < grid.n_nodes(); ++node)
  {
    NodeCondition condition;
    if (node % 3 != 0)
    {
      condition.n_unknowns = 3;
      condition.basis.setIdentity();
      condition.rows = 1e5 * Matrix3d::Identity();
      condition.right_side << 1, 0.2 * std::sin(node), 0.1;
      for (Index i = 0; i < 3; ++i)
        held.push_back(3 * node + i);
      wanted.segment<3>(3 * node) = condition.right_side / 1e5;
    }
    conditions.nodes.push_back(condition);
  }
  conditions.face.resize(w.rows(), 0);
  const ContactChange change = half_space.condition_solver(half_space.softness())->solve(conditions, 1e-5);
  const VectorXd exact = w(held, held).llt().solve(wanted(held));
  EXPECT_LT((change.force(held) - exact).norm(), 1e-3 * exact.norm());
  for (Index node = 0; node < grid.n_nodes(); node += 3)
    EXPECT_TRUE(change.force.segment<3>(3 * node).isZero(0));
}

// Patches of an even mesh are those of a grid, so that both half-spaces are one in the limit: of many points
// where patches touch, and of large distances elsewhere, whose error falls with their fourth power.
TEST(GridHalfSpace, IsTheLimitOfPatchesOfAMesh)
{
  constexpr unsigned int cells = 12, source = 3;
  const ContactSurface surface = square_surface(cells, 1);
  const GridHalfSpace grid({cells + 1, cells + 1, 2. / cells, 2. / cells}, body_of_steel);
  const auto of_mesh = [&](const unsigned int points)
  {
    const HalfSpace steel{body_of_steel.young_modulus, body_of_steel.poisson_ratio, points};
    return half_space_compliance(steel, surface, ModelSymmetry(), LocalAxes(0));
  };
  const auto error = [&](const MatrixXd &w, const Index along_x, const Index along_y)
  {
    const auto place = [](const Index i, const Index j) { return i + (cells + 1) * j; };
    Matrix3d block = w.block<3, 3>(3 * place(source + along_x, source + along_y), 3 * place(source, source));
    // This half-space is below the surface, and that of a grid above it: the normal and the tangential
    // directions couple with the other sign.
    block.topRightCorner<1, 2>() *= -1;
    block.bottomLeftCorner<2, 1>() *= -1;
    const Matrix3d exact = grid.block(along_x, along_y);
    return (block - exact).norm() / exact.norm();
  };
  const MatrixXd usual = of_mesh(2), many = of_mesh(8);
  for (const auto &[x, y] : {std::pair<Index, Index>{0, 0}, {1, 0}, {0, 1}, {1, 1}})
  {
    EXPECT_LE(error(usual, x, y), 2e-2) << x << ' ' << y;
    EXPECT_LE(error(many, x, y), 1e-3) << x << ' ' << y;
  }
  for (const auto &[x, y] : {std::pair<Index, Index>{3, 0}, {2, 2}})
  {
    EXPECT_LE(error(usual, x, y), 1e-3) << x << ' ' << y;
    EXPECT_LE(error(usual, 2 * x, 2 * y), error(usual, x, y) / 12) << x << ' ' << y;
  }
}

TEST(GridHalfSpace, WantsPatchesWithASize)
{
  for (const SurfaceGrid &grid : {SurfaceGrid{0, 4, 1, 1}, {4, 4, 0, 1}, {4, 4, 1, -1}, {4, 4, NAN, 1}})
    EXPECT_THROW(GridHalfSpace(grid, body_of_steel), std::invalid_argument);
}
} // namespace orthocone::test
