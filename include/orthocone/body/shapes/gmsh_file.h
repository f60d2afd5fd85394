// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/fault_list.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// A physical group of a mesh and the number of its elements.
struct PhysicalGroup
{
  unsigned int
      dimension; ///< 2: a surface, 3: a volume (of extruded meshes: the line and surface in the file)
  unsigned int number;
  std::string name; ///< may be empty
  std::size_t n_elements;
};

/// A file of Gmsh (format 2.1, 2.2 or 4.1, ASCII) with a mesh of hexahedra of first or second order, before
/// its cells are made, or of quadrangles in the plane y = 0, which are extruded to such. Coordinates are in
/// mm.
struct GmshFile
{
  /// An element by the indices of its nodes, in Gmsh's order, and its physical group, 0 for none. One of
  /// second order also has nodes in the middle of its edges and perhaps of its faces and of itself.
  template<std::size_t n>
  struct Element
  {
    std::array<unsigned int, n> nodes; ///< at its corners
    unsigned int group;
    std::vector<unsigned int> middles{};
  };

  std::string path;                         ///< as messages show it
  std::vector<PhysicalGroup> groups;        ///< of surfaces and volumes, in the order of their numbers
  std::vector<std::array<double, 3>> nodes; ///< in the order of the file
  std::vector<Element<8>> hexahedra;
  std::vector<Element<4>> quadrilaterals; ///< of physical surfaces
  FaultList faults;                       ///< of the elements, without the path
  bool is_second_order = false;           ///< whether its elements may be curved
  std::optional<double> thickness{};      ///< of a mesh that is extruded along y, mm
  std::vector<Element<2>> lines{};        ///< of physical lines, before the mesh is extruded

  /// The group with this name, or else with this number; null if there is none.
  const PhysicalGroup *find(unsigned int dimension, const std::string &name) const;

  /// "base (1), top (2)" of the groups of a dimension, or "none".
  std::string list(unsigned int dimension) const;
};

/// Reads such a file, and collects what is wrong with its elements. Throws FileError if it cannot be read,
/// and InputError with its path if it is no such file or is cut off. With a `thickness` (mm) it is a mesh of
/// quadrangles, which is extruded.
GmshFile collect_gmsh_file(const std::string &file_name, std::optional<double> thickness = {});

/// The same; throws InputError, too, if there are elements besides hexahedra and the quadrilaterals, lines
/// and points around them, all of one order, or nodes that are not there.
GmshFile read_gmsh_file(const std::string &file_name, std::optional<double> thickness = {});
} // namespace orthocone
