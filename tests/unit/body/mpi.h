// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <mpi.h>

namespace orthocone::test
{
/// Starts MPI, as multigrid would.
inline void start_mpi()
{
  int is_started = 0;
  MPI_Initialized(&is_started);
  if (is_started == 0)
    MPI_Init(nullptr, nullptr);
}
} // namespace orthocone::test
