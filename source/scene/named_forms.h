// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Sparse>

namespace orthocone
{
/// Replaces the distances (n, mm) of contact nodes from the lower surface `own`, along their normals, by
/// those from the cylinder or sphere that this surface is by name (Curved surfaces, or the side of a
/// cylinder). `map` is n x m, and says which surface a node sees.
///
/// Cells of a curved surface miss it by a length of the order h^4 / R^3 at best, and by another one in each
/// of two unequal meshes. Pressed together, this becomes a pressure of the order E h^3 / R^3 between
/// neighbours, which has nothing to do with the parts: on quadratic cells of 8 and 10 degrees, 6 % of the
/// pressure of an interference of a thousandth of the radius (docs/theory.md, section 2, "Curved surfaces of
/// two bodies").
void measure_from_named_forms(const GeometryOptions &lower, const ContactSurface &surface,
                              const ContactSurface &own, const Eigen::SparseMatrix<double> &map,
                              Eigen::VectorXd &distances);
} // namespace orthocone
