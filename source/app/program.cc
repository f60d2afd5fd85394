// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/app/program.h>

#include "dispatch.h"
#include "launch.h"

#include <orthocone/base/threads.h>

#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace orthocone
{
void run_program(const int argc, const char *const *const argv)
{
  // Factorizations report NaN themselves. To look for it first takes 4 % of a small step.
  ::setenv("LAPACKE_NANCHECK", "0", 0);
  use_kernels_of_this_processor();
  Launch launch(argc, argv);
  const int code = guarded_dispatch(argc, argv);
  std::cout.flush();
  launch.end(code);
  // No file is open any more. OpenBLAS, asked to end without memory, would wait for its threads for ever.
  ::_exit(code);
}
} // namespace orthocone
