// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <dlfcn.h>

namespace orthocone
{
/// A function of the BLAS that runs, or of what runs with it: Debian's alternatives decide that at run time.
/// Null if there is none of that name.
template<typename Function>
Function *function_of_blas(const char *const name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}
} // namespace orthocone
