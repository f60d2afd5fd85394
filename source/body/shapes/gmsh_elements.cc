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
/// Numbers of nodes of Gmsh's elements, from type 1 on. From the eighth on all but the point are of second
/// order.
constexpr std::array<unsigned int, 19> n_nodes_of{
    {2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1, 8, 20, 15, 13}};
enum ElementType : unsigned int
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

/// Counts the elements of each type and group.
class ElementCounts
{
public:
  explicit ElementCounts(GmshFile &file)
      : file_(file)
  {
  }

  void add(const unsigned int type, const unsigned int number)
  {
    ++of_type_[type];
    const unsigned int dimension = type == line ? 1 : type == quadrilateral ? 2 : type == hexahedron ? 3 : 0;
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
    std::size_t n_curved = 0;
    for (const auto &[type, n] : of_type_)
      n_curved += type > pyramid && type != single_point ? n : 0;
    FaultList &faults = file_.faults;
    const std::string cells = file_.thickness ? "quadrangles" : "hexahedra";
    if (n_curved > 0)
      faults.add("has " + std::to_string(n_curved) + " elements of second order: allowed are linear ones " +
                 "(gmsh: Mesh.ElementOrder = 1)");
    if (!unknown_types_.empty())
      faults.add("has elements of type " + unknown_types() + ": allowed are linear " + cells +
                 " (gmsh: Mesh.ElementOrder = 1)");
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

  std::size_t of(const unsigned int type) const
  {
    const auto found = of_type_.find(type);
    return found == of_type_.end() ? 0 : found->second;
  }
  std::string unknown_types() const
  {
    std::vector<std::string> types;
    for (const long type : unknown_types_)
      types.push_back(std::to_string(type));
    return enumeration(types);
  }

  GmshFile &file_;
  std::map<unsigned int, std::size_t> of_type_;
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
    if (type == 0 || static_cast<std::size_t>(type) > n_nodes_of.size())
    {
      counts_.add_unknown_type(type);
      return reader_.skip_line();
    }
    const auto known = static_cast<unsigned int>(type);
    const auto group = static_cast<unsigned int>(std::labs(signed_group));
    if (known == hexahedron)
      file_.hexahedra.push_back({read_nodes<8>(), group});
    else if (known == quadrilateral && (group != 0 || file_.thickness))
      file_.quadrilaterals.push_back({read_nodes<4>(), group});
    else if (known == line && group != 0 && file_.thickness)
      file_.lines.push_back({read_nodes<2>(), group});
    else
      for (unsigned int i = 0; i < n_nodes_of[known - 1]; ++i)
        read_node();
    counts_.add(known, group);
  }

  template<std::size_t n>
  std::array<unsigned int, n> read_nodes()
  {
    std::array<unsigned int, n> nodes{};
    for (unsigned int &node : nodes)
      node = read_node();
    return nodes;
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
