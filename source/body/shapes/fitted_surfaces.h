// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_curves.h"

#include <orthocone/body/options.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The faces of a surface that the entry Curved surfaces names.
struct FacesOfSurface
{
  CurvedSurface surface;
  std::vector<dealii::Triangulation<3>::active_face_iterator> faces;
};

/// Finds plane, radius and forms of the surfaces, moves their vertices exactly onto them, and enters the
/// lines and faces there into `curves`. A plane face beside them stays plane, because its lines on a surface
/// lie in the plane, too. `entry` is how messages begin. Throws InputError where a vertex is off its surface
/// by more than a millionth of the radius, or of the `extent` (mm) of the body for a plane.
void fit_surfaces(const std::vector<FacesOfSurface> &surfaces, const std::string &entry, double extent,
                  dealii::Triangulation<3> &mesh, CoarseCurves<3> &curves);
} // namespace orthocone
