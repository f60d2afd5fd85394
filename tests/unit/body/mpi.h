// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <mpi.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace orthocone::test
{
/// Starts MPI, as multigrid would. What MPI does not free is no leak of ours.
inline void start_mpi_unwatched()
{
  int is_started = 0;
  MPI_Initialized(&is_started);
  if (is_started != 0)
    return;
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler unwatched;
#endif
  MPI_Init(nullptr, nullptr);
}
} // namespace orthocone::test
