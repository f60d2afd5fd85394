// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dispatch.h"
#include "launch.h"

#include <orthocone/base/threads.h>

#include <unistd.h>

#include <cstdlib>
#include <iostream>

int main(const int argc, const char *const *const argv)
{
  // Factorizations report NaN themselves. To look for it first takes 4 % of a small step.
  ::setenv("LAPACKE_NANCHECK", "0", 0);
  orthocone::use_kernels_of_this_processor();
  orthocone::Launch launch(argc, argv);
  const int code = orthocone::guarded_dispatch(argc, argv);
  std::cout.flush();
  launch.end(code);
  // No file is open any more. OpenBLAS, asked to end without memory, would wait for its threads for ever.
  ::_exit(code);
}
