// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/bodies.h"

#include <deal.II/dofs/dof_tools.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// Internal forces of a displacement, by quadrature of its own.
VectorXd forces_of(const LoadableBody &body, const VectorXd &displacement)
{
  const auto &discretization = body.discretization;
  return internal_forces(
      discretization,
      [&](const dealii::FEValues<3> &values, const unsigned int q) {
        return stress_of(strains_in_cell(values, discretization.dof_handler(), displacement)[q], body.lame);
      },
      discretization.n_quadrature_points());
}
} // namespace

// The condensed body against the full system: K u = f + r at every degree of freedom, u on the contact
// surface = W r.
TEST(Condensation, SatisfiesTheFullSystem)
{
  for (const SymmetryPlanes &planes : {full, quarter})
    for (const unsigned int degree : {1, 2, 3})
    {
      const LoadableBody body(default_geometry, small_mesh(degree), default_material, planes);
      const auto &surface = body.discretization.contact_surface();
      NodeVector force = uneven_forces(static_cast<Index>(surface.nodes.size()));
      for (std::size_t i = 0; i < surface.nodes.size(); ++i)
        for (Index d = 0; d < 2; ++d)
          if (!surface.nodes[i].is_free[d])
            force[3 * static_cast<Index>(i) + 1 + d] = 0;
      const VectorXd u = volume_displacement(body.condensed, {}, force);
      const VectorXd internal = forces_of(body, u);
      EXPECT_LE(internal.head(body.discretization.n_interior()).norm(), 1e-10 * force.norm());
      EXPECT_EQ(u.tail(u.size() - body.discretization.n_free()).norm(), 0);
      NodeVector moved;
      body.condensed.compliance().vmult(moved, force);
      for (std::size_t i = 0; i < surface.nodes.size(); ++i)
      {
        const auto &node = surface.nodes[i];
        const Vector3d r = force.segment<3>(3 * static_cast<Index>(i));
        const Vector3d w = moved.segment<3>(3 * static_cast<Index>(i));
        EXPECT_NEAR(u[node.dofs[2]], w[0], 1e-11 * moved.norm());
        EXPECT_NEAR(internal[node.dofs[2]], r[0], 1e-10 * force.norm());
        for (Index d = 0; d < 2; ++d)
          if (node.is_free[d])
          {
            EXPECT_NEAR(u[node.dofs[d]], w[1 + d], 1e-11 * moved.norm());
            EXPECT_NEAR(internal[node.dofs[d]], r[1 + d], 1e-10 * force.norm());
          }
      }
    }
}

// Force on the base + force on the top = 0, and so for the moments.
TEST(Condensation, KeepsTheBodyInEquilibrium)
{
  const LoadableBody body(default_geometry, small_mesh(2), default_material, full);
  const NodeVector force = uneven_forces(body.condensed.compliance().n_nodes());
  const VectorXd u = volume_displacement(body.condensed, moved_by(0.01, -0.02, -0.1), force);
  const VectorXd internal = forces_of(body, u);
  const auto positions = dof_positions(body.discretization);
  Vector3d top_force = Vector3d::Zero();
  Vector3d top_moment = Vector3d::Zero();
  const auto &dof_handler = body.discretization.dof_handler();
  for (unsigned int d = 0; d < 3; ++d)
  {
    dealii::ComponentMask component(3, false);
    component.set(d, true);
    for (const auto dof : dealii::DoFTools::extract_dofs(dof_handler, component))
      if (dof >= body.discretization.n_free())
      {
        const auto &x = positions[dof];
        const Vector3d reaction = internal[static_cast<Index>(dof)] * Vector3d::Unit(d);
        top_force += reaction;
        top_moment += Vector3d(x[0], x[1], x[2]).cross(reaction);
      }
  }
  Vector3d base_force = Vector3d::Zero();
  Vector3d base_moment = Vector3d::Zero();
  const auto &nodes = body.discretization.contact_surface().nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Vector3d local = force.segment<3>(3 * static_cast<Index>(i));
    const Vector3d r(local[1], local[2], local[0]);
    base_force += r;
    base_moment += Vector3d(nodes[i].position[0], nodes[i].position[1], 0).cross(r);
  }
  EXPECT_LE((top_force + base_force).norm(), 1e-9 * force.norm());
  EXPECT_LE((top_moment + base_moment).norm(), 1e-9 * default_geometry.radius * force.norm());
}

