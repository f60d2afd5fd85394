// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/imported_mesh.h>

#include "body/bodies.h"
#include "body/msh.h"
#include "folder_of_files.h"

#include <orthocone/body/body.h>
#include <orthocone/body/materials/orthotropic_law.h>

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace orthocone::test
{
namespace
{
constexpr double width = 12, depth = 8, height = 6;

/// A quarter of a box with cells that are no bricks inside; above half of the height another material id.
Msh distorted_box(const double by)
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{width, depth, height}};
  MeshOptions mesh;
  mesh.cells = {{6, 6, 4}};
  const BodyMesh box(geometry, mesh, quarter);
  dealii::Triangulation<3> distorted;
  distorted.copy_triangulation(box.triangulation());
  for (const auto &cell : distorted.active_cell_iterators())
    cell->set_material_id(cell->center()[2] > height / 2 ? 1 : 0);
  if (by > 0)
    dealii::GridTools::distort_random(by, distorted, true, 1);
  return Msh(distorted);
}

/// What a uniform pressure on the base does to the contact nodes of an imported body, guided at its top:
/// displacement (normal, x, y) of each.
std::vector<std::pair<ContactNode, Eigen::Vector3d>> pressed(const std::string &file, const double pressure,
                                                             const MaterialOptions &material,
                                                             const MeshOptions &mesh)
{
  BodyOptions parameters;
  parameters.geometry = imported(file, {"x0", "5"});
  parameters.geometry.top_face = TopFace::guided;
  parameters.material = material;
  parameters.mesh = mesh;
  const Body body(parameters, quarter);
  const Stiffness stiffness = body.stiffness(body.materials());
  const StiffnessFactor factor(stiffness.matrix(), body.unknowns().n_interior());
  const CondensedBody condensed(body.unknowns(), factor, LocalAxes(0));
  const auto &nodes = body.unknowns().contact_surface().nodes;
  NodeVector force = NodeVector::Zero(3 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    force[3 * static_cast<Eigen::Index>(i)] = pressure * nodes[i].area;
  NodeVector moved;
  condensed.compliance().vmult(moved, force);
  std::vector<std::pair<ContactNode, Eigen::Vector3d>> result;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result.emplace_back(nodes[i], moved.segment<3>(3 * static_cast<Eigen::Index>(i)));
  return result;
}

MeshOptions of_degree(const unsigned int degree, const unsigned int refinements = 0)
{
  MeshOptions mesh;
  mesh.degree = degree;
  mesh.refinements = refinements;
  return mesh;
}
} // namespace

// Uniform stress is exact in cells of any form.
TEST(ImportedMesh, PassesThePatchTest)
{
  const Folder folder;
  const std::string file = folder.write("box.msh", distorted_box(0.2).text());
  const MaterialOptions steel;
  const double strain = 1e-3, pressure = strain * steel.young_modulus;
  for (const MeshOptions &mesh : {of_degree(1), of_degree(2), of_degree(1, 1)})
    for (const auto &[node, moved] : pressed(file, pressure, steel, mesh))
    {
      const Eigen::Vector3d expected(strain * height, steel.poisson_ratio * strain * node.position[0],
                                     steel.poisson_ratio * strain * node.position[1]);
      EXPECT_LE((moved - expected).norm(), 1e-11 * strain * height);
    }
}

// E_z u / H, and the lateral strains nu_xz / E_x and nu_yz / E_y times the pressure.
TEST(ImportedMesh, IsAnOrthotropicBar)
{
  const Folder folder;
  const std::string file = folder.write("box.msh", distorted_box(0.2).text());
  MaterialOptions wood;
  auto &law = wood.law.choose<OrthotropicLaw>();
  law.young_moduli = {{14000, 900, 500}};
  law.poisson_ratios = {{0.4, 0.5, 0.6}};
  law.shear_moduli = {{800, 700, 60}};
  constexpr double pressure = 2;
  for (const unsigned int degree : {1, 2})
    for (const auto &[node, moved] : pressed(file, pressure, wood, of_degree(degree)))
    {
      const Eigen::Vector3d expected(pressure / 500 * height, 0.5 * pressure / 14000 * node.position[0],
                                     0.6 * pressure / 900 * node.position[1]);
      EXPECT_LE((moved - expected).norm(), 1e-11 * expected[0]);
    }
}

