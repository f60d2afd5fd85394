// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Core>

namespace orthocone
{
/// While this lives, OpenBLAS runs on one thread if the matrices that the work is done with are small: their
/// products take microseconds, and a second thread that waits for them takes a core from those who write
/// files and from other programs. Does nothing with another BLAS.
class BlasThreads
{
public:
  /// `n`: rows of the compliance.
  explicit BlasThreads(Eigen::Index n);
  ~BlasThreads();
  BlasThreads(const BlasThreads &) = delete;
  BlasThreads &operator=(const BlasThreads &) = delete;

private:
  int n_before_ = 0; ///< 0 if nothing was changed
};
} // namespace orthocone
