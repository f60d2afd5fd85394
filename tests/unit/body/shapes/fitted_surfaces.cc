// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Geometry/Curved surfaces: nodes of halved and curved cells lie on the surfaces that it names.
#include "body/curved_msh.h"

#include "folder_of_files.h"
#include "rejection.h"

#include <orthocone/body/body.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// A quarter of a hollow cylinder along the axis y, off the origin, of radii 4 and 6; its base is the bore.
Place pipe(const Place &u)
{
  const double angle = M_PI * (u[0] / 2 + 0.25), radius = 4 + 2 * u[2];
  return {{1 - radius * std::cos(angle), 5 * u[1], radius * std::sin(angle)}};
}

/// A part of a ball of radius 3 about (0, 0, 3) between planes that do not pass through its centre, x = 1 and
/// 2, y = 0.5 and 1.7; its base is the sphere.
Place cap(const Place &u)
{
  const double x = 1 + u[0], y = 0.5 + 1.2 * u[1], low = 3 - std::sqrt(9 - x * x - y * y);
  return {{x, y, low + u[2] * (4 - low)}};
}

GeometryOptions with_surfaces(const std::string &file, std::vector<CurvedSurface> surfaces)
{
  GeometryOptions geometry = imported(file);
  geometry.curved_surfaces = std::move(surfaces);
  return geometry;
}

CurvedSurface cylinder(const std::string &name, const Place &through, const Place &along)
{
  return {name, SurfaceKind::cylinder, through, along};
}

/// The largest departure of the nodes of elements of degree 3 on the boundary `id` from a measure.
template<typename Measure>
double departure(const dealii::Triangulation<3> &mesh, const dealii::types::boundary_id id,
                 const Measure &measure)
{
  const dealii::MappingQ<3> mapping(3);
  const dealii::FE_Q<3> fe(3);
  dealii::FEFaceValues<3> values(mapping, fe,
                                 dealii::Quadrature<2>(dealii::FE_Q<2>(3).get_unit_support_points()),
                                 dealii::update_quadrature_points);
  double largest = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->at_boundary(face) && cell->face(face)->boundary_id() == id)
      {
        values.reinit(cell, face);
        for (const auto &point : values.get_quadrature_points())
          largest = std::max(largest, std::abs(measure(point)));
      }
  return largest;
}
} // namespace

TEST(FittedSurfaces, CylindersHaveAllNodes)
{
  const Folder folder;
  for (const Hexahedra type : {Hexahedra::of_8_nodes, Hexahedra::of_20_nodes, Hexahedra::of_27_nodes})
    for (const unsigned int n_halvings : {0, 1, 2})
    {
      dealii::Triangulation<3> mesh;
      read_halved(with_surfaces(folder.write("pipe.msh", mapped_cube({{2, 1, 1}}, type, pipe).text()),
                                {cylinder("base", {{1, 7, 0}}, {{0, -3, 0}}),
                                 cylinder("top", {{1, 0, 0}}, {{0, 1, 0}})}),
                  n_halvings, mesh);
      const auto off = [](const double radius)
      { return [radius](const auto &x) { return std::hypot(x[0] - 1, x[2]) - radius; }; };
      EXPECT_LE(departure(mesh, Boundary::contact_surface, off(4)), 1e-12);
      EXPECT_LE(departure(mesh, Boundary::top_face, off(6)), 1e-12);
    }
}

// Planes that meet the sphere at an angle stay planes.
TEST(FittedSurfaces, SpheresHaveAllNodesAndLeavePlanesPlane)
{
  const Folder folder;
  for (const Hexahedra type : {Hexahedra::of_8_nodes, Hexahedra::of_27_nodes})
    for (const unsigned int n_halvings : {0, 1})
    {
      dealii::Triangulation<3> mesh;
      read_halved(with_surfaces(folder.write("cap.msh", mapped_cube({{2, 2, 1}}, type, cap).text()),
                                {{"base", SurfaceKind::sphere, {{0, 0, 3}}, {}}}),
                  n_halvings, mesh);
      const auto off_sphere = [](const auto &x) { return x.distance(dealii::Point<3>(0, 0, 3)) - 3; };
      EXPECT_LE(departure(mesh, Boundary::contact_surface, off_sphere), 1e-12);
      EXPECT_LE(departure(mesh, Boundary::top_face, [](const auto &x) { return x[2] - 4; }), 1e-12);
      const auto off_sides = [](const auto &x) {
        return std::min({std::abs(x[0] - 1), std::abs(x[0] - 2), std::abs(x[1] - 0.5), std::abs(x[1] - 1.7)});
      };
      EXPECT_LE(departure(mesh, Boundary::lateral_surface, off_sides), 1e-12);
    }
}

