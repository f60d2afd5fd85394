// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/even_mesh.h"
#include "body/fe/known_tractions.h"

#include <orthocone/body/body_points.h>
#include <orthocone/body/fe/recovered_stress.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A displacement (mm) and its gradient by place.
struct Field
{
  std::function<Vector3d(const Vector3d &)> displacement;
  std::function<Matrix3d(const Vector3d &)> gradient;
};

/// x^n + x^(n-1) z along x, y^n along y, z^n - x z^(n-1) along z, each over 1000 times the n-th power of 4
/// mm.
Field power(const unsigned int n)
{
  const double scale = 1e-3 / std::pow(4., n);
  const auto to = [](const double x, const unsigned int exponent) { return std::pow(x, double(exponent)); };
  return {[=](const Vector3d &p) -> Vector3d
          {
            return scale * Vector3d(to(p[0], n) + to(p[0], n - 1) * p[2], to(p[1], n),
                                    to(p[2], n) - p[0] * to(p[2], n - 1));
          },
          [=](const Vector3d &p) -> Matrix3d
          {
            Matrix3d g = Matrix3d::Zero();
            g(0, 0) = n * to(p[0], n - 1) + (n > 1 ? (n - 1) * to(p[0], n - 2) * p[2] : 0);
            g(0, 2) = to(p[0], n - 1);
            g(1, 1) = n * to(p[1], n - 1);
            g(2, 0) = -to(p[2], n - 1);
            g(2, 2) = n * to(p[2], n - 1) - (n > 1 ? (n - 1) * p[0] * to(p[2], n - 2) : 0);
            return scale * g;
          }};
}

Stress stress_of(const Field &field, const Vector3d &place)
{
  const Matrix3d g = field.gradient(place);
  Strain strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = (g(i, j) + g(j, i)) / 2;
  return Material(MaterialOptions()).stress(strain);
}

Eigen::VectorXd interpolated(const BodyUnknowns &unknowns, const Field &field)
{
  Eigen::VectorXd displacement(unknowns.n_dofs());
  for (unsigned int dof = 0; dof < unknowns.n_dofs(); ++dof)
    displacement[dof] = field.displacement(unknowns.position(dof))[unknowns.direction(dof)];
  return displacement;
}

BodyOptions block(const MeshOptions &mesh)
{
  BodyOptions options;
  options.geometry.shape = BodyShape::box;
  options.geometry.sizes = {{8, 6, 4}};
  options.mesh = mesh;
  return options;
}

/// The largest errors of the stress at the points of a grid in each cell, over the largest stress: of the
/// recovered one, and of that of the cells.
struct Errors
{
  double recovered = 0, of_cells = 0;
};

Errors errors_on(const Body &body, const Field &field)
{
  Errors errors;
  double largest = 0;
  body.visit(
      [&](const auto &space)
      {
        constexpr int dim = std::decay_t<decltype(space)>::dimension;
        const Deformation deformation{interpolated(space, field)};
        const dealii::QIterated<dim> points(dealii::QTrapezoid<1>(), 3);
        CellFields<dim> of_cells(space, body.materials(), points, deformation.displacement);
        RecoveredStress<dim> recovered(space, body.materials(), deformation);
        for (const auto &cell : space.dof_handler().active_cell_iterators())
        {
          std::vector<PointFields> at = of_cells.in(cell);
          const std::vector<PointFields> plain = at;
          recovered.enter(cell, points.get_points(), at);
          for (std::size_t i = 0; i < at.size(); ++i)
          {
            const Stress exact = stress_of(field, at[i].place);
            largest = std::max(largest, exact.norm());
            errors.recovered = std::max(errors.recovered, (at[i].stress - exact).norm());
            errors.of_cells = std::max(errors.of_cells, (plain[i].stress - exact).norm());
            EXPECT_GE(at[i].stress_error + 1e-12,
                      std::sqrt(1.5) * deviator(at[i].stress - plain[i].stress).norm());
          }
        }
      });
  return {errors.recovered / largest, errors.of_cells / largest};
}
} // namespace

// The stress of a displacement of degree p + 1 has degree p, which cells of degree p do not have but in their
// Gauss points. Full quadrature: the projected change of volume has a lower degree.
TEST(RecoveredStress, HasAPolynomialOfTheDegreeOfTheCells)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    MeshOptions mesh = even_mesh(degree, 1);
    mesh.volumetric_quadrature = VolumetricQuadrature::full;
    const Errors errors = errors_on(Body(block(mesh), ModelSymmetry()), power(degree + 1));
    EXPECT_LE(errors.recovered, 1e-10) << "degree " << degree;
    EXPECT_GE(errors.of_cells, 1e-3) << "degree " << degree;
  }
}

