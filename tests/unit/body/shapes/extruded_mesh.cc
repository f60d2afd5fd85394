// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Meshes of quadrangles by Gmsh, for plane strain.
#include "folder_of_files.h"
#include "rejection.h"

#include <orthocone/body/body.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace orthocone::test
{
namespace
{
/// A mesh of 4 x 3 rectangles in the plane y = 0, as gmsh -2 writes it in format 2.2. Every other rectangle
/// runs the other way round. `at_y` is the y of the last node.
std::string rectangles(const double first_x, const double at_y = 0)
{
  constexpr unsigned int nx = 4, nz = 3, row = nx + 1;
  std::ostringstream nodes, elements;
  unsigned int n = 0;
  for (unsigned int j = 0; j <= nz; ++j)
    for (unsigned int i = 0; i <= nx; ++i)
      nodes << ++n << " " << std::setprecision(17) << first_x + (4 - first_x) * i / nx << " "
            << (j == nz && i == nx ? at_y : 0) << " " << j << "\n";
  unsigned int n_elements = 0;
  const auto line = [&](const unsigned int group, const unsigned int a, const unsigned int b)
  { elements << ++n_elements << " 1 2 " << group << " 1 " << a + 1 << " " << b + 1 << "\n"; };
  for (unsigned int i = 0; i < nx; ++i)
  {
    line(1, i, i + 1);
    line(2, nz * row + i, nz * row + i + 1);
  }
  for (unsigned int j = 0; j < nz; ++j)
    line(3, j * row, (j + 1) * row);
  for (unsigned int j = 0; j < nz; ++j)
    for (unsigned int i = 0; i < nx; ++i)
    {
      std::array<unsigned int, 4> corners{
          {j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i}};
      if ((i + j) % 2 == 1)
        std::reverse(corners.begin(), corners.end());
      elements << ++n_elements << " 3 2 7 1";
      for (const unsigned int corner : corners)
        elements << " " << corner + 1;
      elements << "\n";
    }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 1 \"base\"\n1 2 \"top\"\n1 3 "
         "\"left\"\n2 7 "
         "\"body\"\n$EndPhysicalNames\n$Nodes\n" +
         std::to_string(n) + "\n" + nodes.str() + "$EndNodes\n$Elements\n" + std::to_string(n_elements) +
         "\n" + elements.str() + "$EndElements\n";
}

BodyOptions of_file(const std::string &path)
{
  BodyOptions body;
  body.geometry.kind = GeometryKind::plane_strain;
  body.geometry.shape = BodyShape::file;
  body.geometry.mesh_file = path;
  body.geometry.thickness = 1.5;
  body.geometry.contact_surfaces = {"base"};
  body.geometry.held_surface = "top";
  return body;
}

void expect_same_unknowns(const BodyUnknowns &one, const BodyUnknowns &other)
{
  EXPECT_EQ(one.size().cells, other.size().cells);
  EXPECT_EQ(one.n_dofs(), other.n_dofs());
  EXPECT_EQ(one.n_free(), other.n_free());
  EXPECT_LE((one.held_centre() - other.held_centre()).norm(), 1e-12);
  double area = 0, other_area = 0;
  for (const ContactNode &node : one.contact_surface().nodes)
    area += node.area;
  for (const ContactNode &node : other.contact_surface().nodes)
    other_area += node.area;
  EXPECT_EQ(one.contact_surface().nodes.size(), other.contact_surface().nodes.size());
  EXPECT_NEAR(area, other_area, 1e-12);
}
} // namespace

TEST(ExtrudedMesh, IsTheSectionOfABox)
{
  const Folder folder;
  BodyOptions file = of_file(folder.write("whole.msh", rectangles(-4))), box;
  box.geometry.kind = GeometryKind::plane_strain;
  box.geometry.shape = BodyShape::box;
  box.geometry.sizes = {{8, 1.5, 3}};
  box.mesh.cells = {{4, 1, 3}};
  for (const unsigned int degree : {1, 2, 4})
  {
    file.mesh.degree = box.mesh.degree = degree;
    for (const bool has_third : {false, true})
    {
      const ModelSymmetry symmetry = ModelSymmetry::of_plane_strain(1.5, has_third);
      expect_same_unknowns(Body(file, symmetry).unknowns(), Body(box, symmetry).unknowns());
      const ModelSize size = make_shape(file.geometry, file.mesh)->size(symmetry);
      EXPECT_EQ(size.dofs, Body(file, symmetry).unknowns().n_dofs());
      EXPECT_EQ(size.contact_nodes, Body(file, symmetry).unknowns().contact_surface().nodes.size());
    }
  }
}

TEST(ExtrudedMesh, EndsAtAPlaneOfSymmetry)
{
  const Folder folder;
  BodyOptions half = of_file(folder.write("half.msh", rectangles(0)));
  half.geometry.symmetry_surfaces = {"left"};
  const ModelSymmetry symmetry = ModelSymmetry::of_plane_strain(1.5, true, true);
  EXPECT_TRUE(ImportedMesh(half.geometry).planes().normal_to_x);
  const Body body(half, symmetry);
  for (const ContactNode &node : body.unknowns().contact_surface().nodes)
    EXPECT_EQ(node.is_free, (std::array<bool, 3>{{node.position[0] > 0, true, true}}));
  half.geometry.symmetry_surfaces = {"x min"};
  EXPECT_EQ(Body(half, symmetry).unknowns().n_free(), body.unknowns().n_free());
}

TEST(ExtrudedMesh, IsRefusedOffItsPlane)
{
  const Folder folder;
  const auto complaint = [](const BodyOptions &options)
  { return rejection_of([&] { Body(options, ModelSymmetry::of_plane_strain(1.5, false)); }); };
  const BodyOptions off = of_file(folder.write("off.msh", rectangles(-4, 0.1)));
  EXPECT_NE(complaint(off).find("has a node at y = 0.1 mm: allowed with Geometry/Kind = plane strain"),
            std::string::npos)
      << complaint(off);
  BodyOptions aside = of_file(folder.write("aside.msh", rectangles(-4)));
  aside.geometry.held_surface = "y max";
  EXPECT_NE(complaint(aside).find("Geometry/Held surface = y max"), std::string::npos) << complaint(aside);
  BodyOptions solid = of_file(folder.path("aside.msh"));
  solid.geometry.kind = GeometryKind::solid;
  EXPECT_NE(rejection_of([&] { Body(solid, ModelSymmetry()); }).find("has no hexahedra"), std::string::npos);
}
} // namespace orthocone::test
