// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace orthocone
{
// The processes of one run are its ranks: several where mpirun has started them, else one. All ranks must
// call functions that concern all ranks, in the same order. Nothing here throws.

/// Whether a launcher of MPI has started this process.
bool is_launched();

/// Number of the processes of this run, at least 1, and the number of this one, counted from 0.
unsigned int n_ranks();
unsigned int this_rank();
inline bool is_first_rank()
{
  return this_rank() == 0;
}

/// Sums over all ranks, entry by entry (`n` numbers), with the same bits on each rank.
void sum_over_ranks(double *values, std::size_t n);
double sum_over_ranks(double value);

/// The largest value of all ranks, and whether any rank has true, on each of them.
double largest_of_ranks(double value);
void largest_of_ranks(double *values, std::size_t n); ///< entry by entry
bool any_rank(bool value);

/// Returns the first rank's value on all ranks.
bool of_first_rank(bool value);
double of_first_rank(double value);
std::string of_first_rank(std::string text);

/// Returns the texts of all ranks, in their order, on the first one, and none on the others.
std::vector<std::string> gather_on_first(const std::string &text);

/// Returns when all ranks have called it.
void wait_for_all_ranks();
} // namespace orthocone
