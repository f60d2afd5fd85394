// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "inner_compliance.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXf;

namespace
{
/// The `n` nodes whose normal displacement a normal force on `node` changes most, `node` itself first.
std::vector<Index> nearest_nodes(const MatrixXf &compliance, const Index node, const std::size_t n)
{
  std::vector<Index> nodes(compliance.rows() / 3);
  std::iota(nodes.begin(), nodes.end(), 0);
  std::swap(nodes[0], nodes[node]);
  const auto is_nearer = [&](const Index a, const Index b)
  { return compliance(3 * a, 3 * node) > compliance(3 * b, 3 * node); };
  if (nodes.size() > n)
  {
    std::nth_element(nodes.begin() + 1, nodes.begin() + static_cast<std::ptrdiff_t>(n), nodes.end(),
                     is_nearer);
    nodes.resize(n);
  }
  return nodes;
}

/// Forces on `nodes` that move the first of them by one unit in each direction and hold the others.
Eigen::Matrix<float, Eigen::Dynamic, 3> holding_forces(const MatrixXf &compliance,
                                                       const std::vector<Index> &nodes)
{
  const auto n = static_cast<Index>(nodes.size());
  MatrixXf patch(3 * n, 3 * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      patch.block<3, 3>(3 * i, 3 * j) = compliance.block<3, 3>(3 * nodes[i], 3 * nodes[j]);
  return patch.selfadjointView<Eigen::Lower>().ldlt().solve(MatrixXf::Identity(3 * n, 3));
}
} // namespace

InnerCompliance::InnerCompliance(const DenseView &compliance, const double scale)
    : scale_(scale),
      matrix_((compliance / scale).cast<float>()),
      stiffness_(local_stiffness())
{
}

Eigen::SparseMatrix<float, Eigen::RowMajor> InnerCompliance::local_stiffness() const
{
  constexpr std::size_t n_neighbours = 8;
  std::vector<Eigen::Triplet<float>> entries;
  for (Index node = 0; node < matrix_.rows() / 3; ++node)
  {
    const std::vector<Index> nodes = nearest_nodes(matrix_, node, n_neighbours);
    const auto forces = holding_forces(matrix_, nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (Index d = 0; d < 3; ++d)
        for (Index e = 0; e < 3; ++e)
          entries.emplace_back(3 * node + e, 3 * nodes[i] + d, forces(3 * static_cast<Index>(i) + d, e));
  }
  Eigen::SparseMatrix<float, Eigen::RowMajor> stiffness(matrix_.rows(), matrix_.cols());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}
} // namespace orthocone