// Two bars one on the other: their shortenings add.
TEST(ImportedMesh, IsABarOfTwoRegions)
{
  const Folder folder;
  const std::string file = folder.write("box.msh", distorted_box(0).text());
  MaterialOptions bar;
  bar.young_modulus = 1000;
  bar.poisson_ratio = 0;
  bar.regions = {{"other", 250, 0}};
  constexpr double pressure = 3;
  const double expected = pressure * height / 2 * (1 / 1000. + 1 / 250.);
  for (const std::string volume : {"other", "2"})
  {
    bar.regions[0].volume = volume;
    for (const auto &[node, moved] : pressed(file, pressure, bar, of_degree(2, 0)))
      EXPECT_LE((moved - Eigen::Vector3d(expected, 0, 0)).norm(), 1e-11 * expected);
  }
}

// Names, places, and places of a file with nothing but its cells and one tag for all.
TEST(ImportedMesh, IsTheSameToTheLastBitByNamesAndByPlaces)
{
  const Folder folder;
  Msh box = distorted_box(0.2);
  const auto ids = [&](const std::string &name, const bool by_place)
  {
    GeometryOptions geometry = imported(folder.write(name, box.text()), {"x0", "y0"});
    if (by_place)
    {
      geometry.contact_surfaces = {"z min"};
      geometry.held_surface = "z = 6";
      geometry.symmetry_surfaces = {"x = 0", "y min"};
    }
    const ImportedMesh mesh(geometry);
    EXPECT_EQ(mesh.planes().name(), "quarter");
    dealii::Triangulation<3> copy;
    mesh.copy_to(copy);
    std::vector<double> all;
    for (const auto &face : copy.active_face_iterators())
    {
      all.push_back(face->at_boundary() ? face->boundary_id() : -1);
      for (const unsigned int v : face->vertex_indices())
        for (unsigned int d = 0; d < 3; ++d)
          all.push_back(face->vertex(v)[d]);
    }
    return all;
  };
  const auto expected = ids("names.msh", false);
  EXPECT_EQ(ids("places.msh", true), expected);
  for (auto &element : box.elements)
    element.group = 1;
  EXPECT_EQ(ids("one_tag.msh", true), expected);
  box.elements.erase(std::remove_if(box.elements.begin(), box.elements.end(),
                                    [](const auto &element) { return element.type == 3; }),
                     box.elements.end());
  EXPECT_EQ(ids("cells.msh", true), expected);
}

TEST(ImportedMesh, PrefersAPhysicalSurfaceOfThatName)
{
  const Folder folder;
  const Msh box = distorted_box(0);
  std::string text = box.text();
  text.replace(text.find("\"top\""), 5, "\"z min\"");
  GeometryOptions geometry = imported(folder.write("box.msh", text));
  geometry.held_surface = "z min";
  EXPECT_NE(ImportedMesh(geometry).describe().find("surface        z min (2): 9 faces"), std::string::npos);
}

