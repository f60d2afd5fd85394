// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/options.h>

namespace orthocone
{
FrictionOptions FrictionOptions::at(const double x, const double y) const
{
  const auto numbers = [&](const std::array<Expression, 2> &pair) {
    return std::array<double, 2>{{pair[0].value(x, y), pair[1].value(x, y)}};
  };
  FrictionOptions there = *this;
  if (varying_mu)
    there.mu = numbers(*varying_mu);
  if (varying_slip_potential)
    there.slip_potential = numbers(*varying_slip_potential);
  if (varying_angle)
    there.angle = varying_angle->value(x, y);
  there.varying_mu = there.varying_slip_potential = std::nullopt;
  there.varying_angle = std::nullopt;
  return there;
}

MaterialOptions MaterialOptions::isotropic() const
{
  MaterialOptions same;
  same.young_modulus = young_modulus;
  same.poisson_ratio = poisson_ratio;
  if (!is_orthotropic())
    return same;
  // Sums of the compliances S_ii, S_ij and 1/G_ij; 1/K is the sum of all S_ij, and
  // 15/G = 4 sum S_ii - 4 sum_{i<j} S_ij + 3 sum 1/G_ij.
  double along = 0, shear = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    along += 1 / young_moduli[i];
    shear += 1 / shear_moduli[i];
  }
  const auto &[nu_xy, nu_xz, nu_yz] = poisson_ratios;
  const double across = -(nu_xy + nu_xz) / young_moduli[0] - nu_yz / young_moduli[1];
  const double bulk_modulus = 1 / (along + 2 * across),
               shear_modulus = 15 / (4 * along - 4 * across + 3 * shear);
  same.young_modulus = 9 * bulk_modulus * shear_modulus / (3 * bulk_modulus + shear_modulus);
  same.poisson_ratio = (3 * bulk_modulus - 2 * shear_modulus) / (2 * (3 * bulk_modulus + shear_modulus));
  return same;
}

bool ObstacleOptions::is_plane() const
{
  const Expression expression(gap);
  return gap_file.empty() && expression.is_constant() && expression.value(0, 0) == 0;
}
} // namespace orthocone
