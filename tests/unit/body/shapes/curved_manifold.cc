// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Meshes of second order, and what follows their curves.
#include "body/bodies.h"
#include "body/curved_msh.h"

#include "folder_of_files.h"

#include <orthocone/body/body.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// Volume, or area of a section, of a mesh with elements of a degree.
template<int dim>
double size_of(const dealii::Triangulation<dim> &mesh, const unsigned int degree)
{
  const dealii::MappingQ<dim> mapping(degree);
  const dealii::FE_Q<dim> fe(1);
  dealii::FEValues<dim> values(mapping, fe, dealii::QGauss<dim>(degree + 2), dealii::update_JxW_values);
  double size = 0;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices())
      size += values.JxW(q);
  }
  return size;
}

/// Nodes of elements of a degree, cell by cell.
template<int dim>
std::vector<dealii::Point<dim>> nodes_of_mesh(const dealii::Triangulation<dim> &mesh,
                                              const unsigned int degree)
{
  const dealii::MappingQ<dim> mapping(degree);
  const dealii::FE_Q<dim> fe(degree);
  dealii::FEValues<dim> values(mapping, fe, dealii::Quadrature<dim>(fe.get_unit_support_points()),
                               dealii::update_quadrature_points);
  std::vector<dealii::Point<dim>> nodes;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    values.reinit(cell);
    nodes.insert(nodes.end(), values.get_quadrature_points().begin(), values.get_quadrature_points().end());
  }
  return nodes;
}

/// A map of second order without terms in which two squares meet, and with a known volume.
Place polynomial(const Place &u)
{
  return {{u[0] + 0.3 * u[0] * u[0], u[1] + 0.2 * u[1] * u[1], u[2] + 0.1 * u[2] * u[2] + 0.2 * u[0] * u[0]}};
}
constexpr double volume_of_polynomial = 1.3 * 1.2 * 1.1;

/// A part of a spherical shell between the radii 1 and 2, of the solid angle pi/6.
Place shell(const Place &u)
{
  const double a = std::tan(M_PI / 4 * u[0]), b = std::tan(M_PI / 4 * u[1]);
  const double radius = (1 + u[2]) / std::sqrt(1 + a * a + b * b);
  return {{a * radius, b * radius, radius}};
}

std::array<double, 2> half_ring(const double u, const double w)
{
  const double angle = M_PI * (u - 0.5), radius = 1 + w;
  return {{radius * std::cos(angle), radius * std::sin(angle)}};
}

GeometryOptions ring_section(const std::string &file)
{
  GeometryOptions geometry = imported(file);
  geometry.kind = GeometryKind::plane_strain;
  geometry.thickness = 3;
  geometry.faces_down = false;
  geometry.symmetry_surfaces = {"x min"};
  return geometry;
}
} // namespace

TEST(CurvedManifold, HasTheVolumeOfAMapOfSecondOrder)
{
  const Folder folder;
  for (const Hexahedra type : {Hexahedra::of_20_nodes, Hexahedra::of_27_nodes})
    for (const unsigned int n_halvings : {0, 1, 2})
      for (const unsigned int degree : {2, 3})
      {
        dealii::Triangulation<3> mesh;
        read_halved(imported(folder.write("cube.msh", mapped_cube({{2, 1, 2}}, type, polynomial).text())),
                    n_halvings, mesh);
        EXPECT_NEAR(size_of(mesh, degree), volume_of_polynomial, 1e-13);
      }
}

// Halved cells and elements of any degree have their nodes where the map has them.
TEST(CurvedManifold, HasAllNodesOnTheMap)
{
  const Folder folder;
  for (const Hexahedra type : {Hexahedra::of_20_nodes, Hexahedra::of_27_nodes})
  {
    dealii::Triangulation<3> mesh;
    read_halved(imported(folder.write("cube.msh", mapped_cube({{2, 2, 1}}, type, polynomial).text())), 1,
                mesh);
    for (const auto &node : nodes_of_mesh(mesh, 3))
    {
      const auto inverse = [](const double x, const double a) // of u + a u^2
      { return (std::sqrt(1 + 4 * a * x) - 1) / (2 * a); };
      const double u = inverse(node[0], 0.3), v = inverse(node[1], 0.2),
                   w = inverse(node[2] - 0.2 * u * u, 0.1);
      // Nodes between are at the Gauss-Lobatto points of cells of one size.
      for (const auto &[x, n] : {std::make_pair(u, 4), std::make_pair(v, 4), std::make_pair(w, 2)})
      {
        const double in_cell = x * n - std::floor(x * n + 1e-9);
        const double lobatto = 0.5 - std::sqrt(0.05);
        EXPECT_LE(std::min({std::abs(in_cell), std::abs(in_cell - lobatto), std::abs(in_cell - 1 + lobatto)}),
                  1e-12)
            << x;
      }
    }
  }
}

