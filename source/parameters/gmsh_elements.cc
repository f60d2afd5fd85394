// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "gmsh_elements.h"

#include <algorithm>
#include <array>

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

  void add(const unsigned int type, const long group, const std::size_t n)
  {
    of_type_[type] += n;
    const unsigned int dimension = type == quadrilateral ? 2 : type == hexahedron ? 3 : 0;
    if (group <= 0 || dimension == 0)
      return;
    auto &groups = file_.groups;
    const auto number = static_cast<unsigned int>(group);
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const PhysicalGroup &one)
                                    { return one.dimension == dimension && one.number == number; });
    if (found == groups.end())
      groups.push_back({dimension, number, "", n});
    else
      found->n_elements += n;
  }

  void require_hexahedra() const
  {
    std::size_t n_curved = 0;
    for (const auto &[type, n] : of_type_)
      n_curved += type > pyramid && type != single_point ? n : 0;
    if (n_curved > 0)
      fail("has " + std::to_string(n_curved) + " elements of second order: allowed are linear ones " +
           "(gmsh: Mesh.ElementOrder = 1)");
    if (of(hexahedron) == 0 && of(tetrahedron) > 0)
      fail("has " + std::to_string(of(tetrahedron)) + " tetrahedra: allowed are hexahedra, into which gmsh " +
           "divides them with Mesh.SubdivisionAlgorithm = 2");
    const std::size_t n_others = of(tetrahedron) + of(prism) + of(pyramid) + of(triangle);
    if (n_others > 0 && of(hexahedron) > 0)
      fail("is mixed, of " + std::to_string(of(hexahedron)) + " hexahedra and " + std::to_string(n_others) +
           " tetrahedra, prisms, pyramids or triangles: allowed are hexahedra alone (gmsh: " +
           "Mesh.SubdivisionAlgorithm = 2)");
    if (of(hexahedron) == 0)
      fail("has no hexahedra: allowed is a mesh of the volume (gmsh -3) in which it is a Physical Volume");
  }

private:
  std::size_t of(const unsigned int type) const
  {
    const auto found = of_type_.find(type);
    return found == of_type_.end() ? 0 : found->second;
  }
  [[noreturn]] void fail(const std::string &fault) const { throw InputError(file_.path + ": " + fault); }

  GmshFile &file_;
  std::map<unsigned int, std::size_t> of_type_;
};

/// Reads elements one after the other. Each node that one of them names must be there.
class ElementReader
{
public:
  ElementReader(SectionReader &reader, const std::vector<long> &nodes, GmshFile &file)
      : reader_(reader),
        nodes_(nodes),
        path_(file.path),
        counts_(file)
  {
  }

  /// Format 4.1: all of a block are of one type and one entity. Returns the number of elements.
  std::size_t read_block(const EntityGroups &groups)
  {
    const auto dimension = static_cast<std::size_t>(reader_.dimension());
    const auto group = groups.find({dimension, reader_.number_of_group()});
    const unsigned int type = read_type();
    const std::size_t n = reader_.count();
    for (std::size_t i = 0; i < n; ++i)
    {
      reader_.number_of_thing();
      read_nodes_of(type);
    }
    counts_.add(type, group == groups.end() ? 0 : group->second, n);
    return n;
  }

  /// Format 2.2: the first tag is the physical group.
  void read_element()
  {
    reader_.number_of_thing();
    const unsigned int type = read_type();
    long group = 0;
    for (std::size_t n_tags = reader_.count(), n = 0; n < n_tags; ++n)
      if (const long tag = reader_.number_of_group(); n == 0)
        group = tag;
    read_nodes_of(type);
    counts_.add(type, group, 1);
  }

  void require_hexahedra() const { counts_.require_hexahedra(); }

private:
  unsigned int read_type()
  {
    const long type = reader_.whole_between(0, 1000);
    if (type == 0 || static_cast<std::size_t>(type) > n_nodes_of.size())
      throw InputError(path_ + ": has elements of type " + std::to_string(type) +
                       ": allowed are linear hexahedra (gmsh: Mesh.ElementOrder = 1)");
    return static_cast<unsigned int>(type);
  }

  void read_nodes_of(const unsigned int type)
  {
    for (unsigned int i = 0; i < n_nodes_of[type - 1]; ++i)
      if (const long node = reader_.whole(); !std::binary_search(nodes_.begin(), nodes_.end(), node))
        throw InputError(path_ + ": section $Elements has an element with node " + std::to_string(node) +
                         ", which is not in section $Nodes: the file is damaged; write it anew with gmsh");
  }

  SectionReader &reader_;
  const std::vector<long> &nodes_;
  std::string path_;
  ElementCounts counts_;
};
} // namespace

void read_gmsh_elements(SectionReader &reader, const EntityGroups &groups, const std::vector<long> &nodes,
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
  elements.require_hexahedra();
}
} // namespace orthocone
