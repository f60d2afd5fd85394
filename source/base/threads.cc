// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "blas_function.h"

#include <orthocone/base/control_group.h>
#include <orthocone/base/threads.h>

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace orthocone
{
namespace
{
/// How many cores' time a control group allows. Its file has "quota period"; in version 1 these are two
/// files. Infinite for "max" and -1.
double cores_of_group(const std::string &folder, const bool is_unified)
{
  double quota = -1, period = 0;
  if (is_unified)
    std::ifstream(folder + "/cpu.max") >> quota >> period;
  else
  {
    std::ifstream(folder + "/cpu.cfs_quota_us") >> quota;
    std::ifstream(folder + "/cpu.cfs_period_us") >> period;
  }
  return quota > 0 && period > 0 ? quota / period : std::numeric_limits<double>::infinity();
}

} // namespace

UsableCores usable_cores()
{
  cpu_set_t mask;
  CPU_ZERO(&mask);
  const auto allowed = static_cast<unsigned int>(std::max(
      1L, sched_getaffinity(0, sizeof mask, &mask) == 0 ? CPU_COUNT(&mask) : sysconf(_SC_NPROCESSORS_ONLN)));
  const double granted = std::ceil(least_in_control_groups("cpu", cores_of_group));
  return {allowed, granted < allowed ? static_cast<unsigned int>(std::max(1., granted)) : allowed};
}

bool depends_on_load(const double unknowns, const UsableCores &cores)
{
  constexpr double small = 3000; // docs/performance.md, "Threads"
  return cores.granted > 1 && unknowns >= small;
}

ThreadChoice choose_threads(const double unknowns, const UsableCores &cores, const double n_busy)
{
  if (!depends_on_load(unknowns, cores))
    return {1, cores.granted == 1 ? "there is one core" : "the model is small"};
  const auto n_others = static_cast<unsigned int>(std::lround(n_busy));
  const unsigned int n_free = cores.allowed > n_others ? cores.allowed - n_others : 1;
  return {std::min(cores.granted, n_free),
          std::to_string(cores.granted) + " cores, others busy on " + std::to_string(n_others)};
}

/// CHOLMOD's loops ask OpenMP for four threads, whatever OMP_NUM_THREADS says. With no active level they get
/// the calling one.
static void set_openmp_levels(const int number)
{
  if (auto *const set = function_of_blas<void(int)>("omp_set_max_active_levels"))
    set(number);
}

void set_blas_threads(const unsigned int number)
{
  set_openmp_levels(number > 1 ? 1 : 0);
  if (auto *const set = function_of_blas<void(int)>("openblas_set_num_threads"))
    set(static_cast<int>(number));
}

unsigned int blas_threads()
{
  auto *const get = function_of_blas<int()>("openblas_get_num_threads");
  return get == nullptr ? 1 : static_cast<unsigned int>(std::max(1, get()));
}

std::optional<ThreadChoice> threads_of_environment()
{
  for (const char *const name : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"})
    if (std::getenv(name) != nullptr)
      return ThreadChoice{blas_threads(), name};
  return std::nullopt;
}

unsigned int product_threads(const long n)
{
  constexpr long large = 8000; // in single precision half of the matrix fills no cache any more
  return n >= large ? blas_threads() : 1;
}

BlasThreads::BlasThreads(const long n)
{
  if (product_threads(n) == blas_threads())
    return;
  n_before_ = blas_threads();
  set_blas_threads(1);
}

BlasThreads::~BlasThreads()
{
  if (n_before_ > 0)
    set_blas_threads(n_before_);
}
} // namespace orthocone
