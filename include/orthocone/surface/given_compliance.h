// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// Checks a matrix W (3 n x 3 n, mm/N) that comes from outside. Throws std::invalid_argument, whose message
/// begins with "W ", if
/// - an entry is no number, or negative on the diagonal;
/// - W is not symmetric to 1e-8 of its diagonal;
/// - W is indefinite by more than such errors of its entries explain. Every pair of directions is looked at,
///   and up to 200 nodes the whole matrix (by a factorization of a copy). Beyond, it is every node by itself,
///   and Lanczos' method finds eigenvalues below about minus a tenth of the largest one.
void check_compliance(const DenseView &w);

/// The compliance of a matrix from outside, for displacements q (3 n, mm) without forces. It uses the memory
/// of `w`, which must outlive it. A node may be unable to move in a direction: its row of W is zero. If it
/// neither slips nor penetrates there in q, it needs no force there. Then the compliance is a copy of W with
/// one of its own in this direction, coupled with nothing. Else it throws std::invalid_argument, as it does
/// where check_compliance() throws.
DenseCompliance given_compliance(const DenseView &w, const NodeVector &q);

/// The directions (rows of W) in which a node cannot move: rounding leaves nothing of their diagonal.
std::vector<Eigen::Index> immobile_directions(const DenseView &w);
} // namespace orthocone
