// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "multigrid/refined_body.h"

#include <orthocone/body/fe/cell_fields.h>
#include <orthocone/body/fe/stress_jumps.h>
#include <orthocone/body/materials/material.h>

#include <gtest/gtest.h>

#include <numeric>

namespace orthocone::test
{
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
constexpr double pressure_on_base = 100; // MPa

/// A quarter of a box that a plate presses on, free to widen: all stress is along the axis, and the same.
GeometryOptions guided_box()
{
  GeometryOptions geometry = shape_of(BodyShape::box);
  geometry.top_face = TopFace::guided;
  return geometry;
}

/// Its displacement without contact at the top.
VectorXd uniaxial(const Discretization &space, const double height)
{
  const double strain = pressure_on_base / default_material.young_modulus,
               nu = default_material.poisson_ratio;
  VectorXd displacement(space.n_free());
  for (unsigned int dof = 0; dof < space.n_free(); ++dof)
  {
    const Vector3d place = space.position(dof);
    const Vector3d moved(nu * place[0], nu * place[1], height - place[2]);
    displacement[dof] = strain * moved[space.direction(dof)];
  }
  return displacement;
}

VectorXd pressed_base(const Discretization &space)
{
  VectorXd forces = VectorXd::Zero(space.n_free());
  for (const ContactNode &node : space.contact_surface().nodes)
    forces[node.dofs[2]] = pressure_on_base * node.area;
  return forces;
}
} // namespace

/// The patch test: forces of a constant stress are those of the pressure on the base and nothing else, also
/// at nodes beside hanging ones. It needs their sums, the assembly and the areas of the contact nodes.
TEST(HangingNodes, LeaveAConstantStressConstant)
{
  for (const auto &[degree, quadrature] : {std::pair{1U, VolumetricQuadrature::full},
                                           {2U, VolumetricQuadrature::full},
                                           {3U, VolumetricQuadrature::full},
                                           {2U, VolumetricQuadrature::projected}})
  {
    MeshOptions mesh = uneven_mesh(degree);
    mesh.volumetric_quadrature = quadrature;
    const RefinedBody refined(guided_box(), mesh, quarter);
    const Discretization &space = refined.body.discretization;
    ASSERT_FALSE(space.contact_surface().hanging.empty());
    const VectorXd displacement = uniaxial(space, guided_box().sizes[2]), forces = pressed_base(space);
    EXPECT_LE((refined.body.stiffness.vmult(displacement) - forces).norm(), 1e-11 * forces.norm()) << degree;
    BodyVector<double> products = refined.stiffness.make_vector();
    refined.stiffness.vmult(products, refined.all(displacement));
    EXPECT_LE((refined.free(products) - forces).norm(), 1e-11 * forces.norm()) << degree;

    const VectorXd all = refined.body.condensed.frame().with_motion({}, displacement);
    CellFields<3> fields(space, Material(default_material), dealii::QGauss<3>(2), all);
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      for (const PointFields &point : fields.in(cell))
      {
        EXPECT_NEAR(point.stress[2][2], -pressure_on_base, 1e-9 * pressure_on_base);
        EXPECT_NEAR(point.stress[0][0], 0, 1e-9 * pressure_on_base);
      }
    EXPECT_LE(squared_jumps(space, all).maxCoeff(), 1e-20) << degree;
  }
}

/// A cell that alone is strained has half of the squared jumps, its neighbours the other half.
TEST(HangingNodes, JumpsAreSharedByBothSides)
{
  const RefinedBody refined(guided_box(), uneven_mesh(2), quarter);
  const Discretization &space = refined.body.discretization;
  const auto corner =
      std::find_if(space.contact_surface().nodes.begin(), space.contact_surface().nodes.end(),
                   [](const ContactNode &node) { return node.position[0] == 0 && node.position[1] == 0; });
  VectorXd free = VectorXd::Zero(space.n_free());
  free[corner->dofs[2]] = 1;
  const VectorXd jumps = squared_jumps(space, refined.body.condensed.frame().with_motion({}, free));
  std::vector<dealii::types::global_dof_index> dofs(space.fe().n_dofs_per_cell());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    cell->get_dof_indices(dofs);
    if (std::find(dofs.begin(), dofs.end(), corner->dofs[2]) != dofs.end())
    {
      EXPECT_NEAR(jumps[cell->active_cell_index()], 0.5 * jumps.sum(), 1e-6 * jumps.sum());
    }
  }
  EXPECT_GT(jumps.sum(), 0);
}

