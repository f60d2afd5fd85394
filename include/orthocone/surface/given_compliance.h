// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/mirror_images.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The compliance of a matrix from outside, and what rounding had made of it, relative to the blocks of the
/// nodes (block_scale()): the largest difference of mirror images, and a negative eigenvalue with its sign
/// changed. Both are 0 where rounding of double precision explains them.
struct GivenCompliance
{
  std::unique_ptr<DenseCompliance> compliance;
  double asymmetry = 0;
  double indefiniteness = 0;

  /// A sentence on each that is not 0.
  std::vector<std::string> notes() const;
};

/// Checks a symmetric matrix W (3 n x 3 n, mm/N) that comes from outside, and was `mirrored` so far from
/// symmetric there. Returns GivenCompliance::indefiniteness. Throws std::invalid_argument, whose message
/// begins with "W ", if
/// - an entry is no number, or negative on the diagonal;
/// - W is indefinite by more than explain errors of its entries of single precision, or those that `mirrored`
///   shows. Every pair of directions is looked at, and up to 200 nodes the whole matrix (by a factorization
///   of a copy). Beyond, it is every node by itself, and Lanczos' method finds eigenvalues below about minus
///   a tenth of the largest one.
double check_compliance(const DenseView &w, const MirrorDifference &mirrored = {});

/// The compliance of a matrix from outside, for displacements q (3 n, mm) without forces. It uses the memory
/// of `w`, which must outlive it. Where mirror images differ by more than rounding of double precision, it is
/// a copy, the symmetric part of W. `mirrored`: how far W had been from symmetric before the caller took
/// its symmetric part. A node may be unable to move in a direction: its row of W is zero. If it neither slips
/// nor penetrates there in q, it needs no force there. Then the compliance is a copy of W with one of its own
/// in this direction, coupled with nothing. Else it throws std::invalid_argument, as it does where
/// check_compliance() or mirror_difference() throws.
GivenCompliance given_compliance(const DenseView &w, const NodeVector &q,
                                 const MirrorDifference &mirrored = {});

/// The directions (rows of W) in which a node cannot move: rounding leaves nothing of their diagonal.
std::vector<Eigen::Index> immobile_directions(const DenseView &w);
} // namespace orthocone
