// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Rows of intervals that grow or shrink geometrically. Nothing here throws.
#pragma once

#include <vector>

namespace orthocone
{
/// Positions from 0 to 1 of the n + 1 ends of `n` > 0 intervals, each `grading` times as wide as the one
/// before.
std::vector<double> graded_positions(unsigned int n, double grading);

/// Positions from 0 to `length` (in its unit) of the n + 1 ends of `n` intervals. Each is `grading` times as
/// wide as its neighbour towards the middle.
std::vector<double> positions_graded_to_both_ends(double length, unsigned int n, double grading);

/// Width of the last of `n` intervals, each `grading` times as wide as the one before, relative to all of
/// them.
double last_share(unsigned int n, double grading);

/// The same for the thinnest of the intervals.
double thinnest_share(unsigned int n, double grading);

/// Width of the first of `n` intervals that are graded to both ends, relative to all of them.
double end_share(unsigned int n, double grading);
} // namespace orthocone
