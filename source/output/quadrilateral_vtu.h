// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace orthocone
{
/// A surface of quadrilaterals that share their points, and fields at the points.
struct QuadrilateralSurface
{
  struct Field
  {
    std::string name;
    Eigen::MatrixXf values; ///< a column for each point, a row for each component
  };

  unsigned int degree = 1; ///< of the elements; degree^2 consecutive quadrilaterals make one
  Eigen::Matrix3Xf points; ///< mm
  std::vector<std::array<std::int32_t, 4>>
      quadrilaterals; ///< points, anticlockwise; a triangle has its first point again
  std::vector<Field> fields;
};

/// VTU text of a surface. It is written here because deal.II gives every cell points of its own.
std::string quadrilateral_vtu(const QuadrilateralSurface &surface);
} // namespace orthocone
