// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material.h>

#include <Eigen/Dense>

#include <array>

namespace orthocone
{
ElasticTangent orthotropic_tangent(const MaterialOptions &options)
{
  constexpr std::array<std::array<unsigned int, 2>, 3> planes{{{{0, 1}}, {{0, 2}}, {{1, 2}}}}; // xy, xz, yz
  Eigen::Matrix3d compliance;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto [a, b] = planes[i];
    compliance(i, i) = 1 / options.young_moduli[i];
    compliance(a, b) = compliance(b, a) = -options.poisson_ratios[i] / options.young_moduli[a];
  }
  const Eigen::Matrix3d normal = compliance.inverse();
  ElasticTangent tangent;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto [a, b] = planes[i];
    tangent[a][b][a][b] = options.shear_moduli[i]; // stress = 2 G strain, half of it for each of xy and yx
    for (unsigned int j = 0; j < 3; ++j)
      tangent[i][i][j][j] = (normal(i, j) + normal(j, i)) / 2;
  }
  return tangent;
}
} // namespace orthocone
