// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/gmsh_file.h>

#include "gmsh_sections.h"
#include "text_file.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace orthocone
{
namespace
{
using Sections = std::map<std::string, std::string>;

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

unsigned int element_type(SectionReader &reader, const std::string &path)
{
  const std::size_t type = reader.count();
  if (type == 0 || type > n_nodes_of.size())
    throw InputError(path + ": has elements of type " + std::to_string(type) +
                     ": allowed are linear hexahedra (gmsh: Mesh.ElementOrder = 1)");
  return static_cast<unsigned int>(type);
}

/// A reader of the body of a section, which must be there.
SectionReader reader_of(const std::string &path, const Sections &sections, const std::string &name)
{
  const auto found = sections.find(name);
  if (found == sections.end())
    throw InputError(path + ": has no section " + name + ": allowed is a mesh as gmsh -3 writes it");
  return {path, name, found->second};
}

void read_names(const Sections &sections, GmshFile &file)
{
  if (sections.count("$PhysicalNames") == 0)
    return;
  SectionReader reader = reader_of(file.path, sections, "$PhysicalNames");
  for (std::size_t n = reader.count(); n > 0; --n)
  {
    const std::size_t dimension = reader.count(), number = reader.count();
    const std::string name = reader.quoted();
    if (dimension >= 2)
      file.groups.push_back(
          {static_cast<unsigned int>(dimension), static_cast<unsigned int>(number), name, 0});
  }
  reader.require_end();
}

/// The first physical group of every entity (dimension, number) of format 4.1.
std::map<std::pair<std::size_t, long>, long> read_entities(const std::string &path, const Sections &sections)
{
  std::map<std::pair<std::size_t, long>, long> groups;
  if (sections.count("$Entities") == 0)
    return groups;
  SectionReader reader = reader_of(path, sections, "$Entities");
  std::array<std::size_t, 4> n_entities{};
  for (std::size_t &n : n_entities)
    n = reader.count();
  for (std::size_t dimension = 0; dimension < n_entities.size(); ++dimension)
    for (std::size_t i = 0; i < n_entities[dimension]; ++i)
    {
      const long number = reader.whole();
      reader.skip(dimension == 0 ? 3 : 6); // a place, or a box
      for (std::size_t n = reader.count(), first = n; n > 0; --n)
        if (const long group = reader.whole(); n == first)
          groups[{dimension, number}] = group;
      if (dimension > 0)
        reader.skip(reader.count());
    }
  reader.require_end();
  return groups;
}

void read_nodes(const std::string &path, const Sections &sections, const bool in_blocks)
{
  SectionReader reader = reader_of(path, sections, "$Nodes");
  std::size_t n_blocks = in_blocks ? reader.count() : 1, n_nodes = reader.count();
  if (in_blocks)
    reader.skip(2);
  std::set<long> numbers;
  for (; n_blocks > 0; --n_blocks)
  {
    std::size_t n = n_nodes;
    if (in_blocks)
    {
      reader.skip(3);
      n = reader.count();
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      numbers.insert(reader.whole());
      reader.skip(in_blocks ? 0 : 3);
    }
    reader.skip(in_blocks ? 3 * n : 0);
  }
  reader.require_end();
  if (numbers.size() != n_nodes)
    throw InputError(path + ": has " + std::to_string(numbers.size()) + " different nodes: allowed are the " +
                     std::to_string(n_nodes) + " that section $Nodes says");
}

void read_elements(const Sections &sections, const bool in_blocks, GmshFile &file)
{
  const auto groups = read_entities(file.path, sections);
  SectionReader reader = reader_of(file.path, sections, "$Elements");
  ElementCounts counts(file);
  std::size_t n_left = reader.count();
  if (in_blocks)
    reader.skip(3);
  for (; n_left > 0; --n_left)
    if (in_blocks)
    {
      const std::size_t dimension = reader.count();
      const auto group = groups.find({dimension, reader.whole()});
      const unsigned int type = element_type(reader, file.path);
      const std::size_t n = reader.count();
      reader.skip(n * (1 + n_nodes_of[type - 1]));
      counts.add(type, group == groups.end() ? 0 : group->second, n);
    }
    else
    {
      reader.whole();
      const unsigned int type = element_type(reader, file.path);
      const std::size_t n_tags = reader.count();
      const long group = n_tags > 0 ? reader.whole() : 0;
      reader.skip(n_tags - (n_tags > 0 ? 1 : 0) + n_nodes_of[type - 1]);
      counts.add(type, group, 1);
    }
  reader.require_end();
  counts.require_hexahedra();
}

/// Whether the format is 4.1, in blocks, and not 2.2. Throws InputError for any other.
bool is_in_blocks(const std::string &path, const Sections &sections)
{
  SectionReader reader = reader_of(path, sections, "$MeshFormat");
  const double version = reader.number();
  if (version != 2 && version != 2.2 && version != 4.1)
    throw InputError(path + ": is of format " + to_text(version) +
                     ": allowed are 2.2 and 4.1 (gmsh: Mesh.MshFileVersion = 4.1)");
  if (reader.count() != 0)
    throw InputError(path + ": is a binary mesh: allowed is one in ASCII (gmsh: Mesh.Binary = 0)");
  return version == 4.1;
}
} // namespace

std::map<std::string, std::string> sections_of(const std::string &path, const std::string &text)
{
  Sections sections;
  std::istringstream lines(text);
  for (std::string given; std::getline(lines, given);)
  {
    const std::string name = trimmed(given);
    if (sections.empty() && !name.empty() && name != "$MeshFormat")
      throw InputError(path + ": begins with '" + shown(name) +
                       "': allowed is $MeshFormat, with which a mesh by Gmsh begins");
    if (name.empty() || name[0] != '$')
      continue;
    std::string body, last;
    const std::string end = "$End" + name.substr(1);
    while (std::getline(lines, last) && trimmed(last) != end)
      body += last + "\n";
    if (trimmed(last) != end)
      throw InputError(path + ": section " + name + " has no " + end +
                       ": the file is cut off or damaged; write it anew with gmsh");
    if (!sections.emplace(name, body).second)
      throw InputError(path + ": has section " + name + " twice: allowed is once");
  }
  return sections;
}

const PhysicalGroup *GmshFile::find(const unsigned int dimension, const std::string &name) const
{
  const auto number = parse_count(name);
  const PhysicalGroup *found = nullptr;
  for (const PhysicalGroup &group : groups)
    if (group.dimension == dimension)
    {
      if (!name.empty() && group.name == name)
        return &group;
      if (number && group.number == *number)
        found = &group;
    }
  return found;
}

std::string GmshFile::list(const unsigned int dimension) const
{
  std::string all;
  for (const PhysicalGroup &group : groups)
    if (group.dimension == dimension)
      all += (all.empty() ? "" : ", ") +
             (group.name.empty() ? std::to_string(group.number)
                                 : shown(group.name) + " (" + std::to_string(group.number) + ")");
  return all.empty() ? "none" : all;
}

GmshFile read_gmsh_file(const std::string &file_name)
{
  constexpr TextFileKind kind{"a mesh by Gmsh (.msh, format 2.2 or 4.1, ASCII)", 500, "a mesh is wanted"};
  GmshFile file{shown_path(file_name), with_plain_lines(read_text_file(file_name, "", kind)), {}};
  const Sections sections = sections_of(file.path, file.text);
  const bool in_blocks = is_in_blocks(file.path, sections);
  read_names(sections, file);
  read_nodes(file.path, sections, in_blocks);
  read_elements(sections, in_blocks, file);
  std::sort(file.groups.begin(), file.groups.end(),
            [](const PhysicalGroup &a, const PhysicalGroup &b)
            { return std::make_pair(a.dimension, a.number) < std::make_pair(b.dimension, b.number); });
  return file;
}
} // namespace orthocone
