// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <map>

namespace orthocone
{
/// Extrudes a mesh of quadrangles in the plane y = 0 by file.thickness to one layer of hexahedra between y =
/// 0 and there: quadrangles become hexahedra, lines quadrilaterals, and their groups those of volumes and
/// surfaces. What is off the plane becomes a fault of the file.
void extrude(GmshFile &file);

/// The quadrangles (x, z) of such a layer, with its material and boundary ids. Returns the numbers of the
/// vertices of the section by those of the layer. Throws std::logic_error where a cell has no face in y = 0.
std::map<unsigned int, unsigned int> flatten(const dealii::Triangulation<3> &layer,
                                             dealii::Triangulation<2> &section);
} // namespace orthocone
