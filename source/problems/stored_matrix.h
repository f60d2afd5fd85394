// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "hdf5_file.h"

#include <Eigen/Sparse>

namespace orthocone
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Reads an m x n matrix of FCLIB, in any of its kinds. Its sizes are known already, so that no damaged size
/// demands memory. Throws FileError.
SparseMatrix read_matrix(const Hdf5File &file, const std::string &path, Eigen::Index m, Eigen::Index n);

/// Reads a vector of n numbers. Throws FileError.
Eigen::VectorXd read_vector(const Hdf5File &file, const std::string &path, Eigen::Index n);
} // namespace orthocone
