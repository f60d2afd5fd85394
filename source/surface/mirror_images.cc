// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mirror_images.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;

namespace
{
constexpr double largest_bearable = 1e-3;

[[noreturn]] void refuse_difference(const Index i, const Index j, const double difference)
{
  std::ostringstream message;
  message.precision(3);
  message << "W is not symmetric: mirror images of nodes " << std::min(i, j) / 3 << " and "
          << std::max(i, j) / 3 << " differ by " << difference
          << " of the largest entries of their nodes; allowed is " << largest_bearable
          << ". Compute W in double precision, or give (W + W^T)/2 if that is what you mean";
  throw std::invalid_argument(message.str());
}
} // namespace

NodeVector block_scale(const DenseView &w)
{
  constexpr double least_share = 1e-10;
  const double least = least_share * w.diagonal().maxCoeff();
  NodeVector scale(w.rows());
  for (Index i = 0; i < w.rows(); i += 3)
    scale.segment<3>(i).setConstant(1 / std::sqrt(std::max(least, w.diagonal().segment<3>(i).maxCoeff())));
  return scale;
}

MirrorDifference mirror_difference(const DenseView &w)
{
  constexpr double nothing = 1e-8; // what files in decimal form and other programs leave
  if (!(w.diagonal().maxCoeff() > 0))
    return {};
  const NodeVector scale = block_scale(w);
  MirrorDifference found;
  double sum = 0;
  Index row = 0, column = 0;
  for (Index j = 0; j < w.cols(); ++j)
    for (Index i = 0; i < j; ++i)
    {
      const double difference = std::abs(w(i, j) - w(j, i)) * scale[i] * scale[j];
      sum += difference * difference;
      if (difference > found.largest)
      {
        found.largest = difference;
        row = i;
        column = j;
      }
    }
  if (found.largest > largest_bearable)
    refuse_difference(row, column, found.largest);
  if (found.largest <= nothing)
    return {};
  found.norm = std::sqrt(sum / 2);
  return found;
}

Eigen::MatrixXd symmetric_part(const DenseView &w)
{
  return (w + w.transpose()) / 2;
}
} // namespace orthocone
