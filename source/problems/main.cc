// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solve_command.h"

#include <orthocone/base/threads.h>

#include <cstdlib>
#include <iostream>

int main(const int n_arguments, const char *const *const arguments)
{
  // Factorizations report NaN themselves. To look for it first takes 4 % of a small step.
  ::setenv("LAPACKE_NANCHECK", "0", 0);
  orthocone::use_kernels_of_this_processor();
  return orthocone::solve_command({arguments + 1, arguments + n_arguments}, std::cout, std::cerr);
}
