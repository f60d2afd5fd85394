// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/step_solver.h>

namespace orthocone
{
/// What the processes of a run remember, all of it on the first one: the bodies of one process behind those
/// of the other. Must be called by all.
StartMemory gathered(StartMemory memory);

/// The part of this process. Bodies that `n_ranks_then` processes shared do not fit any other number: then
/// there are none.
StartMemory part_of_this_rank(StartMemory memory, unsigned int n_ranks_then);
} // namespace orthocone
