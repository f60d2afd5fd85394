// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/ranks.h>

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace orthocone
{
namespace
{
bool is_started()
{
  int started = 0, ended = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&ended);
  return started != 0 && ended == 0;
}

unsigned int asked(int (*const ask)(MPI_Comm, int *), const int otherwise)
{
  int answer = otherwise;
  if (is_started())
    ask(MPI_COMM_WORLD, &answer);
  return static_cast<unsigned int>(answer);
}

/// MPI counts in int.
constexpr std::size_t most_at_once = std::numeric_limits<int>::max() / 2;

/// Replaces each of `n` values by what all ranks make of theirs.
void reduce(double *values, std::size_t n, const MPI_Op operation)
{
  if (n_ranks() == 1)
    return;
  for (std::size_t part = std::min(n, most_at_once); n > 0; n -= part, values += part)
  {
    part = std::min(n, most_at_once);
    MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(part), MPI_DOUBLE, operation, MPI_COMM_WORLD);
  }
}

/// The text of one rank on all of them.
std::string text_of(const unsigned int rank, std::string text)
{
  if (n_ranks() == 1)
    return text;
  unsigned long long size = text.size();
  MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, static_cast<int>(rank), MPI_COMM_WORLD);
  text.resize(size);
  for (std::size_t at = 0; at < size; at += most_at_once)
    MPI_Bcast(text.data() + at, static_cast<int>(std::min(most_at_once, text.size() - at)), MPI_CHAR,
              static_cast<int>(rank), MPI_COMM_WORLD);
  return text;
}
} // namespace

bool is_launched()
{
  // Open MPI sets the first one, MPICH and its descendants the second one, srun the third one.
  const char *const names[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(std::begin(names), std::end(names),
                     [](const char *const name) { return std::getenv(name) != nullptr; });
}

unsigned int n_ranks()
{
  return asked(MPI_Comm_size, 1);
}

unsigned int this_rank()
{
  return asked(MPI_Comm_rank, 0);
}

void sum_over_ranks(double *values, std::size_t n)
{
  reduce(values, n, MPI_SUM);
}

void largest_of_ranks(double *values, std::size_t n)
{
  reduce(values, n, MPI_MAX);
}

double sum_over_ranks(double value)
{
  sum_over_ranks(&value, 1);
  return value;
}

double largest_of_ranks(double value)
{
  if (n_ranks() > 1)
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

bool any_rank(const bool value)
{
  return largest_of_ranks(value ? 1 : 0) > 0;
}

bool of_first_rank(const bool value)
{
  return any_rank(value && is_first_rank());
}

double of_first_rank(double value)
{
  if (n_ranks() > 1)
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return value;
}

std::string of_first_rank(std::string text)
{
  return text_of(0, std::move(text));
}

std::vector<std::string> gather_on_first(const std::string &text)
{
  std::vector<std::string> texts;
  for (unsigned int rank = 0; rank < n_ranks(); ++rank)
    if (std::string of_rank = text_of(rank, text); is_first_rank())
      texts.push_back(std::move(of_rank));
  return texts;
}

void wait_for_all_ranks()
{
  if (n_ranks() > 1)
    MPI_Barrier(MPI_COMM_WORLD);
}
} // namespace orthocone
