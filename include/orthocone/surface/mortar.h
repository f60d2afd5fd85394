// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Sparse>

namespace orthocone
{
/// How the faces of two contact surfaces find each other.
enum class Facing
{
  along_z,      ///< in the plane z = 0, about which the other surface is mirrored
  along_normals ///< along the normals of the first surface; both lie in their places
};

/// How much of a contact surface another one covers.
struct SurfaceCover
{
  /// Nine tenths of every face (docs/theory.md, section 2, "A second elastic body below").
  bool is_enough() const { return least >= 0.9; }

  double least = 1;                                    ///< least part of a face that is covered
  Eigen::Vector3d uncovered = Eigen::Vector3d::Zero(); ///< centre of that face, mm; z = 0 along z
};

/// The cover of `surface` by `other`, without the work of a map. The surfaces are as for mortar_map().
SurfaceCover surface_cover(const ContactSurface &surface, const ContactSurface &other,
                           Facing facing = Facing::along_z);

/// Part of the area of `surface` that lies on `other`, 0 to 1; 1 where `surface` has no faces.
double covered_share(const ContactSurface &surface, const ContactSurface &other,
                     Facing facing = Facing::along_z);

/// How the nodes of one contact surface see another one, whose faces need not match theirs.
struct MortarMap
{
  /// P, n x m, without units: displacements u of the other surface's m nodes are P u at the n nodes, and
  /// forces r of the n nodes are P^T r at the m nodes. Sums of forces are kept to rounding; those of moments
  /// and a uniform traction as well where the surfaces are flat, the traction if cells are parallelograms. On
  /// curved surfaces both are kept to the order of the faces' geometry.
  Eigen::SparseMatrix<double> map;

  SurfaceCover cover;
};

/// The map by dual multipliers on `surface` (B. I. Wohlmuth, SIAM J. Numer. Anal. 38, 2000; docs/theory.md,
/// section 2, "A second elastic body below"). The displacements of other nodes do no work on the traction of
/// a node, and a node sees the other surface's displacement weighted with this traction. Faces of both
/// surfaces are cut with each other in a plane, and integrated piece by piece. The surfaces must have
/// degree 1 to 3 and no hanging nodes, and belong to the same model. The map is empty unless the
/// cover is enough. Throws std::logic_error for another degree.
MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other,
                     Facing facing = Facing::along_z);

/// Distances of the n nodes of `surface`, along their normals, from what they see of the other surface by the
/// map P of Facing::along_normals: n . (x - P X), n numbers, mm; < 0 where the bodies overlap.
Eigen::VectorXd distances(const ContactSurface &surface, const ContactSurface &other,
                          const Eigen::SparseMatrix<double> &map);

/// B W B^T, symmetric to the last bit: a symmetric compliance W as it is seen through a map B.
Eigen::MatrixXd mapped_compliance(const Eigen::SparseMatrix<double> &map, const DenseView &compliance);
} // namespace orthocone
