// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "blas_function.h"

#include <orthocone/base/blas_kernels.h>

#include <cstdlib>
#include <string>

namespace orthocone
{
namespace
{
bool has_avx2()
{
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}
} // namespace

void use_kernels_of_this_processor()
{
  constexpr const char *variable = "OPENBLAS_CORETYPE";
  const auto name = function_of_blas<char *()>("openblas_get_corename");
  // OpenBLAS exports both, but declares them in none of its headers.
  const auto forget = function_of_blas<void()>("gotoblas_dynamic_quit");
  const auto choose = function_of_blas<void()>("gotoblas_dynamic_init");
  if (std::getenv(variable) != nullptr || name == nullptr || forget == nullptr || choose == nullptr ||
      std::string(name()) != "Prescott" || !has_avx2())
    return;
  ::setenv(variable, "Haswell", 0);
  forget();
  choose();
}
} // namespace orthocone
