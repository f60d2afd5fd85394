// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_space.h>

#include "half_space_places.h"

#include <algorithm>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

namespace
{
/// The compliance between all places, in global axes; its lower half only.
MatrixXd between_places(const HalfSpace &half_space, const HalfSpacePlaces &places)
{
  MatrixXd matrix = MatrixXd::Zero(3 * places.n(), 3 * places.n());
  for (std::size_t j = 0; j < places.n(); ++j)
    for (std::size_t i = j; i < places.n(); ++i)
      matrix.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(j)) =
          places.displacements(half_space, i, j);
  return matrix;
}

/// Gives directions that symmetry holds any positive compliance, as a body does.
void hold(MatrixXd &matrix, const std::vector<ContactNode> &nodes)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (Index d = 0; d < 3; ++d)
      if (const Index row = 3 * static_cast<Index>(i) + d; !nodes[i].is_free[d])
      {
        matrix.row(row).setZero();
        matrix.col(row).setZero();
        matrix(row, row) = matrix(row + 2 - d, row + 2 - d);
      }
}

/// Turns the lower half into the local axes of the nodes.
void turn(MatrixXd &matrix, const LocalAxes &axes)
{
  const auto n = static_cast<std::size_t>(matrix.rows() / 3);
  std::vector<Matrix3d> turns;
  for (std::size_t i = 0; i < n; ++i)
    turns.push_back(axes.global_in_local(i));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i)
    {
      auto block = matrix.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(j));
      block = (turns[i].transpose() * block * turns[j]).eval();
    }
}
/// Fills the upper half from the lower one, in squares that fit into the cache.
void mirror(MatrixXd &matrix)
{
  constexpr Index side = 96;
  const Index n = matrix.rows();
  for (Index j = 0; j < n; j += side)
    for (Index i = j; i < n; i += side)
    {
      const Index n_i = std::min(side, n - i), n_j = std::min(side, n - j);
      const MatrixXd square = matrix.block(i, j, n_i, n_j);
      if (i > j)
        matrix.block(j, i, n_j, n_i) = square.transpose();
      else
        matrix.block(j, i, n_j, n_i) = square.selfadjointView<Eigen::Lower>();
    }
}
} // namespace

MatrixXd half_space_compliance(const HalfSpace &half_space, const ContactSurface &surface,
                               const ModelSymmetry &symmetry, const LocalAxes &axes)
{
  if (symmetry.is_section())
    throw std::logic_error("a half-space has no compliance of rings or strips");
  const HalfSpacePlaces places(surface, symmetry, half_space.n_points);
  MatrixXd matrix = between_places(half_space, places);
  if (!surface.hanging.empty())
  {
    const Eigen::SparseMatrix<double> division = places.division(surface);
    matrix = division.transpose() * (matrix.selfadjointView<Eigen::Lower>() * MatrixXd(division));
  }
  hold(matrix, surface.nodes);
  turn(matrix, axes);
  mirror(matrix);
  return matrix;
}
} // namespace orthocone
