// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/half_space_body.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// A half-space of n_x by n_y patches on 4 x 3 mm, whose nodes have tangents that are turned (degrees).
class GridBody
{
public:
  GridBody(const unsigned int n_x, const unsigned int n_y, const double angle = 0)
      : body(
            options(n_x, n_y), [angle](const ContactSurface &) { return LocalAxes(angle); },
            [](const Body &) {}, seconds_)
  {
  }

  static BodyOptions options(const unsigned int n_x, const unsigned int n_y)
  {
    BodyOptions options;
    options.geometry.shape = BodyShape::half_space;
    options.geometry.sizes = {{4, 3, 0}};
    options.mesh.cells = {{n_x, n_y, 0}};
    return options;
  }

private:
  PhaseSeconds seconds_;

public:
  HalfSpaceBody body;
};

/// Forces (3 n, global axes) that vary linearly over the surface.
VectorXd linear_forces(const ContactSurface &surface)
{
  VectorXd force(3 * surface.nodes.size());
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
  {
    const auto &[x, y] = surface.nodes[i].position;
    force.segment<3>(3 * static_cast<Index>(i)) =
        surface.nodes[i].area * Vector3d(1 + x, 2 - y, 3 + 0.5 * x - 0.25 * y);
  }
  return force;
}
} // namespace

TEST(HalfSpaceBody, HasTheMiddlesOfPatchesAsNodes)
{
  const GridBody grid(4, 6);
  const ContactSurface &surface = grid.body.surface();
  ASSERT_EQ(surface.nodes.size(), 24u);
  EXPECT_EQ(surface.faces.size(), 15u);
  EXPECT_EQ(surface.nodes[0].position, (std::array<double, 2>{{-1.5, -1.25}}));
  EXPECT_EQ(surface.nodes[5].position, (std::array<double, 2>{{-0.5, -0.75}}));
  EXPECT_EQ(surface.nodes[0].area, 0.5);
  EXPECT_EQ(grid.body.unknowns().n_free(), 72u);
  EXPECT_FALSE(grid.body.mesh().has_mesh());
  EXPECT_THROW(grid.body.mesh().n_levels(), std::logic_error);
}

// The far field moves as a rigid body about the origin, and the work of its wrench is that of the forces.
TEST(HalfSpaceBody, FollowsItsFarField)
{
  const GridBody grid(4, 3, 30);
  RigidMotion motion;
  motion.components << 0.1, -0.2, 0.3, 0.01, 0.02, -0.03;
  const NodeVector moved = grid.body.moved_with(motion), force = VectorXd::LinSpaced(moved.size(), -1, 3);
  EXPECT_NEAR(grid.body.wrench(force).components.dot(motion.components), force.dot(moved), 1e-12);
  const VectorXd whole = grid.body.with_motion(motion, VectorXd::Zero(moved.size()));
  for (Index node = 0; 3 * node < moved.size(); ++node)
    EXPECT_LT(
        (grid.body.frame().global_in_local(static_cast<std::size_t>(node)) * moved.segment<3>(3 * node) -
         whole.segment<3>(3 * node))
            .norm(),
        1e-15);
}

// The mismatch sees displacements that the forces do not cause, and is otherwise one of rounding.
TEST(HalfSpaceBody, ComparesDisplacementsWithSumsOfItsOwn)
{
  const GridBody grid(8, 6, 30);
  const NodeVector force = VectorXd::LinSpaced(3 * 48, -1, 3).array().cos();
  NodeVector elastic;
  grid.body.compliance().vmult(elastic, force);
  const BodyMismatch right = grid.body.mismatch(force, elastic, 1e-8);
  EXPECT_LT(right.displacement, 1e-15);
  EXPECT_LT(right.unbalanced, 1e-12);
  elastic[30] += 1e-3;
  EXPECT_NEAR(grid.body.mismatch(force, elastic, 1e-8).displacement, 1e-3, 1e-3);
  EXPECT_GT(grid.body.mismatch(force, elastic, 1e-8).displacement, 1e-4);
  EXPECT_EQ(
      grid.body.mismatch(NodeVector::Zero(force.size()), NodeVector::Zero(force.size()), 1e-8).unbalanced, 0);
}

// Tractions that vary linearly are the same on both grids, but for the outermost patches, and no force is
// lost where these are even.
TEST(HalfSpaceBody, ProlongsTractions)
{
  const GridBody coarse(8, 6), fine(16, 12, 90);
  const NodeVector prolonged = fine.body.prolonged_forces(linear_forces(coarse.body.surface()));
  const VectorXd exact = linear_forces(fine.body.surface());
  for (Index j = 1; j + 1 < 12; ++j)
    for (Index i = 1; i + 1 < 16; ++i)
    {
      const Index node = 16 * j + i;
      EXPECT_LT((axes_about_z(90) * prolonged.segment<3>(3 * node) - exact.segment<3>(3 * node)).norm(),
                1e-12);
    }
  const NodeVector even = fine.body.prolonged_forces(VectorXd::Ones(3 * 48));
  EXPECT_NEAR(even(Eigen::seqN(0, 192, 3)).sum(), 48, 1e-12);
}

// Two half-spaces of one material give way twice as much along the normal, and decouple.
TEST(HalfSpaceBody, AddsAHalfSpaceBelow)
{
  const GridBody grid(4, 4, 30);
  const BodyOptions options = GridBody::options(4, 4);
  const auto sum = grid.body.compliance_on(options.material);
  EXPECT_NEAR(sum->diagonal_block(0)(0, 0), 2 * grid.body.compliance().diagonal_block(0)(0, 0), 1e-18);
  NodeVector moved;
  sum->vmult(moved, NodeVector::Unit(48, 0));
  EXPECT_LT(moved(Eigen::seqN(1, 16, 3)).norm(), 1e-13 * moved.norm()) << "pressure moves nothing sideways";
}
} // namespace orthocone::test