// Nodes of single precision are moved into the plane that names them; by a name they are below it.
TEST(ImportedMesh, MovesNodesIntoThePlanesThatNameThem)
{
  const Folder folder;
  Msh box = distorted_box(0);
  for (std::size_t i = 0; i < box.nodes.size(); ++i)
    for (double &coordinate : box.nodes[i])
      coordinate += coordinate == 0 ? (i % 2 == 0 ? 4e-6 : -4e-6) : 0;
  GeometryOptions geometry = imported(folder.write("box.msh", box.text()));
  EXPECT_THROW(ImportedMesh{geometry}, InputError);
  geometry.contact_surfaces = {"z = 0"};
  geometry.held_surface = "z max";
  geometry.symmetry_surfaces = {"x = 0", "y = 0"};
  const std::string text = ImportedMesh(geometry).describe();
  EXPECT_NE(text.find("\ncontact height 0 to 0 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("\nsurface        z = 0: 9 faces, 24 mm^2\n"), std::string::npos) << text;
}

// Gmsh writes faces between parts of the body, too, where a file has no physical groups.
TEST(ImportedMesh, LeavesOutFacesInside)
{
  const Folder folder;
  Msh box = distorted_box(0);
  const auto cell = std::find_if(box.elements.begin(), box.elements.end(),
                                 [](const auto &element) { return element.type == 5; });
  const auto n = cell->nodes;
  box.elements.push_back({3, 0, {n[4], n[5], n[6], n[7]}});
  box.elements.push_back({3, 9, {n[1], n[2], n[6], n[5]}});
  EXPECT_EQ(ImportedMesh(imported(folder.write("box.msh", box.text()))).planes().name(), "full");
}

TEST(ImportedMesh, KnowsItsSizeBeforeItIsRefined)
{
  const Folder folder;
  BodyOptions parameters;
  parameters.geometry = imported(folder.write("box.msh", distorted_box(0).text()), {"x0", "y0"});
  for (const unsigned int refinements : {0, 1})
    for (const unsigned int degree : {1, 2})
    {
      parameters.mesh = of_degree(degree, refinements);
      const ModelSize size = make_shape(parameters.geometry, parameters.mesh)->size(quarter);
      const Body body(parameters, quarter);
      dealii::SparsityPattern pattern;
      body.make_pattern(pattern);
      EXPECT_EQ(size.cells, body.unknowns().size().cells);
      EXPECT_EQ(size.contact_nodes, body.unknowns().contact_surface().nodes.size());
      EXPECT_EQ(size.dofs, body.unknowns().n_dofs());
      EXPECT_GE(size.stiffness_entries, pattern.n_nonzero_elements());
      EXPECT_LE(size.stiffness_entries, 3. * pattern.n_nonzero_elements());
    }
}

// Whatever face of a cell is in contact, and whether Gmsh numbers a cell from its back.
TEST(ImportedMesh, TakesCellsInAnyOrder)
{
  const Folder folder;
  Msh box = distorted_box(0.1);
  const auto expected = pressed(folder.write("a.msh", box.text()), 1, {}, of_degree(2));
  std::size_t n_turned = 0;
  for (auto &element : box.elements)
    if (element.type == 5)
    {
      const auto n = element.nodes;
      switch (n_turned++ % 3)
      {
      case 1: // about x: the lower face becomes a side
        element.nodes = {n[3], n[2], n[6], n[7], n[0], n[1], n[5], n[4]};
        break;
      case 2: // upside down
        element.nodes = {n[5], n[4], n[7], n[6], n[1], n[0], n[3], n[2]};
        break;
      default:
        break;
      }
    }
  const auto turned = pressed(folder.write("b.msh", box.text()), 1, {}, of_degree(2));
  ASSERT_EQ(turned.size(), expected.size());
  for (const auto &[node, moved] : turned)
    for (const auto &[other, of_other] : expected)
      if (std::hypot(node.position[0] - other.position[0], node.position[1] - other.position[1]) < 1e-9)
      {
        EXPECT_LE((moved - of_other).norm(), 1e-10 * of_other.norm());
        EXPECT_NEAR(node.area, other.area, 1e-12);
      }
}

TEST(ImportedMesh, DescribesWhatItFound)
{
  const Folder folder;
  Msh box = distorted_box(0);
  for (auto &node : box.nodes)
    node[2] += node[2] == 0 ? 0.001 * (node[0] * node[0]) : 0;
  const ImportedMesh mesh(imported(folder.write("box.msh", box.text()), {"x0", "y0"}));
  EXPECT_EQ(mesh.planes().name(), "quarter");
  const std::string text = mesh.describe();
  for (const char *const line :
       {"volume         body (1): 18 cells, 71.", "volume         other (2): 18 cells, 72 mm^3",
        "surface        top (2): 9 faces, 24 mm^2", "contact height 0 to 0.036 mm"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
  EXPECT_TRUE(mesh.warnings(of_degree(1)).empty());
  ASSERT_EQ(mesh.warnings(of_degree(1, 1)).size(), 1u);
  EXPECT_NE(mesh.warnings(of_degree(1, 1))[0].find("facets"), std::string::npos);
  for (auto &node : box.nodes)
    for (double &coordinate : node)
      coordinate /= 1000;
  const ImportedMesh in_metres(imported(folder.write("m.msh", box.text()), {"x0", "y0"}));
  EXPECT_NE(in_metres.warnings(of_degree(1))[0].find("metres"), std::string::npos);
}
} // namespace orthocone::test
