// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/hierarchical_half_space.h>

#include "surface/surfaces.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// Largest difference of products with some forces, relative to the product, and of a diagonal block.
double difference(const Compliance &products, const MatrixXd &matrix, const VectorXd &force)
{
  VectorXd displacement;
  products.vmult(displacement, force);
  const VectorXd expected = matrix * force;
  const Index node = products.n_nodes() / 3;
  return std::max((displacement - expected).norm() / expected.norm(),
                  (products.diagonal_block(node) - matrix.block<3, 3>(3 * node, 3 * node)).norm() /
                      matrix.block<3, 3>(3 * node, 3 * node).norm());
}

/// Forces that press and pull along one direction, and forces of both signs.
std::vector<VectorXd> some_forces(const Index n)
{
  VectorXd smooth = VectorXd::LinSpaced(n, 1, 2), rough = smooth;
  for (Index i = 0; i < n; i += 2)
    rough[i] *= -1;
  return {smooth, rough};
}

/// Angles by which the axes of nodes are turned.
LocalAxes turned_axes(const ContactSurface &surface, const double step)
{
  std::vector<double> angles;
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    angles.push_back(step * static_cast<double>(i));
  return LocalAxes(angles);
}
} // namespace

// Few nodes have no blocks that are far apart, so that nothing is approximated.
TEST(HierarchicalHalfSpace, IsTheDenseMatrixWhereNodesAreFew)
{
  const HalfSpace steel{210000, 0.3};
  for (const SymmetryPlanes &planes :
       {SymmetryPlanes{}, SymmetryPlanes{true, false}, SymmetryPlanes{true, true}})
    for (const unsigned int degree : {1, 2})
    {
      const ContactSurface surface = square_surface(4, degree, planes, on_disc);
      const LocalAxes axes = turned_axes(surface, planes.n_copies() == 1 ? 7 : 90);
      const HierarchicalHalfSpace products(steel, surface, planes, axes);
      const MatrixXd matrix = half_space_compliance(steel, surface, planes, axes);
      for (const VectorXd &force : some_forces(matrix.cols()))
        EXPECT_LE(difference(products, matrix, force), 1e-14) << planes.n_copies() << ' ' << degree;
    }
}

TEST(HierarchicalHalfSpace, DividesForcesAmongHangingPlaces)
{
  ContactSurface surface;
  for (const auto &[x, y] : {std::pair<double, double>{0, 0}, {2, 0}, {0, 2}, {2, 2}, {3, 0}, {3, 1}, {3, 2}})
    surface.nodes.push_back({{{x, y}}, 1, {}, {{true, true, true}}});
  surface.hanging.push_back({{{{2, 1}}, 0, {}, {{true, true, true}}}, {{1, 0.5}, {3, 0.5}}});
  surface.faces = {{0, 1, 2, 3}, {1, 4, 7, 5}, {7, 5, 3, 6}};
  const HalfSpace rubber{5, 0.5};
  const HierarchicalHalfSpace products(rubber, surface, ModelSymmetry(), LocalAxes(30));
  const MatrixXd matrix = half_space_compliance(rubber, surface, ModelSymmetry(), LocalAxes(30));
  for (const VectorXd &force : some_forces(matrix.cols()))
    EXPECT_LE(difference(products, matrix, force), 1e-14);
}

// Blocks of nodes that are far apart are approximated, also where Poisson's ratio leaves zeros in them, and
// near a plane of symmetry, whose images are not far away. The matrix stays symmetric.
TEST(HierarchicalHalfSpace, IsCloseToTheDenseMatrixInLessMemory)
{
  for (const double nu : {0., 0.3, 0.5})
    for (const SymmetryPlanes &planes : {SymmetryPlanes{}, SymmetryPlanes{true, true}})
    {
      const HalfSpace half_space{1000, nu};
      const ContactSurface surface = square_surface(planes.n_copies() == 1 ? 26 : 52, 1, planes, on_disc);
      const LocalAxes axes = turned_axes(surface, planes.n_copies() == 1 ? 0.1 : 180);
      const HierarchicalHalfSpace products(half_space, surface, planes, axes);
      const MatrixXd matrix = half_space_compliance(half_space, surface, planes, axes);
      for (const VectorXd &force : some_forces(matrix.cols()))
        EXPECT_LE(difference(products, matrix, force), 1e-8) << nu << ' ' << planes.n_copies();
      EXPECT_LE(products.bytes(), 0.6 * static_cast<double>(sizeof(double) * matrix.size()));
      const std::vector<VectorXd> forces = some_forces(matrix.cols());
      VectorXd of_first, of_second;
      products.vmult(of_first, forces[0]);
      products.vmult(of_second, forces[1]);
      EXPECT_LE(std::abs(forces[1].dot(of_first) - forces[0].dot(of_second)),
                1e-13 * forces[1].norm() * of_first.norm());
    }
}

TEST(HierarchicalHalfSpace, HasNoSection)
{
  const HalfSpace steel{210000, 0.3};
  EXPECT_THROW(
      HierarchicalHalfSpace(steel, square_surface(1, 1), ModelSymmetry::of_revolution(), LocalAxes(0)),
      std::logic_error);
}
} // namespace orthocone::test
