// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Mesh files with one fault each, made of a small good one.
#pragma once

#include "body/msh.h"

#include <orthocone/body/shapes/body_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace orthocone::test
{
/// A quarter of a box of eight cells, its base at z = 0.
inline Msh good_mesh()
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{4, 4, 2}};
  MeshOptions mesh;
  mesh.cells = {{4, 4, 2}};
  return Msh(BodyMesh(geometry, mesh, SymmetryPlanes{true, true}).triangulation());
}

/// One cell in format 4.1.
inline const char *const good_41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n2 1 \"base\"\n2 2 \"top\"\n3 7 \"body\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 2 1\n1 0 0 0 2 2 0 1 1 0\n2 0 0 2 2 2 2 1 2 0\n"
    "1 0 0 0 2 2 2 1 7 2 1 2\n$EndEntities\n"
    "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n$EndNodes\n"
    "$Elements\n3 3 1 3\n2 1 3 1\n1 1 2 3 4\n2 2 3 1\n2 5 6 7 8\n"
    "3 1 5 1\n3 1 2 3 4 5 6 7 8\n$EndElements\n";

inline std::string replaced(std::string text, const std::string &from, const std::string &to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

using Fault = std::function<void(Msh &)>;

inline std::string with(const Fault &fault)
{
  Msh mesh = good_mesh();
  fault(mesh);
  return mesh.text();
}

/// Another type for the first of the cells, or for all.
inline std::string with_type(const unsigned int type, const unsigned int n_nodes, const bool all)
{
  return with(
      [&](Msh &mesh)
      {
        for (auto &element : mesh.elements)
          if (element.type == 5)
          {
            element.type = type;
            element.nodes.resize(n_nodes, 1);
            if (!all)
              return;
          }
      });
}

/// Every node moved by a map.
inline std::string moved(const std::function<void(std::array<double, 3> &)> &map)
{
  return with(
      [&](Msh &mesh)
      {
        for (auto &node : mesh.nodes)
          map(node);
      });
}

struct Row
{
  const char *fault;
  std::string text;
  std::string expected; ///< of the sentence
  std::function<void(GeometryOptions &)> options = [](GeometryOptions &) {};
};

/// Other files, and ones that are cut off.
inline std::vector<Row> broken_texts()
{
  const std::string good = good_mesh().text();
  const std::string cut = "the file is cut off or damaged";
  return {
      {"empty", "", "is empty; a mesh is wanted"},
      {"blanks", " \n\n", "is empty; a mesh is wanted"},
      {"binary", std::string("$MeshFormat\n4.1 1 8\n\1\0\0\0\n", 26), "is not a text file; a mesh by Gmsh"},
      {"binary by its head", replaced(good, "2.2 0 8", "2.2 1 8"),
       "is a binary mesh: allowed is one in ASCII"},
      {"STL", "solid body\nendsolid\n", "begins with 'solid body': allowed is $MeshFormat"},
      {"Abaqus", "*HEADING\n*NODE\n", "begins with '*HEADING': allowed is $MeshFormat"},
      {"MEDIT", "MeshVersionFormatted 2\n", "begins with 'MeshVersionFormatted 2'"},
      {"format 1", "$NOD\n0\n$ENDNOD\n", "begins with '$NOD': allowed is $MeshFormat"},
      {"format 4.0", replaced(good, "2.2 0 8", "4 0 8"), "is of format 4: allowed are 2.1, 2.2 and 4.1"},
      {"format 3", replaced(good, "2.2 0 8", "3 0 8"), "is of format 3: allowed are 2.1, 2.2 and 4.1"},
      {"format a word", replaced(good, "2.2 0 8", "two 0 8"),
       "section $MeshFormat has 'two': allowed is a number"},
      {"head alone", good.substr(0, good.find("$Phys")), "has no section $Nodes: allowed is a mesh as gmsh"},
      {"cut in the names", good.substr(0, good.find("\"side\"")),
       "section $PhysicalNames has no $EndPhysicalNames"},
      {"cut in the nodes", good.substr(0, good.find("$EndNodes") - 9),
       "section $Nodes has no $EndNodes: " + cut},
      {"cut behind the nodes", good.substr(0, good.find("$Elements")), "has no section $Elements"},
      {"cut in the elements", good.substr(0, good.find("$EndElements") - 30),
       "section $Elements has no $EndElements: " + cut},
      {"cut before the end", good.substr(0, good.find("$EndElements")),
       "section $Elements has no $EndElements: " + cut},
  };
}

/// Sections that do not have what they say.
inline std::vector<Row> broken_sections()
{
  const std::string good = good_mesh().text();
  const std::size_t nodes = good.find("$Nodes");
  const std::string cut = "the file is cut off or damaged";
  return {
      {"a node missing", replaced(good, "$Nodes\n27", "$Nodes\n28"),
       "section $Nodes contains less than it announces: " + cut},
      {"a node too many", replaced(good, "$Nodes\n27", "$Nodes\n26"),
       "the end of the section, which contains more than it announces"},
      {"a number of nodes < 0", replaced(good, "$Nodes\n27", "$Nodes\n-1"),
       "section $Nodes has '-1': allowed is a count that is not larger than the section"},
      {"a node twice", good.substr(0, nodes) + replaced(good.substr(nodes), "\n2 ", "\n1 "),
       "has 26 different nodes: allowed are the 27"},
      {"a decimal comma", replaced(good, "$Nodes\n27\n1 0 ", "$Nodes\n27\n1 0,5 "),
       "section $Nodes has ',5': allowed is a number"},
      {"a coordinate nan", replaced(good, "$Nodes\n27\n1 0 ", "$Nodes\n27\n1 nan "),
       "section $Nodes has 'nan': allowed is a number"},
      {"a coordinate infinite", replaced(good, "$Nodes\n27\n1 0 ", "$Nodes\n27\n1 1e999 "),
       "section $Nodes has '1e999': allowed is a number"},
      {"an element missing", replaced(good, "$Elements\n32", "$Elements\n33"),
       "section $Elements contains less than it announces: " + cut},
      {"an element too many", replaced(good, "$Elements\n32", "$Elements\n31"),
       "which contains more than it announces"},
      {"a word in the elements", replaced(good, "\n1 5 2 ", "\n1 hex 2 "),
       "section $Elements has 'hex': allowed is a whole number"},
      {"a name without quotes", replaced(good, "\"y0\"", "y0"), "section $PhysicalNames contains less"},
      {"nodes twice", good + "$Nodes\n0\n$EndNodes\n", "has section $Nodes twice: allowed is once"},
      {"4.1: entity without end", replaced(good_41, "2 1 2\n$EndEntities", "2 1\n$EndEntities"),
       "section $Entities contains less than it announces"},
      {"4.1: block too short", replaced(good_41, "2 2 3 1\n", "2 2 3 2\n"),
       "section $Elements contains less"},
      {"4.1: node too few", replaced(good_41, "3 1 0 8", "3 1 0 9"), "section $Nodes has '0': allowed is"},
  };
}

/// Elements of nodes that are not there, of a group that nobody asks for, and numbers that no int holds.
inline std::vector<Row> wrong_numbers()
{
  const auto face_of = [](const std::string &node)
  {
    const std::string good = good_mesh().text(), last = "\n32 3 2 ";
    const std::string rest = good.substr(good.find(last) + 1);
    return replaced(good, rest.substr(0, rest.find('\n')), "32 3 2 99 1 1 2 3 " + node);
  };
  const std::string missing = ", which is not in section $Nodes: the file is damaged", large = "2147483648";
  const std::string bound = " to 2147483647";
  std::vector<Row> rows;
  for (const char *const node : {"28", "0", "-1", "2147483648", "99999999999999999999"})
    rows.push_back({node, face_of(node), missing});
  rows.push_back({"4.1: no such node", replaced(good_41, "1 1 2 3 4\n", "1 1 2 3 9\n"), "node 9" + missing});
  rows.push_back({"4.1: large node", replaced(good_41, "\n8\n0 0 0", "\n" + large + "\n0 0 0"), bound});
  rows.push_back({"4.1: large entity", replaced(good_41, "3 1 0 8", "3 4294967297 0 8"), bound});
  rows.push_back(
      {"4.1: large entity of a face", replaced(good_41, "2 1 3 1\n", "2 " + large + " 3 1\n"), bound});
  rows.push_back({"4.1: large element", replaced(good_41, "1 1 2 3 4\n", large + " 1 2 3 4\n"), bound});
  rows.push_back({"4.1: large group", replaced(good_41, "2 0 1 1 0\n", "2 0 1 " + large + " 0\n"), bound});
  rows.push_back({"4.1: elements too few", replaced(good_41, "\n3 3 1 3\n", "\n3 9 1 3\n"),
                  "has 3 elements: allowed are the 9"});
  return rows;
}

/// Elements that the program does not take.
inline std::vector<Row> broken_meshes()
{
  const auto no_cells = [](Msh &mesh)
  {
    auto &all = mesh.elements;
    all.erase(std::remove_if(all.begin(), all.end(), [](const auto &one) { return one.type == 5; }),
              all.end());
  };
  return {
      {"tetrahedra", with_type(4, 4, true),
       "has 8 tetrahedra: allowed are hexahedra, into which gmsh divides them with Mesh.SubdivisionAlgorithm "
       "= 2"},
      {"a tetrahedron", with_type(4, 4, false), "is mixed, of 7 hexahedra and 1 tetrahedra"},
      {"a prism", with_type(6, 6, false), "is mixed, of 7 hexahedra and 1 tetrahedra, prisms"},
      {"a pyramid", with_type(7, 5, false), "is mixed, of 7 hexahedra and 1"},
      {"a triangle", with_type(2, 3, false), "is mixed, of 7 hexahedra and 1"},
      {"prisms", with_type(6, 6, true), "has no hexahedra: allowed is a mesh of the volume"},
      {"27 nodes", with_type(12, 27, true),
       "has 24 elements of first order beside 8 of second order: allowed is one order"},
      {"20 nodes", with_type(17, 20, false), "has 31 elements of first order beside 1 of second order"},
      {"tetrahedra of 10 nodes", with_type(11, 10, true), "has 8 tetrahedra: allowed are hexahedra, into"},
      {"third order", with_type(92, 64, true),
       "has elements of type 92: allowed are hexahedra of first or second order"},
      {"type 0", with_type(0, 8, true), "has elements of type 0: allowed are hexahedra of first or second"},
      {"surface alone", with(no_cells), "has no hexahedra: allowed is a mesh of the volume"},
  };
}

/// The second body has nodes of its own.
inline void add_copy(Msh &mesh)
{
  const auto n = static_cast<unsigned int>(mesh.nodes.size());
  for (unsigned int i = 0; i < n; ++i)
    mesh.nodes.push_back({{mesh.nodes[i][0] + 9, mesh.nodes[i][1], mesh.nodes[i][2]}});
  for (std::size_t i = 0, last = mesh.elements.size(); i < last; ++i)
  {
    mesh.elements.push_back(mesh.elements[i]);
    for (unsigned int &node : mesh.elements.back().nodes)
      node += n;
    if (mesh.elements.back().type == 3)
      mesh.elements.back().group = 3; // none of the named surfaces
  }
}

/// Cells that do not fit together, or do not lie where they should.
inline std::vector<Row> misplaced_meshes()
{
  const auto invert = [](Msh &mesh) { std::swap(mesh.elements[0].nodes[4], mesh.elements[0].nodes[5]); };
  const auto hole = [](Msh &mesh) { mesh.elements[0].nodes[6] = 99; };
  const auto collapse = [](Msh &mesh) { mesh.elements[0].nodes[6] = mesh.elements[0].nodes[7]; };
  const auto far_quad = [](Msh &mesh) { mesh.elements.push_back({3, 1, {1, 2, 26, 27}}); };
  return {
      {"inverted", with(invert),
       "is inverted: allowed are hexahedra with a positive volume at each of their corners"},
      {"node that is not there", with(hole), "has an element with node 99, which is not in section"},
      {"collapsed", with(collapse), "inverted"},
      {"face that is none", with(far_quad),
       "Geometry/Contact surface = base has 5 faces, of which 4 are on the outside of the cells"},
      {"two pieces", with(add_copy), "has 2 pieces without a common face: allowed is one body"},
      {"below the plane", moved([](auto &x) { x[2] -= 0.1; }),
       "Geometry/Contact surface = base is below the plane at (0, 0, -0.1) mm, (1, 0, -0.1) mm, (2, 0, -0.1) "
       "mm and 6 more: allowed is z >= 0"},
      {"off the symmetry plane", moved([](auto &x) { x[0] += 1e-3; }),
       "x0 reaches to |x| = 0.001 mm: allowed are surfaces in the plane x = 0 or y = 0"},
      {"warped symmetry plane", moved([](auto &x) { x[1] += x[1] == 0 && x[2] == 1 ? 0.1 : 0; }),
       "y0 reaches to |y| = 0.1 mm"},
      {"other side", moved([](auto &x) { x[0] = -x[0], x[1] = x[1] * 1; }),
       "lies in x = 0, and the body reaches to x = -2 mm: allowed is a body at x >= 0"},
  };
}

/// What the file does not have.
inline std::vector<Row> wrong_names()
{
  const std::string good = good_mesh().text();
  const std::string list = "base (1), top (2), side (3), x0 (4), y0 (5)";
  const auto without_base = [](Msh &mesh)
  {
    for (auto &element : mesh.elements)
      element.group = element.type == 3 && element.group == 1 ? 3 : element.group;
  };
  return {
      {"contact missing", good, "Geometry/Contact surface = bse is no physical surface: allowed in",
       [](auto &g) { g.contact_surfaces = {"bse"}; }},
      {"held a number", good, "Geometry/Held surface = 9 is no physical surface: allowed in",
       [](auto &g) { g.held_surface = "9"; }},
      {"held none", good, "are " + list, [](auto &g) { g.held_surface = ""; }},
      {"a volume", good, "Geometry/Contact surface = body is no physical surface",
       [](auto &g) { g.contact_surfaces = {"body"}; }},
      {"symmetry missing", good, "Geometry/Symmetry surfaces = z0 is no physical surface",
       [](auto &g) { g.symmetry_surfaces = {"z0"}; }},
      {"held is contact", good,
       "Geometry/Held surface = base is the surface of Geometry/Contact surface, too",
       [](auto &g) { g.held_surface = "base"; }},
      {"symmetry is contact", good,
       "Geometry/Symmetry surfaces = 1 is the surface of Geometry/Contact surface, too",
       [](auto &g) { g.symmetry_surfaces = {"1"}; }},
      {"no faces", with(without_base), "Geometry/Contact surface = base has no faces: allowed in"},
      {"held touches contact", good, "Geometry/Held surface = side has nodes of the contact surface",
       [](auto &g) { g.held_surface = "side"; }},
      {"contact looks up", good, "Geometry/Contact surface = top does not look down at",
       [](auto &g) { std::swap(g.contact_surfaces[0], g.held_surface); }},
      {"symmetry inclined", good, "side reaches to |x| = 2 mm: allowed are surfaces in the plane",
       [](auto &g) { g.symmetry_surfaces = {"side"}; }},
      {"no file", good, "Geometry/Mesh file is empty with Geometry/Shape = file",
       [](auto &g) { g.mesh_file.clear(); }},
  };
}
} // namespace orthocone::test
