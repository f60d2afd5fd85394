// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/step_solver.h>

namespace orthocone
{
/// Collects what the processes of a run remember on the first one: the bodies of one process behind those of
/// the process before. All processes must call it.
StartMemory gathered(StartMemory memory);

/// The part of this process. Bodies that `n_ranks_then` processes shared do not fit another number of
/// processes: then the part has no bodies.
StartMemory part_of_this_rank(StartMemory memory, unsigned int n_ranks_then);
} // namespace orthocone
