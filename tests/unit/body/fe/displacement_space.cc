// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The axisymmetric body: weights of its contact nodes, and its stiffness against a manufactured solution.
#include <orthocone/base/numbers.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/materials/lame.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/surface/local_axes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// Rectangles, cut in half `n_refinements` times.
MeshOptions section_options(const unsigned int degree, const unsigned int n_refinements = 0)
{
  MeshOptions options;
  options.degree = degree;
  options.core_cells = 4 << n_refinements;
  options.rings = 3 << n_refinements;
  options.layers = 3 << n_refinements;
  options.volumetric_quadrature = VolumetricQuadrature::full; // energies bound each other from one side
  return options;
}

struct SectionBody
{
  explicit SectionBody(const MeshOptions &options, const GeometryOptions &geometry_ = {})
      : geometry(geometry_),
        mesh(geometry, options),
        discretization(mesh.triangulation(), options, geometry.top_face)
  {
  }

  GeometryOptions geometry;
  SectionMesh mesh;
  SectionDiscretization discretization;
};

/// A smooth displacement that vanishes at the top, u_r odd and u_z even in r, and its strain (rr, zz, hoop,
/// 2 rz).
struct Manufactured
{
  explicit Manufactured(const GeometryOptions &geometry)
      : radius(geometry.radius),
        height(geometry.height)
  {
  }

  Eigen::Vector4d strain(const double r, const double z) const
  {
    const double s = r / radius;
    const double t = z / height;
    // u_r = s (1 - t) exp(s^2 + t), u_z = (1 - t^2) cos(s^2)
    const double e = std::exp(s * s + t);
    return {(1 + 2 * s * s) * (1 - t) * e / radius, -2 * t * std::cos(s * s) / height, (1 - t) * e / radius,
            -s * t * e / height - 2 * s * std::sin(s * s) * (1 - t * t) / radius};
  }

  double radius;
  double height;
};

/// Stress (rr, zz, hoop, rz).
Eigen::Vector4d revolved_stress(const Eigen::Vector4d &strain, const LameParameters &lame)
{
  const double pressure = lame.lambda * (strain[0] + strain[1] + strain[2]);
  return {pressure + 2 * lame.mu * strain[0], pressure + 2 * lame.mu * strain[1],
          pressure + 2 * lame.mu * strain[2], lame.mu * strain[3]};
}

/// Work of the manufactured stress, weighted with ring and quadrature, on the shape functions of a cell.
Eigen::VectorXd loads_at(const dealii::FEValues<2> &values, const unsigned int q,
                         const Eigen::Vector4d &stress)
{
  const double r = values.quadrature_point(q)[0];
  Eigen::VectorXd loads(2 * values.dofs_per_cell);
  for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
  {
    const auto gradient = values.shape_grad(a, q);
    loads[2 * a] =
        stress[0] * gradient[0] + stress[2] * values.shape_value(a, q) / r + stress[3] * gradient[1];
    loads[2 * a + 1] = stress[1] * gradient[1] + stress[3] * gradient[0];
  }
  return loads;
}

/// Adds the loads of a cell, numbered node by node, to the forces on the free unknowns.
void add_to_free(const SectionDiscretization &discretization,
                 const dealii::DoFHandler<2>::active_cell_iterator &cell, const Eigen::VectorXd &loads,
                 Eigen::VectorXd &forces)
{
  std::vector<dealii::types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  for (unsigned int i = 0; i < dofs.size(); ++i)
  {
    const auto [component, node] = discretization.fe().system_to_component_index(i);
    if (dofs[i] < discretization.n_free())
      forces[dofs[i]] += loads[2 * node + component];
  }
}

/// Error in the energy norm, relative, of the Galerkin solution for the loads of the manufactured one: the
/// energies differ by its square.
double revolved_energy_error(const unsigned int degree, const unsigned int n_refinements)
{
  const MaterialOptions material;
  const SectionBody body(section_options(degree, n_refinements));
  const LameParameters lame(material);
  const Manufactured exact(body.geometry);
  const SectionDiscretization &discretization = body.discretization;
  dealii::FEValues<2> values(discretization.mapping(), discretization.scalar_fe(),
                             dealii::QGauss<2>(degree + 4),
                             dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                 dealii::update_quadrature_points);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(discretization.n_free());
  double energy = 0;
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(dealii::Triangulation<2>::active_cell_iterator(cell));
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(2 * values.dofs_per_cell);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const auto place = values.quadrature_point(q);
      const Eigen::Vector4d strain = exact.strain(place[0], place[1]);
      const Eigen::Vector4d stress = 2 * pi * place[0] * values.JxW(q) * revolved_stress(strain, lame);
      energy += stress.dot(strain);
      loads += loads_at(values, q, stress);
    }
    if (discretization.has_axis_face(cell))
      loads = discretization.axis_face_basis().transpose() * loads;
    add_to_free(discretization, cell, loads, forces);
  }
  const Stiffness stiffness(discretization, material);
  const StiffnessFactor factor(stiffness.matrix(), discretization.n_interior());
  return std::sqrt((energy - forces.dot(factor.solve(forces))) / energy);
}
} // namespace

