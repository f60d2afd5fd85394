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
  same.young_modulus =
      is_orthotropic() ? std::cbrt(young_moduli[0] * young_moduli[1] * young_moduli[2]) : young_modulus;
  same.poisson_ratio = is_orthotropic() ? 0.3 : poisson_ratio; // its effect on an estimate is small
  return same;
}

bool ObstacleOptions::is_plane() const
{
  const Expression expression(gap);
  return gap_file.empty() && expression.is_constant() && expression.value(0, 0) == 0;
}
} // namespace orthocone
