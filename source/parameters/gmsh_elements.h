// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "gmsh_sections.h"

#include <orthocone/parameters/gmsh_file.h>

#include <map>
#include <utility>
#include <vector>

namespace orthocone
{
/// The first physical group of every entity (dimension, number).
using EntityGroups = std::map<std::pair<std::size_t, long>, long>;

/// Reads section $Elements of format 4.1 (`in_blocks`) or 2.2, and counts the elements of each physical group
/// in `file`. `nodes` are the numbers of the nodes, sorted. Throws InputError unless every number is one that
/// readers can hold, every node is there, and the elements are linear hexahedra with what lies around them.
void read_gmsh_elements(SectionReader &reader, const EntityGroups &groups, const std::vector<long> &nodes,
                        bool in_blocks, GmshFile &file);
} // namespace orthocone
