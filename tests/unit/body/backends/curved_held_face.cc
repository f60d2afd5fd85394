// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A held face that is no plane, and inclined: it moves as a rigid one, and carries what the contact puts on
// it.
#include "body/bodies.h"
#include "body/msh.h"
#include "folder_of_files.h"

#include <deal.II/dofs/dof_tools.h>

#include <gtest/gtest.h>

#include <set>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double length = 8;

/// A block between a bowl and a roof that is inclined, vaulted and twisted. Nothing of it is symmetric.
Msh roofed_block()
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{length, length, length}};
  MeshOptions mesh;
  mesh.cells = {{4, 4, 3}};
  Msh block(BodyMesh(geometry, mesh, full).triangulation());
  for (auto &[x, y, z] : block.nodes)
  {
    const double high = z / length;
    z += high * (1 + 0.2 * x - 0.1 * x * x + 0.05 * y * y * y + 0.03 * x * y) +
         (1 - high) * 0.02 * (x * x + 2 * y * y);
    x += high * 0.1 * y * y;
  }
  return block;
}

struct RoofedBody
{
  explicit RoofedBody(const MeshOptions &mesh)
      : body(imported(folder.write("block.msh", roofed_block().text())), mesh, default_material, full)
  {
  }

  Vector3d arm(const dealii::Point<3> &place) const
  {
    return Vector3d(place[0], place[1], place[2]) - body.discretization.held_centre();
  }

  /// Where the contact nodes are, not projected, relative to the centre of the held face.
  std::vector<Vector3d> contact_arms() const
  {
    const auto positions = dof_positions(body.discretization);
    std::vector<Vector3d> arms;
    for (const auto &node : body.discretization.contact_surface().nodes)
      arms.push_back(arm(positions[node.dofs[2]]));
    return arms;
  }

  /// Internal forces at all degrees of freedom, by quadrature of its own.
  VectorXd internal(const VectorXd &u) const
  {
    const auto &space = body.discretization;
    return internal_forces(
        space,
        [&](const dealii::FEValues<3> &values, const unsigned int q)
        { return stress_of(strains_in_cell(values, space.dof_handler(), u)[q], body.lame); },
        space.n_quadrature_points());
  }

  Folder folder;
  LoadableBody body;
};

/// Unit vectors of all degrees of freedom.
Eigen::Matrix3Xd directions(const Discretization &space)
{
  Eigen::Matrix3Xd units = Eigen::Matrix3Xd::Zero(3, space.n_dofs());
  for (unsigned int d = 0; d < 3; ++d)
  {
    dealii::ComponentMask component(3, false);
    component.set(d, true);
    for (const auto dof : dealii::DoFTools::extract_dofs(space.dof_handler(), component))
      units(d, static_cast<Index>(dof)) = 1;
  }
  return units;
}

std::vector<MeshOptions> meshes()
{
  std::vector<MeshOptions> all(3);
  all[0].degree = 1;
  all[1].degree = 2;
  all[1].volumetric_quadrature = VolumetricQuadrature::full; // as internal_forces()
  all[2].degree = 1;
  all[2].refinements = 1;
  return all;
}

RigidMotion uneven_motion()
{
  RigidMotion motion;
  motion.components << 0.01, -0.02, -0.1, 0.3, -0.2, 0.5;
  return motion;
}
} // namespace

TEST(CurvedHeldFace, MovesTheBodyWithoutStrain)
{
  for (const MeshOptions &mesh : meshes())
  {
    const RoofedBody roofed(mesh);
    const LoadableBody &body = roofed.body;
    const VectorXd free = VectorXd::Zero(body.discretization.n_free());
    const VectorXd u = body.condensed.frame().with_motion(uneven_motion(), free);
    const double size = body.stiffness.rounding(u.head(free.size())) / std::numeric_limits<double>::epsilon();
    EXPECT_LE(roofed.internal(u).norm(), 1e-14 * size);
    const NodeVector moved = body.condensed.frame().moved_with(uneven_motion());
    const auto arms = roofed.contact_arms();
    for (std::size_t i = 0; i < arms.size(); ++i)
    {
      const Vector3d expected = uneven_motion().at(arms[i]),
                     found = moved.segment<3>(3 * static_cast<Index>(i));
      EXPECT_LE((Vector3d(found[1], found[2], found[0]) - expected).norm(), 1e-13 * length);
    }
  }
}

TEST(CurvedHeldFace, CarriesForceAndMomentOfTheContact)
{
  for (const MeshOptions &mesh : meshes())
  {
    const RoofedBody roofed(mesh);
    const auto &space = roofed.body.discretization;
    const NodeVector force = uneven_forces(roofed.body.condensed.compliance().n_nodes());
    const VectorXd internal =
        roofed.internal(volume_displacement(roofed.body.condensed, uneven_motion(), force));
    const auto positions = dof_positions(space);
    Wrench held, contact;
    std::set<int> heights; // in hundredths of a mm
    const Eigen::Matrix3Xd axes = directions(space);
    for (auto dof = static_cast<Index>(space.n_free()); dof < internal.size(); ++dof)
    {
      const auto &place = positions[static_cast<std::size_t>(dof)];
      held.add(internal[dof] * axes.col(dof), roofed.arm(place));
      heights.insert(static_cast<int>(100 * place[2]));
    }
    EXPECT_GT(heights.size(), 10U); // it is curved
    const auto arms = roofed.contact_arms();
    for (std::size_t i = 0; i < arms.size(); ++i)
    {
      const Vector3d local = force.segment<3>(3 * static_cast<Index>(i));
      contact.add({local[1], local[2], local[0]}, arms[i]);
    }
    const Wrench wrench = roofed.body.condensed.frame().wrench(force);
    EXPECT_LE((wrench.components - contact.components).norm(), 1e-12 * length * force.norm());
    EXPECT_LE((held.force() + contact.force()).norm(), 1e-9 * force.norm());
    EXPECT_LE((held.moment() + contact.moment()).norm(), 1e-9 * length * force.norm());
    EXPECT_GT(contact.moment().norm(), 0.1 * force.norm());
  }
}
} // namespace orthocone::test
