// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "gmsh_elements.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

namespace orthocone
{
namespace
{
enum ElementForm : unsigned int
{
  line = 1,
  triangle = 2,
  quadrilateral = 3,
  tetrahedron = 4,
  hexahedron = 5,
  prism = 6,
  pyramid = 7,
  single_point = 15,
};

/// A type of Gmsh's elements.
struct ElementType
{
  ElementForm form;
  unsigned int order;
  unsigned int n_corners, n_nodes;
};

/// Gmsh's types from 1 on.
constexpr std::array<ElementType, 19> element_types{{
    {line, 1, 2, 2},        {triangle, 1, 3, 3},      {quadrilateral, 1, 4, 4}, {tetrahedron, 1, 4, 4},
    {hexahedron, 1, 8, 8},  {prism, 1, 6, 6},         {pyramid, 1, 5, 5},       {line, 2, 2, 3},
    {triangle, 2, 3, 6},    {quadrilateral, 2, 4, 9}, {tetrahedron, 2, 4, 10},  {hexahedron, 2, 8, 27},
    {prism, 2, 6, 18},      {pyramid, 2, 5, 14},      {single_point, 0, 1, 1},  {quadrilateral, 2, 4, 8},
    {hexahedron, 2, 8, 20}, {prism, 2, 6, 15},        {pyramid, 2, 5, 13},
}};

/// Counts the elements of each form, order and group.
class ElementCounts
{
public:
  explicit ElementCounts(GmshFile &file)
      : file_(file)
  {
  }

  void add(const ElementType &type, const unsigned int number)
  {
    ++of_form_[type.form];
    ++of_order_[type.order];
    const unsigned int dimension = type.form == line            ? 1
                                   : type.form == quadrilateral ? 2
                                   : type.form == hexahedron    ? 3
                                                                : 0;
    const unsigned int least = file_.thickness ? 1 : 2;
    if (number == 0 || dimension < least || dimension > least + 1)
      return;
    auto &groups = file_.groups;
    if (last_ < groups.size() && groups[last_].dimension == dimension && groups[last_].number == number)
    {
      ++groups[last_].n_elements;
      return;
    }
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const PhysicalGroup &one)
                                    { return one.dimension == dimension && one.number == number; });
    last_ = static_cast<std::size_t>(found - groups.begin());
    if (found == groups.end())
      groups.push_back({dimension, number, "", 1});
    else
      ++found->n_elements;
  }

  void add_unknown_type(const long type) { unknown_types_.insert(type); }

  /// Adds what is wrong to the faults of the file.
  void check_types() const
  {
    FaultList &faults = file_.faults;
    const std::string cells = file_.thickness ? "quadrangles" : "hexahedra";
    if (of_order_[1] > 0 && of_order_[2] > 0)
      faults.add("has " + std::to_string(of_order_[1]) + (of_order_[1] == 1 ? " element" : " elements") +
                 " of first order beside " + std::to_string(of_order_[2]) +
                 " of second order: allowed is one order for all (gmsh: Mesh.ElementOrder = 2)");
    if (!unknown_types_.empty())
      faults.add("has elements of type " + unknown_types() + ": allowed are " + cells +
                 " of first or second order (gmsh: Mesh.ElementOrder = 2)");
    if (file_.thickness)
      return check_plane_types();
    const std::size_t n_others = of(tetrahedron) + of(prism) + of(pyramid) + of(triangle);
    if (of(hexahedron) == 0 && of(tetrahedron) > 0)
      faults.add("has " + std::to_string(of(tetrahedron)) +
                 " tetrahedra: allowed are hexahedra, into which " +
                 "gmsh divides them with Mesh.SubdivisionAlgorithm = 2");
    else if (n_others > 0 && of(hexahedron) > 0)
      faults.add("is mixed, of " + std::to_string(of(hexahedron)) + " hexahedra and " +
                 std::to_string(n_others) +
                 " tetrahedra, prisms, pyramids or triangles: allowed are hexahedra alone (gmsh: " +
                 "Mesh.SubdivisionAlgorithm = 2)");
    else if (of(hexahedron) == 0 && faults.is_empty())
      faults.add(
          "has no hexahedra: allowed is a mesh of the volume (gmsh -3) in which it is a Physical Volume");
  }

private:
  /// Of a mesh that is to be extruded.
  void check_plane_types() const
  {
    const std::size_t n_cells = of(tetrahedron) + of(prism) + of(pyramid) + of(hexahedron);
    if (n_cells > 0)
      file_.faults.add("has " + std::to_string(n_cells) +
                       " cells of a volume: allowed with Geometry/Kind = plane strain are quadrangles in the "
                       "plane (x, z)");
    if (of(triangle) > 0)
      file_.faults.add("has " + std::to_string(of(triangle)) +
                       " triangles: allowed are quadrangles (gmsh: Mesh.RecombineAll = 1)");
    if (of(quadrilateral) == 0 && file_.faults.is_empty())
      file_.faults.add(
          "has no quadrangles: allowed is a mesh of the plane (gmsh -2) in which it is a Physical "
          "Surface");
  }

