// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/threads.h>
#include <orthocone/body/backends/stiffness_factor.h>

#include <gtest/gtest.h>
#include <sys/time.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace orthocone::test
{
namespace
{
/// Entries on and below the diagonal of a seven-point stencil on n x n x n points.
dealii::SparsityPattern stencil(const unsigned int n)
{
  dealii::SparsityPattern pattern(n * n * n, n * n * n, 4);
  for (unsigned int i = 0; i < n * n * n; ++i)
  {
    pattern.add(i, i);
    if (i % n > 0)
      pattern.add(i, i - 1);
    if (i / n % n > 0)
      pattern.add(i, i - n);
    if (i / (n * n) > 0)
      pattern.add(i, i - n * n);
  }
  pattern.compress();
  return pattern;
}

/// Sends this process a SIGTERM after so many milliseconds.
void terminate_after(const int milliseconds)
{
  std::signal(SIGALRM, [](int) { std::raise(SIGTERM); });
  itimerval timer{};
  timer.it_value.tv_usec = 1000 * milliseconds;
  setitimer(ITIMER_REAL, &timer, nullptr);
}

auto threads_of_process()
{
  const std::filesystem::directory_iterator first("/proc/self/task"), end;
  return std::distance(first, end);
}
} // namespace

// Nested dissection of a cube against the band of the order as given.
TEST(Ordering, KeepsTheFactorSparse)
{
  const unsigned int n = 20, n_points = n * n * n;
  const FactorizationCost cost = factorization_cost(stencil(n), n_points);
  const double banded = std::pow(n, 5.);
  EXPECT_LT(cost.entries, 0.5 * banded);
  EXPECT_GT(cost.entries, 4. * n_points);
}

// CHOLMOD asks OpenMP for four threads in every supernode. In a small run these cost more than they do.
TEST(Factorization, StartsNoThreadsWhereThereIsOne)
{
  const auto pattern = stencil(20);
  dealii::SparseMatrix<double> matrix(pattern);
  for (unsigned int row = 0; row < matrix.m(); ++row)
    for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
      entry->value() = entry->column() == row ? 7 : -1;
  const unsigned int blas_before = blas_threads();
  set_blas_threads(1);
  const auto threads_before = threads_of_process();
  const StiffnessFactor factor(matrix, matrix.m());
  EXPECT_LE(threads_of_process(), threads_before); // OpenBLAS ends its own where METIS forks
  set_blas_threads(blas_before);
}

// METIS has a handler of its own for SIGTERM, the signal that batch systems and containers stop a run by.
TEST(OrderingDeathTest, IsStoppedBySigterm)
{
  const auto pattern = stencil(36);
  for (const int milliseconds : {60, 90, 120, 150})
    EXPECT_EXIT(
        {
          terminate_after(milliseconds);
          for (unsigned int i = 0; i < 4; ++i)
            factorization_cost(pattern, pattern.n_rows());
          std::exit(0);
        },
        testing::KilledBySignal(SIGTERM), "");
}
} // namespace orthocone::test
