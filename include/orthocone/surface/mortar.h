// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>

#include <Eigen/Sparse>

#include <array>

namespace orthocone
{
/// What the nodes of one contact surface see of another one, whose faces need not match theirs.
struct MortarMap
{
  /// n x m, P: displacements of the other's m nodes make P u at the n nodes, and forces r of the n nodes are
  /// P^T r at the others. Sums of forces and moments stay what they are, to rounding; a uniform traction
  /// stays uniform, to rounding where cells are parallelograms.
  Eigen::SparseMatrix<double> map;

  double least_cover = 1;                  ///< the part of a face that the other surface covers, the least
  std::array<double, 2> uncovered{{0, 0}}; ///< centre of that face, mm
};

/// Dual multipliers on `surface` (B. I. Wohlmuth, SIAM J. Numer. Anal. 38, 2000): each node has the traction
/// that no other node's displacement works on, and what it sees is the other surface's displacement weighted
/// with that. Faces are cut with those of the other surface in the plane z = 0, and integrated piece by
/// piece. Surfaces of degree 1 to 3 without hanging nodes, both of the same model. The map is empty unless
/// nine tenths of every face are covered.
MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other);
} // namespace orthocone