// At the axis most of all: the nodes of FE_Q have no weight there.
TEST(Section, ContactNodesHavePositiveWeightsThatIntegratePolynomials)
{
  for (const unsigned int degree : {1, 2, 3, 4})
    for (const unsigned int core_cells : {1, 3, 4})
    {
      MeshOptions options = section_options(degree);
      options.core_cells = core_cells;
      options.rim_grading = 0.6;
      const SectionBody body(options);
      const auto &nodes = body.discretization.contact_surface().nodes;
      const double radius = body.geometry.radius;
      EXPECT_EQ(nodes.size(), degree * ((core_cells + 1) / 2 + options.rings) + 1);
      for (unsigned int power = 0; power <= std::max(degree, 2 * degree - 2); ++power)
      {
        double integral = 0;
        for (const ContactNode &node : nodes)
        {
          EXPECT_GT(node.area, 1e-5 * radius * radius);
          integral += node.area * std::pow(node.position[0] / radius, power);
        }
        EXPECT_NEAR(integral, 2 * pi * radius * radius / (power + 2), 1e-12 * radius * radius)
            << "degree " << degree << ", power " << power;
      }
    }
}

TEST(Section, HoldsTopAndAxisOnly)
{
  for (const TopFace top : {TopFace::clamped, TopFace::guided})
  {
    GeometryOptions geometry;
    geometry.top_face = top;
    const unsigned int degree = 3;
    const MeshOptions options = section_options(degree);
    const SectionBody body(options, geometry);
    const unsigned int n_r = degree * (options.core_cells / 2 + options.rings) + 1;
    const unsigned int n_z = degree * options.layers + 1;
    const unsigned int n_held = (top == TopFace::clamped ? 2 : 1) * n_r + n_z - (top == TopFace::clamped);
    EXPECT_EQ(body.discretization.n_dofs(), 2 * n_r * n_z);
    EXPECT_EQ(body.discretization.n_free(), 2 * n_r * n_z - n_held);
    EXPECT_EQ(body.discretization.n_free() - body.discretization.n_interior(), 2 * n_r - 1);
    for (const ContactNode &node : body.discretization.contact_surface().nodes)
      EXPECT_EQ(node.is_free, (std::array<bool, 3>{{node.position[0] > 0, false, true}}));
  }
}

TEST(Section, ConvergesWithItsDegree)
{
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    const double coarse = revolved_energy_error(degree, 0);
    const double fine = revolved_energy_error(degree, 1);
    EXPECT_NEAR(std::log2(coarse / fine), degree, 0.15) << coarse << " " << fine;
  }
}

// The reduced quadrature, too: with the factor r, one Gauss point would not integrate the pressure exactly.
TEST(Section, CompressesUniformly)
{
  GeometryOptions geometry;
  geometry.top_face = TopFace::guided;
  const MaterialOptions material;
  constexpr double pressure = 100;
  const double strain = -pressure / material.young_modulus;
  for (const unsigned int degree : {1, 2, 3, 4})
    for (const auto quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
    {
      MeshOptions options = section_options(degree);
      options.volumetric_quadrature = quadrature;
      const SectionBody body(options, geometry);
      const Stiffness stiffness(body.discretization, material);
      const StiffnessFactor factor(stiffness.matrix(), body.discretization.n_interior());
      const auto &nodes = body.discretization.contact_surface().nodes;
      Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.discretization.n_free());
      for (const ContactNode &node : nodes)
        forces[node.dofs[2]] = pressure * node.area;
      const Eigen::VectorXd u = factor.solve(forces);
      for (const ContactNode &node : nodes)
      {
        EXPECT_NEAR(u[node.dofs[2]], -strain * geometry.height, 1e-12);
        if (node.is_free[0])
        {
          EXPECT_NEAR(u[node.dofs[0]], -material.poisson_ratio * strain * node.position[0], 1e-12);
        }
      }
    }
}
} // namespace orthocone::test