// Their geometry errs by O(h^4), because quadrature over a map of second order integrates r^2 so well.
TEST(CurvedManifold, ConvergesToARoundBody)
{
  const Folder folder;
  std::vector<double> errors, of_section, of_halved;
  for (const unsigned int n : {1, 2, 4})
  {
    dealii::Triangulation<3> mesh;
    GeometryOptions geometry =
        imported(folder.write("shell.msh", mapped_cube({{n, n, n}}, Hexahedra::of_27_nodes, shell).text()));
    read_halved(geometry, 0, mesh);
    errors.push_back(std::abs(size_of(mesh, 2) / (M_PI / 6 * 7 / 3) - 1));
    dealii::Triangulation<2> section;
    geometry = ring_section(
        folder.write("ring.msh", mapped_square({{2 * n, n}}, Hexahedra::of_27_nodes, half_ring)));
    ImportedMesh(geometry).copy_to(section);
    of_section.push_back(std::abs(size_of(section, 2) / (1.5 * M_PI) - 1));
    section.refine_global(1);
    of_halved.push_back(std::abs(size_of(section, 2) / (1.5 * M_PI) - 1));
  }
  for (const auto &all : {errors, of_section, of_halved})
  {
    EXPECT_GT(all[1] / all[2], 14) << all[1] << " " << all[2];
    EXPECT_LT(all[2], 2e-4);
  }
  for (unsigned int i = 0; i < 3; ++i) // cells that are halved keep the curves of the file
    EXPECT_NEAR(of_halved[i] / of_section[i], 1, 1e-9);
}

// The section of a layer, element by element, and its area times the thickness.
TEST(CurvedManifold, HasTheSectionOfTheSolid)
{
  const Folder folder;
  for (const Hexahedra type : {Hexahedra::of_20_nodes, Hexahedra::of_27_nodes})
  {
    const GeometryOptions plane =
        ring_section(folder.write("ring.msh", mapped_square({{4, 2}}, type, half_ring)));
    dealii::Triangulation<2> section;
    ImportedMesh(plane).copy_to(section);
    GeometryOptions solid = imported(folder.write("solid.msh", mapped_cube({{4, 1, 2}}, type,
                                                                           [](const Place &u)
                                                                           {
                                                                             const auto [x, z] =
                                                                                 half_ring(u[0], u[2]);
                                                                             return Place{{x, 3 * u[1], z}};
                                                                           })
                                                                   .text()));
    solid.faces_down = false;
    dealii::Triangulation<3> layer;
    ImportedMesh(solid).copy_to(layer);
    for (unsigned int round = 0; round < 2; ++round)
    {
      for (const unsigned int degree : {2, 3})
        EXPECT_NEAR(size_of(layer, degree), 3 * size_of(section, degree), 1e-12);
      section.refine_global(1);
      layer.refine_global(1);
    }
  }
}

// A surface that is named by its place holds the faces alone that lie there with all of their nodes.
TEST(CurvedManifold, HasNoBulgingFaceInAPlane)
{
  const Folder folder;
  const auto bulge = [](const Place &u) {
    return Place{{u[0], u[1], u[2] + (u[2] == 1 ? 0.1 * u[0] * (0.5 - u[0]) * (u[0] < 0.5 ? 1 : 0) : 0)}};
  };
  GeometryOptions geometry =
      imported(folder.write("cube.msh", mapped_cube({{2, 1, 1}}, Hexahedra::of_27_nodes, bulge).text()));
  geometry.held_surface = "z = 1";
  const std::string text = ImportedMesh(geometry).describe();
  EXPECT_NE(text.find("surface        z = 1: 1 faces, 0.5 mm^2"), std::string::npos) << text;
}