TEST(HangingNodes, ProductsAndDiagonalAreThoseOfTheMatrix)
{
  for (const auto &[degree, quadrature] : {std::pair{1U, VolumetricQuadrature::full},
                                           {2U, VolumetricQuadrature::full},
                                           {3U, VolumetricQuadrature::full},
                                           {1U, VolumetricQuadrature::projected},
                                           {2U, VolumetricQuadrature::projected},
                                           {3U, VolumetricQuadrature::projected}})
  {
    MeshOptions mesh = uneven_mesh(degree);
    mesh.volumetric_quadrature = quadrature;
    const RefinedBody refined(default_geometry, mesh, quarter);
    const Discretization &space = refined.body.discretization;
    const VectorXd displacement = random_numbers(space.n_free(), 1);
    const VectorXd forces = refined.body.stiffness.vmult(displacement);
    BodyVector<double> products = refined.stiffness.make_vector();
    refined.stiffness.vmult(products, refined.all(displacement));
    EXPECT_LE((refined.free(products) - forces).norm(), 1e-12 * forces.norm()) << degree;
    const BodyVector<double> diagonal = refined.stiffness.diagonal();
    for (unsigned int i = 0; i < space.n_free(); ++i)
    {
      const double expected = refined.body.stiffness.matrix().diag_element(i);
      EXPECT_NEAR(diagonal.local_element(i), expected, 1e-11 * expected);
    }
  }
}

TEST(HangingNodes, OfTheBaseLieBetweenContactNodes)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const RefinedBody refined(guided_box(), uneven_mesh(degree), quarter);
    const ContactSurface &surface = refined.body.discretization.contact_surface();
    double area = 0;
    for (const ContactNode &node : surface.nodes)
    {
      EXPECT_GT(node.area, 0);
      area += node.area;
    }
    const auto &sizes = guided_box().sizes;
    EXPECT_NEAR(area, sizes[0] * sizes[1] / 4, 1e-12 * sizes[0] * sizes[1]);
    for (const HangingNode &hanging : surface.hanging)
    {
      std::array<double, 2> place{};
      for (const auto &[node, weight] : hanging.terms)
        for (unsigned int d = 0; d < 2; ++d)
          place[d] += weight * surface.nodes[node].position[d];
      for (unsigned int d = 0; d < 2; ++d)
      {
        EXPECT_NEAR(place[d], hanging.place.position[d], 1e-12 * sizes[d]);
        EXPECT_EQ(hanging.place.is_free[d], hanging.place.position[d] != 0);
      }
    }
  }
}

/// The faces of the whole surface have no two nodes at one place, and cover it.
TEST(HangingNodes, AreMirroredAsContactNodesAre)
{
  const RefinedBody refined(guided_box(), uneven_mesh(2), quarter);
  const ContactSurface &surface = refined.body.discretization.contact_surface();
  const WholeSurface whole = ModelSymmetry(quarter).whole(surface);
  std::set<std::pair<long, long>> places;
  for (const WholeSurface::Node &node : whole.nodes)
  {
    const auto &position = surface.place(node.node).position;
    const Eigen::Vector2d place = whole.images[node.image] * Eigen::Vector2d(position[0], position[1]);
    EXPECT_TRUE(places.emplace(std::lround(1e6 * place[0]), std::lround(1e6 * place[1])).second);
  }
  EXPECT_EQ(whole.faces.size(), 4 * surface.faces.size());
  EXPECT_GT(whole.nodes.size(), 3 * surface.n_places());
}
} // namespace orthocone::test
