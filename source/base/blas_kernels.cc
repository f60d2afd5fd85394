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
/// OpenBLAS's name of its best kernels for this processor, or null for its own choice.
const char *kernels_of_this_processor()
{
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return "Haswell";
#endif
  return nullptr;
}
} // namespace

void use_kernels_of_this_processor()
{
  constexpr const char *variable = "OPENBLAS_CORETYPE";
  const auto name = function_of_blas<char *()>("openblas_get_corename");
  // OpenBLAS exports both, but declares them in none of its headers.
  const auto forget = function_of_blas<void()>("gotoblas_dynamic_quit");
  const auto choose = function_of_blas<void()>("gotoblas_dynamic_init");
  const char *const kernels = kernels_of_this_processor();
  if (std::getenv(variable) != nullptr || name == nullptr || forget == nullptr || choose == nullptr ||
      std::string(name()) != "Prescott" || kernels == nullptr)
    return;
  ::setenv(variable, kernels, 0);
  forget();
  choose();
}
} // namespace orthocone
