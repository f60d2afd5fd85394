// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/gmsh_file.h>

#include "extruded_mesh.h"
#include "gmsh_elements.h"
#include <orthocone/entries/text_file.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace orthocone
{
namespace
{
using Sections = std::map<std::string, std::string>;

const std::string converter = "tools/import FILE MESH.msh"; ///< it reads what this reader does not

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
    const long dimension = reader.dimension(), number = reader.number_of_group();
    const std::string name = reader.quoted();
    if (dimension >= (file.thickness ? 1 : 2) && dimension <= (file.thickness ? 2 : 3))
      file.groups.push_back(
          {static_cast<unsigned int>(dimension), static_cast<unsigned int>(number), name, 0});
  }
  reader.require_end();
}

/// The first physical group of every entity (dimension, number) of format 4.1.
EntityGroups read_entities(const std::string &path, const Sections &sections)
{
  EntityGroups groups;
  if (sections.count("$Entities") == 0)
    return groups;
  SectionReader reader = reader_of(path, sections, "$Entities");
  std::array<std::size_t, 4> n_entities{};
  for (std::size_t &n : n_entities)
    n = reader.count();
  for (std::size_t dimension = 0; dimension < n_entities.size(); ++dimension)
    for (std::size_t i = 0; i < n_entities[dimension]; ++i)
    {
      const long number = reader.number_of_group();
      reader.skip(dimension == 0 ? 3 : 6); // a place, or a box
      for (std::size_t n = reader.count(), first = n; n > 0; --n)
        if (const long group = reader.number_of_group(); n == first)
          groups[{dimension, number}] = group;
      for (std::size_t n = dimension > 0 ? reader.count() : 0; n > 0; --n)
        reader.number_of_group(); // of the entities around it
    }
  reader.require_end();
  return groups;
}

/// The numbers of the nodes, sorted, each with its place among the nodes of the file.
NodeNumbers in_order(const std::vector<long> &given, const std::string &path)
{
  NodeNumbers numbers;
  for (const long number : given)
    numbers.emplace_back(number, static_cast<unsigned int>(numbers.size()));
  std::sort(numbers.begin(), numbers.end());
  std::size_t n_different = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    n_different += i == 0 || numbers[i].first != numbers[i - 1].first ? 1 : 0;
  if (n_different != numbers.size())
    throw InputError(path + ": has " + std::to_string(n_different) + " different nodes: allowed are the " +
                     std::to_string(numbers.size()) + " that section $Nodes says");
  return numbers;
}

NodeNumbers read_nodes(const Sections &sections, const bool in_blocks, GmshFile &file)
{
  SectionReader reader = reader_of(file.path, sections, "$Nodes");
  const auto read_place = [&]
  {
    file.nodes.emplace_back();
    for (double &coordinate : file.nodes.back())
      coordinate = reader.number();
  };
  std::size_t n_blocks = in_blocks ? reader.count() : 1;
  const std::size_t n_nodes = reader.count();
  if (in_blocks)
    reader.skip_range();
  std::vector<long> numbers;
  for (; n_blocks > 0; --n_blocks)
  {
    if (in_blocks)
    {
      reader.dimension();
      reader.number_of_group();
      reader.whole_between(0, 0); // no coordinates on its entity
    }
    const std::size_t n = in_blocks ? reader.count() : n_nodes;
    for (std::size_t i = 0; i < n; ++i)
    {
      numbers.push_back(reader.number_of_thing());
      if (!in_blocks)
        read_place();
    }
    for (std::size_t i = 0; in_blocks && i < n; ++i)
      read_place();
  }
  reader.require_end();
  if (numbers.size() != n_nodes)
    throw InputError(file.path + ": has " + std::to_string(numbers.size()) + " nodes: allowed are the " +
                     std::to_string(n_nodes) + " that section $Nodes says");
  return in_order(numbers, file.path);
}

/// Whether the format is 4.1, in blocks, and not 2.1 or 2.2. Throws InputError for any other.
bool is_in_blocks(const std::string &path, const Sections &sections)
{
  SectionReader reader = reader_of(path, sections, "$MeshFormat");
  const double version = reader.number();
  if (version != 2 && version != 2.1 && version != 2.2 && version != 4.1)
    throw InputError(path + ": is of format " + to_text(version) +
                     ": allowed are 2.1, 2.2 and 4.1 (gmsh: Mesh.MshFileVersion = 4.1), which " + converter +
                     " writes");
  if (reader.count() != 0)
    throw InputError(path + ": is a binary mesh: allowed is one in ASCII (gmsh: Mesh.Binary = 0), which " +
                     converter + " writes");
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
                       "': allowed is $MeshFormat, with which a mesh by Gmsh begins; " + converter +
                       " makes one of Abaqus .inp and other meshes");
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

GmshFile collect_gmsh_file(const std::string &file_name, const std::optional<double> thickness)
{
  constexpr TextFileKind kind{"a mesh by Gmsh in ASCII (.msh, format 2.1, 2.2 or 4.1), which "
                              "tools/import makes of binary files and of other meshes,",
                              500, "a mesh is wanted"};
  GmshFile file;
  file.thickness = thickness;
  file.path = shown_path(file_name);
  const std::string text = with_plain_lines(read_text_file(file_name, "", kind));
  const Sections sections = sections_of(file.path, text);
  const bool in_blocks = is_in_blocks(file.path, sections);
  read_names(sections, file);
  const NodeNumbers nodes = read_nodes(sections, in_blocks, file);
  SectionReader elements = reader_of(file.path, sections, "$Elements");
  read_gmsh_elements(elements, read_entities(file.path, sections), nodes, in_blocks, file);
  if (thickness)
    extrude(file);
  std::sort(file.groups.begin(), file.groups.end(),
            [](const PhysicalGroup &a, const PhysicalGroup &b)
            { return std::make_pair(a.dimension, a.number) < std::make_pair(b.dimension, b.number); });
  return file;
}

GmshFile read_gmsh_file(const std::string &file_name, const std::optional<double> thickness)
{
  GmshFile file = collect_gmsh_file(file_name, thickness);
  file.faults.throw_if_any(file.path + ": ");
  return file;
}
} // namespace orthocone
