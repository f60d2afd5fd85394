// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_curves.h"

#include <orthocone/body/shapes/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <vector>

namespace orthocone
{
/// For the number of each physical surface its faces on the outside of the cells, sorted.
using FacesOfGroups = std::map<unsigned int, std::vector<dealii::Triangulation<3>::active_face_iterator>>;

/// Fills `triangulation` with the hexahedra of a mesh file, whose boundary and material ids are the numbers
/// of the first physical groups, and `curves` with the middles that elements of second order have; it
/// stays empty where there are none. Returns the faces of all groups. Throws InputError, which names the
/// file, if the hexahedra do not fit together.
FacesOfGroups make_imported_cells(const GmshFile &file, dealii::Triangulation<3> &triangulation,
                                  CoarseCurves<3> &curves);
} // namespace orthocone