TEST(CurvedManifold, DescribesCurvedSizesWithoutWarnings)
{
  const Folder folder;
  GeometryOptions geometry =
      imported(folder.write("shell.msh", mapped_cube({{4, 4, 2}}, Hexahedra::of_27_nodes, shell).text()));
  const ImportedMesh mesh(geometry);
  const std::string text = mesh.describe();
  EXPECT_NE(text.find("volume         body (1): 32 cells, 1.221"), std::string::npos) << text;
  EXPECT_NE(text.find("surface        base (1): 16 faces, 0.523"), std::string::npos) << text;
  MeshOptions options;
  options.refinements = 1;
  EXPECT_TRUE(mesh.warnings(options).empty());
  options.degree = 1;
  ASSERT_EQ(mesh.warnings(options).size(), 1u);
  EXPECT_NE(mesh.warnings(options)[0].find("straight edges"), std::string::npos);
}

/// How much the bore of a thick ring under pressure lacks of Lame's solution where the plane of symmetry z =
/// 0 would be: u = p a^2 / (E (b^2 - a^2)) (1 + nu) ((1 - 2 nu) r + b^2 / r), here with nu = 0, r = a = 1 and
/// b = 2.
static double error_of_ring(const GeometryOptions &geometry, const unsigned int degree,
                            const unsigned int refinements = 0)
{
  constexpr double pressure = 7, modulus = 1000, exact = pressure / (3 * modulus) * (1 + 4);
  BodyOptions options;
  options.geometry = geometry;
  options.geometry.top_face = TopFace::free;
  options.material.young_modulus = modulus;
  options.material.poisson_ratio = 0;
  options.mesh.degree = degree;
  options.mesh.refinements = refinements;
  const Body body(options, ModelSymmetry::of_plane_strain(geometry.thickness, false, true));
  const Stiffness stiffness = body.stiffness(body.materials());
  const StiffnessFactor factor(stiffness.matrix(), body.unknowns().n_interior());
  const CondensedBody condensed(body.unknowns(), factor, LocalAxes(0));
  const auto &nodes = body.unknowns().contact_surface().nodes;
  NodeVector force = NodeVector::Zero(3 * static_cast<Eigen::Index>(nodes.size())), moved;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Eigen::Vector3d push = pressure * nodes[i].area_vector;
    force.segment<3>(3 * static_cast<Eigen::Index>(i)) = Eigen::Vector3d(push[2], push[0], push[1]);
  }
  condensed.compliance().vmult(moved, force);
  double error = 1;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (std::abs(nodes[i].height) < 1e-9)
      error = std::abs(moved[3 * static_cast<Eigen::Index>(i) + 1] / exact - 1);
  return error;
}

// Displacements converge with the elements: where a file has more of them, and where they are halved.
TEST(CurvedManifold, IsLamesRing)
{
  const Folder folder;
  for (const unsigned int degree : {2, 3})
  {
    std::vector<double> errors;
    for (const unsigned int n : {2, 4, 8})
      errors.push_back(
          error_of_ring(ring_section(folder.write(
                            "ring.msh", mapped_square({{2 * n, n}}, Hexahedra::of_27_nodes, half_ring))),
                        degree));
    EXPECT_GT(errors[1] / errors[2], 12) << errors[1] << " " << errors[2];
    EXPECT_LT(errors[2], 1e-5);
  }
}

TEST(CurvedManifold, IsLamesRingOfHalvedCellsOnNamedCylinders)
{
  const Folder folder;
  GeometryOptions geometry =
      ring_section(folder.write("ring.msh", mapped_square({{4, 2}}, Hexahedra::of_8_nodes, half_ring)));
  for (const char *const surface : {"base", "top"})
    geometry.curved_surfaces.push_back({surface, SurfaceKind::cylinder, {}, {{0, 1, 0}}});
  for (const unsigned int degree : {2, 3})
  {
    std::vector<double> errors;
    for (const unsigned int refinements : {1, 2, 3})
      errors.push_back(error_of_ring(geometry, degree, refinements));
    EXPECT_GT(errors[1] / errors[2], std::pow(2, degree + 1)) << errors[1] << " " << errors[2];
    EXPECT_LT(errors[2], degree == 2 ? 2e-5 : 2e-7);
  }
}
} // namespace orthocone::test
