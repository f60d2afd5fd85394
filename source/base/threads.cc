// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/threads.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace orthocone
{
namespace
{
/// A function of the BLAS that runs, or of what runs with it: Debian's alternatives decide that at run time.
/// Null if there is none of that name.
template<typename Function>
Function *function_of_blas(const char *const name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}

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

/// Whether OpenBLAS has taken kernels of an older kind than the processor has: of SSE3 on Intel's that it
/// does not know, and of AVX2 on AMD's with AVX-512.
bool are_slower(const std::string &running, const std::string &best)
{
  return running == "Prescott" || (best == "SkylakeX" && (running == "Haswell" || running == "Zen"));
}

/// Whether the running kernels multiply two matrices as plain loops do.
bool multiplies()
{
  constexpr int n = 67; // no multiple of the kernels' widths
  const auto dgemm = function_of_blas<void(const char *, const char *, const int *, const int *, const int *,
                                           const double *, const double *, const int *, const double *,
                                           const int *, const double *, double *, const int *)>("dgemm_");
  if (dgemm == nullptr)
    return false;
  std::vector<double> a(n * n), b(n * n), product(n * n);
  for (int i = 0; i < n * n; ++i)
  {
    a[i] = i % 7 - 3;
    b[i] = i % 11 - 5;
  }
  const double one = 1, zero = 0;
  dgemm("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, product.data(), &n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
    {
      double sum = 0; // of whole numbers: exact
      for (int k = 0; k < n; ++k)
        sum += a[i + k * n] * b[k + j * n];
      if (product[i + j * n] != sum)
        return false;
    }
  return true;
}

/// CHOLMOD's loops ask OpenMP for four threads, whatever OMP_NUM_THREADS says. With no active level they get
/// the calling one.
void set_openmp_levels(const int number)
{
  if (auto *const set = function_of_blas<void(int)>("omp_set_max_active_levels"))
    set(number);
}
} // namespace

bool depends_on_load(const double unknowns, const UsableCores &cores)
{
  constexpr double small = 3000; // docs/performance.md, "Threads"
  return cores.granted > 1 && unknowns >= small;
}

ThreadChoice choose_threads(const double unknowns, const UsableCores &cores, const double n_busy)
{
  if (!depends_on_load(unknowns, cores))
    return {1, cores.granted == 1 ? "there is one core" : "the model is small"};
  const auto n_others = static_cast<unsigned int>(std::lround(n_busy));
  const unsigned int n_free = cores.allowed > n_others ? cores.allowed - n_others : 1;
  return {std::min(cores.granted, n_free),
          std::to_string(cores.granted) + " cores, others busy on " + std::to_string(n_others)};
}

void set_blas_threads(const unsigned int number)
{
  set_openmp_levels(number > 1 ? 1 : 0);
  if (auto *const set = function_of_blas<void(int)>("openblas_set_num_threads"))
    set(static_cast<int>(number));
}

unsigned int blas_threads()
{
  auto *const get = function_of_blas<int()>("openblas_get_num_threads");
  return get == nullptr ? 1 : static_cast<unsigned int>(std::max(1, get()));
}

std::optional<ThreadChoice> threads_of_environment()
{
  for (const char *const name : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"})
    if (std::getenv(name) != nullptr)
      return ThreadChoice{blas_threads(), name};
  return std::nullopt;
}

unsigned int product_threads(const long n)
{
  constexpr long large = 8000; // in single precision half of the matrix fills no cache any more
  return n >= large ? blas_threads() : 1;
}

BlasThreads::BlasThreads(const long n)
{
  if (product_threads(n) == blas_threads())
    return;
  n_before_ = blas_threads();
  set_blas_threads(1);
}

BlasThreads::~BlasThreads()
{
  if (n_before_ > 0)
    set_blas_threads(n_before_);
}

void use_kernels_of_this_processor()
{
  constexpr const char *variable = "OPENBLAS_CORETYPE";
  const auto name = function_of_blas<char *()>("openblas_get_corename");
  // OpenBLAS exports both, but declares them in none of its headers.
  const auto forget = function_of_blas<void()>("gotoblas_dynamic_quit");
  const auto choose = function_of_blas<void()>("gotoblas_dynamic_init");
  const char *const kernels = kernels_of_this_processor();
  if (std::getenv(variable) != nullptr || name == nullptr || forget == nullptr || choose == nullptr ||
      kernels == nullptr || !are_slower(name(), kernels))
    return;
  const auto take = [&](const char *const which)
  {
    ::setenv(variable, which, 1);
    forget();
    choose();
  };
  const std::string before = name();
  take(kernels);
  if (!multiplies())
    take(before.c_str());
}

// Buffers that are taken at once lie in different places, and stay mapped when they are given back.
unsigned int map_blas_buffers(const unsigned int n_threads)
{
  // OpenBLAS exports both, but declares them in none of its headers.
  const auto take = function_of_blas<void *(int)>("blas_memory_alloc");
  const auto give_back = function_of_blas<void(void *)>("blas_memory_free");
  if (take == nullptr || give_back == nullptr || !std::isfinite(free_address_space()))
    return n_threads;
  constexpr double most = 128 << 20; // bytes, of all processors
  std::vector<void *> taken;
  for (unsigned int n = 0; n < n_threads && (n == 0 || free_address_space() >= 2 * most); ++n)
    taken.push_back(take(0));
  for (void *const buffer : taken)
    give_back(buffer);
  return static_cast<unsigned int>(std::max<std::size_t>(1, taken.size()));
}

std::string running_blas()
{
  if (auto *const describe = function_of_blas<const char *()>("openblas_get_config"))
    return describe();
  Dl_info info{};
  const bool is_found = dladdr(dlsym(RTLD_DEFAULT, "dgemm_"), &info) != 0;
  return std::string(is_found ? info.dli_fname : "unknown") +
         " (not OpenBLAS: dense algebra may be ten times slower)";
}
} // namespace orthocone
