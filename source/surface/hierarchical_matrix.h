// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace orthocone
{
/// A symmetric matrix (3 n x 3 n) of 3 x 3 blocks that belong to pairs of n points of a plane and get
/// smoother with their distance, such as W of a half-space: in a tree of clusters of points, the blocks of
/// clusters that are far apart are products of thin matrices (Hackbusch, Hierarchical Matrices, 2015;
/// adaptive cross approximation, Bebendorf and Rjasanow, Computing 70 (2003) 1-24, by the library hmat-oss).
/// Numbers and work grow with n log n.
class HierarchicalMatrix
{
public:
  /// The block of two points, the transposed one of which belongs to the points exchanged.
  using Block = std::function<Eigen::Matrix3d(std::size_t, std::size_t)>;

  /// How the approximation of a block chooses its rows and columns. With pivots among all entries each entry
  /// is asked for once. With pivots of some rows and columns few entries are, but what they are not coupled
  /// with may be missed: for Poisson's ratio 0.5, normal and tangential directions; for 0, both tangential
  /// ones.
  enum class Pivots
  {
    of_all_entries,
    of_some_rows
  };

  /// `accuracy`: relative error of the blocks that are approximated. Throws std::runtime_error where the
  /// library fails.
  HierarchicalMatrix(const std::vector<Eigen::Vector2d> &points, const Block &block, double accuracy,
                     Pivots pivots = Pivots::of_all_entries);
  ~HierarchicalMatrix();
  HierarchicalMatrix(HierarchicalMatrix &&) noexcept;

  /// result = matrix * vector, both of size 3 n. Only one thread at a time may call it.
  void vmult(Eigen::VectorXd &result, const Eigen::VectorXd &vector) const;

  /// The numbers that are stored.
  std::size_t n_numbers() const;

private:
  class Matrix;
  std::unique_ptr<Matrix> matrix_;
};
} // namespace orthocone