// The section of a solid follows the arc, too, and its area converges with the degree of the cells.
TEST(FittedSurfaces, SectionsHaveAllNodes)
{
  const Folder folder;
  const auto ring = [](const double u, const double w)
  {
    const Place at = pipe({{u, 0, w}});
    return std::array<double, 2>{{at[0], at[2]}};
  };
  GeometryOptions geometry =
      with_surfaces(folder.write("ring.msh", mapped_square({{2, 1}}, Hexahedra::of_8_nodes, ring)),
                    {cylinder("base", {{1, 0, 0}}, {{0, 2, 0}}), cylinder("top", {{1, 0, 0}}, {{0, 1, 0}})});
  geometry.kind = GeometryKind::plane_strain;
  BodyOptions options;
  options.geometry = geometry;
  options.mesh.degree = 3;
  for (const unsigned int refinements : {0, 1, 3})
  {
    options.mesh.refinements = refinements;
    const Body body(options, ModelSymmetry::of_plane_strain(1, false, false));
    for (const ContactNode &node : body.unknowns().contact_surface().nodes)
      EXPECT_NEAR(std::hypot(node.position[0] - 1, node.height), 4, 1e-12);
  }
}

// The other surfaces of a file of first order keep their facets, of which there is a warning.
TEST(FittedSurfaces, AreNoFacets)
{
  const Folder folder;
  const std::string file =
      folder.write("pipe.msh", mapped_cube({{4, 1, 1}}, Hexahedra::of_8_nodes, pipe).text());
  MeshOptions halved;
  halved.refinements = 1;
  const CurvedSurface base = cylinder("base", {{1, 0, 0}}, {{0, 1, 0}}),
                      top = cylinder("top", {{1, 0, 0}}, {{0, 1, 0}});
  EXPECT_EQ(ImportedMesh(with_surfaces(file, {})).warnings(halved).size(), 1u);
  EXPECT_EQ(ImportedMesh(with_surfaces(file, {base})).warnings(halved).size(), 1u);
  EXPECT_TRUE(ImportedMesh(with_surfaces(file, {base, top})).warnings(halved).empty());
}

TEST(FittedSurfaces, NodesBesideThemAreRefused)
{
  const Folder folder;
  const auto complaint = [&](const GeometryOptions &geometry)
  {
    BodyOptions body;
    body.geometry = geometry;
    return rejection_of(
        [&]
        {
          check_body(body);
          const ImportedMesh mesh(geometry);
        });
  };
  const std::string file =
      folder.write("pipe.msh", mapped_cube({{2, 1, 1}}, Hexahedra::of_8_nodes, pipe).text());
  const std::string off = complaint(with_surfaces(file, {cylinder("base", {{0.9, 0, 0}}, {{0, 1, 0}})}));
  EXPECT_EQ(off.find("Geometry/Curved surfaces = base: cylinder through 0.9 0 0 along 0 1 0: the node at ("),
            0u)
      << off;
  EXPECT_NE(off.find("allowed is 1e-6 of it for all nodes of the surface; correct the axis"),
            std::string::npos);
  const std::string plane = complaint(with_surfaces(file, {{"top", SurfaceKind::plane, {}, {}}}));
  EXPECT_NE(plane.find("mm off the mean plane of its surface: allowed is"), std::string::npos) << plane;
  EXPECT_EQ(complaint(with_surfaces(file, {{"y0", SurfaceKind::plane, {}, {}}})), "");
  const std::string twice = complaint(
      with_surfaces(file, {{"y0", SurfaceKind::plane, {}, {}}, {"y = 0", SurfaceKind::plane, {}, {}}}));
  EXPECT_NE(twice.find("Curved surfaces: y = 0 has faces of another surface, such as the one at ("),
            std::string::npos)
      << twice;
  const std::string none = complaint(with_surfaces(file, {{"bore", SurfaceKind::plane, {}, {}}}));
  EXPECT_NE(none.find("Geometry/Curved surfaces = bore is no physical surface: allowed in"),
            std::string::npos)
      << none;
}
} // namespace orthocone::test
