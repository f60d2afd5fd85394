// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/bodies.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::VectorXd;

namespace
{
/// A smooth displacement that vanishes on the clamped top z = 10, and its strain.
struct Exact
{
  static dealii::Tensor<2, 3> gradient(const dealii::Point<3> &p)
  {
    const double depth = 10 - p[2];
    const double a = 0.2;
    const double s = std::sin(a * (p[0] + 2 * p[1]));
    const double c = std::cos(a * (p[0] + 2 * p[1]));
    // u = (depth s, depth^2 c / 10, depth (x y / 20 + s))
    dealii::Tensor<2, 3> g;
    g[0][0] = depth * a * c;
    g[0][1] = depth * 2 * a * c;
    g[0][2] = -s;
    g[1][0] = -depth * depth * a * s / 10;
    g[1][1] = -depth * depth * 2 * a * s / 10;
    g[1][2] = -2 * depth * c / 10;
    g[2][0] = depth * (p[1] / 20 + a * c);
    g[2][1] = depth * (p[0] / 20 + 2 * a * c);
    g[2][2] = -(p[0] * p[1] / 20 + s);
    return g;
  }
};

Stress exact_strain(const dealii::Point<3> &p)
{
  return symmetrize(Exact::gradient(p));
}

/// Energy norm of the error when the body is loaded by the forces of the exact displacement.
double energy_error(const unsigned int degree, const unsigned int n_cells,
                    const VolumetricQuadrature quadrature = VolumetricQuadrature::full)
{
  MeshOptions options;
  options.degree = degree;
  options.core_cells = n_cells;
  options.layers = n_cells;
  options.volumetric_quadrature = quadrature;
  const LoadableBody body(GeometryOptions(), options, default_material, SymmetryPlanes());
  const auto &discretization = body.discretization;
  const unsigned int n_points = degree + 2;
  const VectorXd load = internal_forces(
      discretization,
      [&](const dealii::FEValues<3> &values, const unsigned int q)
      { return stress_of(exact_strain(values.quadrature_point(q)), body.lame); },
      n_points);
  VectorXd u = VectorXd::Zero(discretization.n_dofs());
  u.head(discretization.n_free()) = body.factor.solve(load.head(discretization.n_free()));
  dealii::FEValues<3> values(discretization.mapping(), discretization.fe(), dealii::QGauss<3>(n_points),
                             dealii::update_gradients | dealii::update_quadrature_points |
                                 dealii::update_JxW_values);
  double energy = 0;
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(cell);
    const std::vector<Stress> strains = strains_in_cell(values, discretization.dof_handler(), u);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const Stress error = strains[q] - exact_strain(values.quadrature_point(q));
      energy += error * stress_of(error, body.lame) * values.JxW(q);
    }
  }
  return std::sqrt(energy);
}

/// A linear displacement is in every space, curved cells included: uniform stress to rounding.
void expect_uniform_compression(const MeshOptions &mesh, const double poisson)
{
  GeometryOptions geometry;
  geometry.top_face = TopFace::guided;
  MaterialOptions foam;
  foam.poisson_ratio = poisson;
  const LoadableBody body(geometry, mesh, foam, {true, true});
  const auto &nodes = body.discretization.contact_surface().nodes;
  constexpr double pressure = 100;
  NodeVector force(3 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    force.segment<3>(3 * static_cast<Eigen::Index>(i)) << pressure * nodes[i].area, 0, 0;
  const VectorXd u = volume_displacement(body.condensed, {}, force);
  const double strain = -pressure / foam.young_modulus;
  for (const ContactNode &node : nodes)
  {
    EXPECT_NEAR(u[node.dofs[2]], -strain * geometry.height, 1e-12);
    for (unsigned int d = 0; d < 2; ++d)
      EXPECT_NEAR(u[node.dofs[d]], -poisson * strain * node.position[d], 1e-12);
  }
}
} // namespace

TEST(Accuracy, EnergyErrorFallsWithTheOrderOfTheDegree)
{
  EXPECT_NEAR(std::log2(energy_error(1, 4) / energy_error(1, 8)), 1, 0.1);
  EXPECT_NEAR(std::log2(energy_error(2, 2) / energy_error(2, 4)), 2, 0.2);
  EXPECT_NEAR(std::log2(energy_error(3, 2) / energy_error(3, 4)), 3, 0.3);
}

TEST(Accuracy, ProjectedVolumetricQuadratureKeepsTheOrder)
{
  constexpr auto projected = VolumetricQuadrature::projected;
  EXPECT_NEAR(std::log2(energy_error(1, 4, projected) / energy_error(1, 8, projected)), 1, 0.1);
  EXPECT_NEAR(std::log2(energy_error(2, 2, projected) / energy_error(2, 4, projected)), 2, 0.2);
  EXPECT_NEAR(std::log2(energy_error(3, 3, projected) / energy_error(3, 5, projected)) / std::log2(5. / 3), 3,
              0.3);
}

TEST(Accuracy, PatchTestOnEveryDegreeAndGradedMeshes)
{
  for (const double poisson : {0.3, 0., -0.4, 0.49})
    for (const unsigned int degree : {1, 2, 3})
      for (const auto quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
      {
        MeshOptions mesh = small_mesh(degree);
        mesh.volumetric_quadrature = quadrature;
        expect_uniform_compression(mesh, poisson);
      }
}
} // namespace orthocone::test