TEST(Condensation, GivesASymmetricPositiveCompliance)
{
  const LoadableBody body(default_geometry, small_mesh(2), default_material, quarter);
  const DenseView &w = *body.condensed.compliance().dense();
  EXPECT_LE((w - w.transpose()).norm(), 1e-14 * w.norm());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(w).eigenvalues().minCoeff(), 0);
}

TEST(Condensation, WorksForASingleLayerOfTrilinearBricks)
{
  MeshOptions mesh = small_mesh(1);
  mesh.layers = 1; // no interior unknowns at all
  const LoadableBody body(default_geometry, mesh, default_material, full);
  EXPECT_EQ(body.discretization.n_interior(), 0u);
  const NodeVector force = uneven_forces(body.condensed.compliance().n_nodes());
  const VectorXd internal = forces_of(body, volume_displacement(body.condensed, {}, force));
  const auto &nodes = body.discretization.contact_surface().nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_NEAR(internal[nodes[i].dofs[2]], force[3 * static_cast<Index>(i)], 1e-10 * force.norm());
}

TEST(LocalAxes, TurnVectors)
{
  const LocalAxes axes(30);
  EXPECT_TRUE(axes.is_uniform());
  EXPECT_NEAR((axes.to_global(7, {1, 0}) - Vector3d(std::sqrt(0.75), 0.5, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(
      (axes.global_in_local(0).transpose() * axes.to_global(1, {0.3, -2}) - Vector3d(0, 0.3, -2)).norm(), 0,
      1e-15);
  EXPECT_EQ(LocalAxes(90).to_global(0, {1, 0}), Vector3d(0, 1, 0));
  EXPECT_EQ(LocalAxes(-180).to_global(0, {1, 0}), Vector3d(-1, 0, 0));

  const LocalAxes different(std::vector<double>{0, 90, 30});
  EXPECT_FALSE(different.is_uniform());
  EXPECT_EQ(different.to_global(0, {1, 0}), Vector3d(1, 0, 0));
  EXPECT_EQ(different.to_global(1, {1, 0}), Vector3d(0, 1, 0));
  EXPECT_EQ(different.to_global(2, {1, 0}), axes.to_global(2, {1, 0}));
  EXPECT_EQ(different.global_in_local(2), axes.global_in_local(0));
  EXPECT_TRUE(LocalAxes(std::vector<double>{30, 30, 30}).is_uniform());
}

TEST(LocalAxes, StandOnAnyNormal)
{
  const Vector3d normal = Vector3d(1, -2, 2) / 3;
  const Eigen::Matrix3d axes = axes_along(normal, {0, 0, 5});
  EXPECT_LE((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_NEAR(axes.determinant(), 1, 1e-15);
  EXPECT_EQ(axes.col(0), normal);
  EXPECT_NEAR(axes.col(1).dot(Vector3d(2, 1, 0)), 0, 1e-15) << "in the plane of normal and z";
  EXPECT_GT(axes(2, 1), 0);
  EXPECT_LE((axes_along(Vector3d::UnitZ(), {1, 0, 0}) - axes_about_z(0)).norm(), 0);
  EXPECT_THROW(axes_along(normal, -2 * normal), std::domain_error);
  EXPECT_THROW(axes_along(normal, Vector3d::Zero()), std::domain_error);
}

namespace
{
/// Compliance and motion are the same in turned axes as in straight ones.
void expect_same_body_in(const LocalAxes &axes)
{
  const LoadableBody straight(default_geometry, small_mesh(1), default_material, full);
  const LoadableBody turned(default_geometry, small_mesh(1), default_material, full, axes);
  const NodeVector local = uneven_forces(turned.condensed.compliance().n_nodes());
  NodeVector global = local;
  for (Index i = 0; i < turned.condensed.compliance().n_nodes(); ++i)
    global.segment<2>(3 * i + 1) = axes.to_global(i, local.segment<2>(3 * i + 1)).head<2>();
  NodeVector moved_local;
  NodeVector moved_global;
  turned.condensed.compliance().vmult(moved_local, local);
  straight.condensed.compliance().vmult(moved_global, global);
  EXPECT_NEAR(local.dot(moved_local), global.dot(moved_global), 1e-10 * std::abs(local.dot(moved_local)));
  const VectorXd u_turned = volume_displacement(turned.condensed, moved_by(0.1, 0.2, -0.1), local);
  const VectorXd u_straight = volume_displacement(straight.condensed, moved_by(0.1, 0.2, -0.1), global);
  EXPECT_LE((u_turned - u_straight).norm(), 1e-12 * u_straight.norm());
}

std::vector<double> uneven_angles(const Index n_nodes)
{
  std::vector<double> angles;
  for (Index i = 0; i < n_nodes; ++i)
    angles.push_back(37. * static_cast<double>(i * i % 11) - 100);
  return angles;
}

LocalAxes uneven_axes()
{
  const BodyMesh mesh(default_geometry, small_mesh(1), full);
  const Discretization discretization(mesh.triangulation(), small_mesh(1), default_geometry.top_face);
  return LocalAxes(uneven_angles(static_cast<Index>(discretization.contact_surface().nodes.size())));
}
} // namespace

TEST(LocalAxes, TurnTheCompliance)
{
  expect_same_body_in(LocalAxes(30));
  expect_same_body_in(uneven_axes());
}

TEST(RigidRotation, TurnsAboutTheCentreOfTheWholeHeldFace)
{
  for (const SymmetryPlanes &planes : {full, SymmetryPlanes{false, true}, quarter})
  {
    const BodyMesh mesh(default_geometry, small_mesh(2), planes);
    const Discretization discretization(mesh.triangulation(), small_mesh(2), default_geometry.top_face);
    EXPECT_LE((discretization.held_centre() - Vector3d(0, 0, default_geometry.height)).norm(), 1e-12);
  }
  const SectionMesh section(default_geometry, small_mesh(2));
  const SectionDiscretization revolved(section.triangulation(), small_mesh(2), default_geometry.top_face);
  EXPECT_LE((revolved.held_centre() - Vector3d(0, 0, default_geometry.height)).norm(), 1e-12);
}

// Small rotations leave no force anywhere, not even at the held nodes: curved elements follow them exactly.
TEST(RigidRotation, StrainsNothing)
{
  RigidMotion motion;
  motion.components << 0.01, -0.02, -0.1, 0.3, -0.2, 0.5;
  for (const unsigned int degree : {1, 2, 3})
  {
    const LoadableBody body(default_geometry, small_mesh(degree), default_material, full);
    const VectorXd free = VectorXd::Zero(body.discretization.n_free());
    const VectorXd u = body.condensed.frame().with_motion(motion, free);
    const double size = body.stiffness.rounding(u.head(free.size())) / std::numeric_limits<double>::epsilon();
    EXPECT_LE(forces_of(body, u).norm(), 1e-14 * size);
    EXPECT_GT(u.norm(), 1);
  }
}

TEST(RigidRotation, MovesContactNodesAsItMovesTheBody)
{
  const LocalAxes axes = uneven_axes();
  const LoadableBody body(default_geometry, small_mesh(1), default_material, full, axes);
  const VectorXd free = VectorXd::Zero(body.discretization.n_free());
  for (unsigned int i = 0; i < n_rigid_components; ++i)
  {
    RigidMotion motion;
    motion[i] = 0.7;
    const VectorXd u = body.condensed.frame().with_motion(motion, free);
    const NodeVector moved = body.condensed.frame().moved_with(motion);
    const auto &nodes = body.discretization.contact_surface().nodes;
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      const auto &dofs = nodes[node].dofs;
      const Vector3d global = axes.global_in_local(node) * moved.segment<3>(3 * static_cast<Index>(node));
      EXPECT_LE((global - Vector3d(u[dofs[0]], u[dofs[1]], u[dofs[2]])).norm(), 1e-14);
    }
  }
}

TEST(RigidRotation, WrenchDoesTheWorkOfTheContactForces)
{
  const LoadableBody body(default_geometry, small_mesh(1), default_material, full, uneven_axes());
  const NodeVector force = uneven_forces(body.condensed.compliance().n_nodes());
  const Wrench wrench = body.condensed.frame().wrench(force);
  for (unsigned int seed = 1; seed <= 5; ++seed)
  {
    RigidMotion motion;
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      motion[i] = std::sin(seed + 0.7 * i * i);
    const double work = force.dot(body.condensed.frame().moved_with(motion));
    EXPECT_NEAR(wrench.work(motion), work,
                1e-12 * force.norm() * body.condensed.frame().moved_with(motion).norm());
  }
}
} // namespace orthocone::test
