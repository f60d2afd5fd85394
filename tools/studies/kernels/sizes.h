// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "scene.h"

#include <benchmark/benchmark.h>

namespace orthocone::benchmarks
{
/// Times a kernel for the scenes of all sizes (cells along a side of the core); a filter of the command line
/// chooses among them. Wall time, because kernels may use all cores.
inline void all_sizes(benchmark::internal::Benchmark *const kernel)
{
  for (const int core_cells : {2, 4, 6, 8, 12, 16, 24, 32})
    kernel->Arg(core_cells);
  kernel->Unit(benchmark::kMillisecond)->UseRealTime();
}

/// The scene of a kernel, with its size in the counters.
inline const Scene &scene_of(benchmark::State &state)
{
  const Scene &result = scene(static_cast<unsigned int>(state.range(0)));
  state.counters["contact_nodes"] = static_cast<double>(result.problem.n_nodes());
  state.counters["dofs"] = result.discretization.n_dofs();
  return result;
}
} // namespace orthocone::benchmarks
