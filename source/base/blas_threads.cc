// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/blas_threads.h>

#include <dlfcn.h>

namespace orthocone
{
namespace
{
/// Debian's alternatives decide at run time which BLAS is there.
void set_threads(const int n)
{
  if (auto *const set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(n);
}

int threads()
{
  auto *const get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  return get == nullptr ? 1 : get();
}
} // namespace

BlasThreads::BlasThreads(const Eigen::Index n)
{
  constexpr Eigen::Index large = 8000; // in single precision half of the matrix fills no cache any more
  if (n >= large || threads() == 1)
    return;
  n_before_ = threads();
  set_threads(1);
}

BlasThreads::~BlasThreads()
{
  if (n_before_ > 0)
    set_threads(n_before_);
}
} // namespace orthocone
