// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Sparse>

#include <array>

namespace orthocone
{
/// How much of a contact surface another one covers, in the plane z = 0.
struct SurfaceCover
{
  /// Nine tenths of every face (docs/theory.md, section 2, "A second elastic body below").
  bool is_enough() const { return least >= 0.9; }

  double least = 1;                        ///< least part of a face that is covered
  std::array<double, 2> uncovered{{0, 0}}; ///< centre of that face, mm
};

/// The cover of `surface` by `other`, without the work of a map. The surfaces are as for mortar_map().
SurfaceCover surface_cover(const ContactSurface &surface, const ContactSurface &other);

/// Part of the area of `surface` that lies on `other`, 0 to 1; 1 where `surface` has no faces.
double covered_share(const ContactSurface &surface, const ContactSurface &other);

/// How the nodes of one contact surface see another one, whose faces need not match theirs.
struct MortarMap
{
  /// P, n x m, without units: displacements u of the other surface's m nodes are P u at the n nodes, and
  /// forces r of the n nodes are P^T r at the m nodes. Sums of forces and moments are kept to rounding. A
  /// uniform traction stays uniform, to rounding where cells are parallelograms.
  Eigen::SparseMatrix<double> map;

  SurfaceCover cover;
};

/// The map by dual multipliers on `surface` (B. I. Wohlmuth, SIAM J. Numer. Anal. 38, 2000; docs/theory.md,
/// section 2, "A second elastic body below"). The displacements of other nodes do no work on the traction of
/// a node, and a node sees the other surface's displacement weighted with this traction. Faces of both
/// surfaces are cut with each other in the plane z = 0, and integrated piece by piece. The surfaces must have
/// degree 1 to 3 and no hanging nodes, and belong to the same model. The map is empty unless the
/// cover is enough. Throws std::logic_error for another degree.
MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other);

/// B W B^T, symmetric to the last bit: a symmetric compliance W as it is seen through a map B.
Eigen::MatrixXd mapped_compliance(const Eigen::SparseMatrix<double> &map, const DenseView &compliance);
} // namespace orthocone
