// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Threads, and the BLAS that most of them compute with.
#pragma once

#include <orthocone/base/machine.h>

#include <optional>
#include <string>

namespace orthocone
{
/// The number of threads that a run computes with, and the reason in words.
struct ThreadChoice
{
  unsigned int number = 1;
  std::string reason{};
};

/// One thread for each core that nobody else keeps busy: threads of BLAS wait for each other, so that threads
/// that share a core make a factorization several times as long. One thread where the model is so small that
/// a second one gains nothing (docs/performance.md, "Threads"). `unknowns` is their number in the model,
/// `n_busy` the number of allowed cores that others keep busy, on average.
ThreadChoice choose_threads(double unknowns, const UsableCores &cores, double n_busy);

/// Whether choose_threads() depends on its `n_busy`.
bool depends_on_load(double unknowns, const UsableCores &cores);

/// The number of threads that OpenBLAS computes with: the number of cores, or what the environment says,
/// until set_blas_threads() changes it. One with another BLAS.
unsigned int blas_threads();

/// The number that a variable of the environment gives, such as OPENBLAS_NUM_THREADS, if there is one.
std::optional<ThreadChoice> threads_of_environment();

/// Makes OpenBLAS compute with so many threads from now on; does nothing with another BLAS. With one, loops
/// of OpenMP that this thread begins have one, too.
void set_blas_threads(unsigned int number);

/// The number of threads for a product with a matrix of `n` rows: that of OpenBLAS, or one where the matrix
/// is small.
unsigned int product_threads(long n);

/// While this object lives, OpenBLAS runs on one thread if the matrices of the work are small: their products
/// take microseconds, and a second thread that waits for them takes a core from the writers of files and from
/// other programs.
class BlasThreads
{
public:
  /// `n`: rows of the compliance.
  explicit BlasThreads(long n);
  ~BlasThreads();
  BlasThreads(const BlasThreads &) = delete;
  BlasThreads &operator=(const BlasThreads &) = delete;

private:
  unsigned int n_before_ = 0; ///< 0 if nothing was changed
};

/// OpenBLAS before 0.3.25 computes with the SSE3 kernels of `Prescott` on Intel processors that are newer
/// than itself (its issue 4267), and with those of AVX2 on AMD's with AVX-512. They are replaced by those of
/// `SkylakeX` (AVX-512) or `Haswell` (AVX2) if these multiply two matrices exactly: a factorization takes
/// half of the time (docs/performance.md, "Threads"). Does nothing where OPENBLAS_CORETYPE is set, or with
/// another BLAS. Must be called before any other thread uses BLAS.
void use_kernels_of_this_processor();

/// Maps the buffers with which so many threads of OpenBLAS compute at once, as far as the limit of the
/// address space leaves room for them, and returns their number, at least 1. Without a limit, or with another
/// BLAS, it maps nothing, and returns `n_threads`. OpenBLAS maps a buffer (128 MB on x86-64) when a thread
/// first needs one, keeps it for all threads, and where there is no room tries again for ever
/// (blas_memory_alloc).
unsigned int map_blas_buffers(unsigned int n_threads);

/// The description that the running BLAS gives of itself, or the file that it comes from.
std::string running_blas();
} // namespace orthocone
