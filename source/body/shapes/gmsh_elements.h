// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "gmsh_sections.h"

#include <orthocone/body/shapes/gmsh_file.h>

#include <map>
#include <utility>
#include <vector>

namespace orthocone
{
/// The first physical group of every entity (dimension, number).
using EntityGroups = std::map<std::pair<std::size_t, long>, long>;

/// The number of every node and its place among GmshFile::nodes, sorted by the numbers.
using NodeNumbers = std::vector<std::pair<long, unsigned int>>;

/// Reads section $Elements of format 4.1 (`in_blocks`) or 2.2 into `file`, and counts the elements of each
/// physical group. Throws InputError unless every number is one that readers can hold. Nodes that are not
/// there, elements besides hexahedra with what lies around them, and two orders become faults of the file.
void read_gmsh_elements(SectionReader &reader, const EntityGroups &groups, const NodeNumbers &nodes,
                        bool in_blocks, GmshFile &file);
} // namespace orthocone
