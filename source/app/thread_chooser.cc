// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "thread_chooser.h"

#include <orthocone/base/ranks.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <string>

namespace orthocone
{
namespace
{
/// No more threads than have buffers of BLAS: each has its own of OpenBLAS, and calls BLAS itself.
ThreadChoice with_buffers(ThreadChoice choice)
{
  const unsigned int n_mapped = map_blas_buffers(2 * choice.number);
  if (n_mapped < 2 * choice.number && choice.number > 1)
    choice = {std::max(1U, n_mapped / 2), choice.reason + ", but 'ulimit -v' has no room for more"};
  return choice;
}
} // namespace

ThreadChoice ThreadChooser::decide(const double unknowns) const
{
  if (on_command_line_ > 0)
    return {on_command_line_, "--threads"};
  if (n_ranks() > 1)
    return {1, "one for each of " + std::to_string(n_ranks()) + " processes"};
  if (of_run_before_ > 0)
    return {of_run_before_, "as in the run before"};
  if (auto given = threads_of_environment())
    return *given;
  const UsableCores cores = usable_cores();
  return choose_threads(unknowns, cores, depends_on_load(unknowns, cores) ? load_.busy_cores() : 0);
}

const ThreadChoice &ThreadChooser::choose(const double unknowns)
{
  if (!chosen_)
  {
    chosen_ = with_buffers(decide(unknowns));
    set_blas_threads(chosen_->number);
    dealii::MultithreadInfo::set_thread_limit(chosen_->number);
  }
  return *chosen_;
}
} // namespace orthocone