TEST(RecoveredStress, IsMoreAccurateByAnOrderAtTheSurface)
{
  const auto wave = [](const double k) -> Field
  {
    return {[=](const Vector3d &p) -> Vector3d {
              return 1e-3 *
                     Vector3d(std::sin(k * (5 * p[0] + 3 * p[2])), 0, std::cos(k * (4 * p[0] - 5 * p[2])));
            },
            [=](const Vector3d &p) -> Matrix3d
            {
              const double c = std::cos(k * (5 * p[0] + 3 * p[2])), s = std::sin(k * (4 * p[0] - 5 * p[2]));
              Matrix3d g = Matrix3d::Zero();
              g.row(0) << 5 * c, 0, 3 * c;
              g.row(2) << -4 * s, 0, 5 * s;
              return 1e-3 * k * g;
            }};
  };
  for (const VolumetricQuadrature quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
    for (const unsigned int degree : {1, 2, 3})
    {
      std::vector<Errors> errors;
      for (const unsigned int refinements : {3, 4})
      {
        MeshOptions mesh = even_mesh(degree, refinements);
        mesh.volumetric_quadrature = quadrature;
        errors.push_back(errors_on(Body(block(mesh), ModelSymmetry::of_plane_strain(6, false)),
                                   wave(degree < 3 ? 0.1 : 0.04)));
      }
      EXPECT_NEAR(std::log2(errors[0].of_cells / errors[1].of_cells), degree, 0.35) << "degree " << degree;
      // The wide patches of degree 3 come to their order on finer meshes.
      EXPECT_GE(std::log2(errors[0].recovered / errors[1].recovered), degree + (degree < 3 ? 0.65 : 0.4))
          << "degree " << degree;
      EXPECT_LE(errors[1].recovered, (degree < 3 ? 0.6 : 1) * errors[1].of_cells) << "degree " << degree;
    }
}

// The stress has the corner that it has at the edge of a contact. Polynomials of a patch would smear it.
TEST(RecoveredStress, IsAsGoodAsThatOfTheCellsWhereStressHasACorner)
{
  const Field corner{[](const Vector3d &p) -> Vector3d {
                       return {std::pow(std::max(p[0] - 0.37, 0.), 1.5) / 1000, 0, 0};
                     },
                     [](const Vector3d &p) -> Matrix3d
                     { return Vector3d(1.5e-3 * std::sqrt(std::max(p[0] - 0.37, 0.)), 0, 0).asDiagonal(); }};
  for (const unsigned int degree : {1, 2, 3})
  {
    const Errors errors =
        errors_on(Body(block(even_mesh(degree, 3)), ModelSymmetry::of_plane_strain(6, false)), corner);
    EXPECT_LE(errors.recovered, 1.2 * errors.of_cells) << "degree " << degree;
  }
}

// The patches of a quarter are those of the whole body.
TEST(RecoveredStress, IsThatOfTheWholeBodyInItsModels)
{
  const Field even{
      [](const Vector3d &p) -> Vector3d
      { return 1e-3 * Vector3d(std::sin(p[0]) * p[2], std::pow(p[1], 3) / 9, std::cos(p[0] * p[1]) * p[2]); },
      {}};
  const auto near_planes = [&](const SymmetryPlanes &planes)
  {
    const Body body(block(even_mesh(2, 1)), planes);
    const BodyPoints points(
        body, {{0, 0, 0}, {0, 0, 1.3}, {0, 1.1, 0}, {0.7, 0, 0}, {0.3, 0.2, 0.1}, {2.1, 0.4, 2.2}});
    return points.fields({interpolated(body.unknowns(), even)});
  };
  const auto of_whole = near_planes({}), of_quarter = near_planes({true, true});
  for (std::size_t i = 0; i < of_whole.size(); ++i)
    EXPECT_LE((of_whole[i].stress - of_quarter[i].stress).norm(), 1e-9 * of_whole[i].stress.norm()) << i;
}

// A traction on the surface, with the strain in it that it had.
TEST(RecoveredStress, TakesATractionAndLeavesTheStrainInTheSurface)
{
  const Material material{MaterialOptions()};
  Strain strain;
  strain[0][0] = 1e-3;
  strain[1][1] = -2e-3;
  strain[0][1] = 4e-4;
  strain[0][2] = 3e-4;
  strain[2][2] = 5e-4;
  const Vector3d normal = Vector3d(1, 2, -2) / 3, traction(100, -50, 20);
  const Stress stress = with_traction(material.stress(strain), material, {normal, traction});
  Matrix3d matrix;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      matrix(i, j) = stress[i][j];
  EXPECT_LE((matrix * normal - traction).norm(), 1e-10);
  const LameParameters lame{MaterialOptions()};
  const double spherical = lame.lambda / (3 * lame.lambda + 2 * lame.mu) * trace(stress);
  const Strain found = (stress - spherical * dealii::unit_symmetric_tensor<3>()) / (2 * lame.mu);
  const Strain change = found - strain;
  for (const Vector3d &along : {Vector3d(2, -1, 0), Vector3d(2, 0, 1), Vector3d(4, -1, 1)})
  {
    double elongation = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        elongation += along[i] * change[i][j] * along[j];
    EXPECT_NEAR(elongation, 0, 1e-12);
  }
}
} // namespace orthocone::test
