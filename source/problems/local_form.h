// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "hdf5_file.h"

namespace orthocone
{
/// FCLIB's local form of a problem with 3 n rows and m equality constraints: u = W r + V l + q, with
/// V^T r + R l + s = 0.
struct LocalForm
{
  Eigen::MatrixXd w; ///< 3 n x 3 n
  Eigen::VectorXd q; ///< 3 n
  Eigen::MatrixXd v; ///< 3 n x m
  Eigen::MatrixXd r; ///< m x m
  Eigen::VectorXd s; ///< m

  bool has_constraints() const { return s.size() > 0; }
};

/// The group of a file's problem, local or global. Throws FileError where there is none, and where it is not
/// in three dimensions.
std::string problem_group(const Hdf5File &file);

/// The number of rows, 3 n. Throws FileError where it is none of nodes.
Eigen::Index number_of_rows(const Hdf5File &file);

/// Reads a local problem, or reduces a global one: M v = H r + G l + f, u = H^T v + w and G^T v + b = 0
/// become W = H^T M^-1 H, V = H^T M^-1 G, R = G^T M^-1 G, q = w + H^T M^-1 f and s = b + G^T M^-1 f, by a
/// sparse Cholesky factorization of M. Throws FileError, also where M is not symmetric and positive definite.
LocalForm read_local_form(const Hdf5File &file);
} // namespace orthocone