  std::size_t of(const ElementForm form) const
  {
    const auto found = of_form_.find(form);
    return found == of_form_.end() ? 0 : found->second;
  }
  std::string unknown_types() const
  {
    std::vector<std::string> types;
    for (const long type : unknown_types_)
      types.push_back(std::to_string(type));
    return enumeration(types);
  }

  GmshFile &file_;
  std::map<ElementForm, std::size_t> of_form_;
  std::array<std::size_t, 3> of_order_{}; ///< 0: points
  std::set<long> unknown_types_;
  std::size_t last_ = 0; ///< group to which an element was added
};

/// Reads elements one after the other, and remembers nodes that are not there.
class ElementReader
{
public:
  ElementReader(SectionReader &reader, const NodeNumbers &nodes, GmshFile &file)
      : reader_(reader),
        nodes_(nodes),
        file_(file),
        counts_(file)
  {
  }

  /// Format 4.1: all of a block are of one type and one entity. Returns the number of elements.
  std::size_t read_block(const EntityGroups &groups)
  {
    const auto dimension = static_cast<std::size_t>(reader_.dimension());
    const auto found = groups.find({dimension, reader_.number_of_group()});
    const long group = found == groups.end() ? 0 : found->second, type = reader_.whole_between(0, 1000);
    const std::size_t n = reader_.count();
    for (std::size_t i = 0; i < n; ++i)
    {
      reader_.number_of_thing();
      add(type, group);
    }
    return n;
  }

  /// Format 2.2: the first tag is the physical group.
  void read_element()
  {
    reader_.number_of_thing();
    const long type = reader_.whole_between(0, 1000);
    long group = 0;
    for (std::size_t n_tags = reader_.count(), n = 0; n < n_tags; ++n)
      if (const long tag = reader_.number_of_group(); n == 0)
        group = tag;
    add(type, group);
  }

  void check() const
  {
    counts_.check_types();
    std::vector<std::string> missing;
    for (const long node : missing_)
      missing.push_back(std::to_string(node));
    if (!missing.empty())
      file_.faults.add(std::string("section $Elements has ") +
                       (missing.size() == 1 ? "an element with node " : "elements with nodes ") +
                       enumeration(missing) + (missing.size() == 1 ? ", which is" : ", which are") +
                       " not in section $Nodes: the file is damaged; write it anew with gmsh");
  }

private:
  /// The sign of a group is the orientation of its elements.
  void add(const long type, const long signed_group)
  {
    if (type == 0 || static_cast<std::size_t>(type) > element_types.size())
    {
      counts_.add_unknown_type(type);
      return reader_.skip_line();
    }
    const ElementType &known = element_types[static_cast<std::size_t>(type) - 1];
    const auto group = static_cast<unsigned int>(std::labs(signed_group));
    if (known.form == hexahedron)
      file_.hexahedra.push_back(read_element<8>(known, group));
    else if (known.form == quadrilateral && (group != 0 || file_.thickness))
      file_.quadrilaterals.push_back(read_element<4>(known, group));
    else if (known.form == line && group != 0 && file_.thickness)
      file_.lines.push_back(read_element<2>(known, group));
    else
      for (unsigned int i = 0; i < known.n_nodes; ++i)
        read_node();
    file_.is_second_order = file_.is_second_order || known.order == 2;
    counts_.add(known, group);
  }

  /// Gmsh names the corners first.
  template<std::size_t n>
  GmshFile::Element<n> read_element(const ElementType &type, const unsigned int group)
  {
    GmshFile::Element<n> element{{}, group};
    for (unsigned int &node : element.nodes)
      node = read_node();
    for (unsigned int i = type.n_corners; i < type.n_nodes; ++i)
      element.middles.push_back(read_node());
    return element;
  }

  /// The place of a node in the file; 0 for one that is not there, which becomes a fault.
  unsigned int read_node()
  {
    const long number = reader_.whole();
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), std::make_pair(number, 0U));
    if (found != nodes_.end() && found->first == number)
      return found->second;
    missing_.insert(number);
    return 0;
  }

  SectionReader &reader_;
  const NodeNumbers &nodes_;
  GmshFile &file_;
  ElementCounts counts_;
  std::set<long> missing_;
};
} // namespace

void read_gmsh_elements(SectionReader &reader, const EntityGroups &groups, const NodeNumbers &nodes,
                        const bool in_blocks, GmshFile &file)
{
  ElementReader elements(reader, nodes, file);
  const std::size_t n_blocks = in_blocks ? reader.count() : 0;
  const std::size_t n_elements = reader.count();
  if (in_blocks)
    reader.skip_range();
  std::size_t n = in_blocks ? 0 : n_elements;
  for (std::size_t block = 0; block < n_blocks; ++block)
    n += elements.read_block(groups);
  for (std::size_t i = 0; !in_blocks && i < n_elements; ++i)
    elements.read_element();
  reader.require_end();
  if (n != n_elements)
    throw InputError(file.path + ": has " + std::to_string(n) + " elements: allowed are the " +
                     std::to_string(n_elements) + " that section $Elements says");
  elements.check();
}
} // namespace orthocone
