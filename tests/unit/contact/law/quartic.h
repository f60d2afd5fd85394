// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The paper's quartic for the multiplier lambda of the projection onto the cone, which the program does not
// use.
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace orthocone::test
{
/// Coefficients of 1, lambda, ..., lambda^4.
using Quartic = Eigen::Matrix<double, 5, 1>;
using QuarticRoots = std::array<std::complex<double>, 4>;

/// tau_x^2 x (y + l)^2 (1 - l)^2 + tau_y^2 y (x + l)^2 (1 - l)^2 - tau_n^2 (x + l)^2 (y + l)^2 with x =
/// mu_x^2, y = mu_y^2.
inline Quartic multiplier_quartic(const OrthotropicFriction &law, const Eigen::Vector3d &tau)
{
  const auto square_times_square =
      [](const double a, const double sign_a, const double b, const double sign_b)
  {
    const Eigen::Vector3d p(a * a, 2 * a * sign_a, 1);
    const Eigen::Vector3d q(b * b, 2 * b * sign_b, 1);
    Quartic product = Quartic::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        product[i + j] += p[i] * q[j];
    return product;
  };
  const double x = law.mu_x * law.mu_x;
  const double y = law.mu_y * law.mu_y;
  return tau[1] * tau[1] * x * square_times_square(y, 1, 1, -1) +
         tau[2] * tau[2] * y * square_times_square(x, 1, 1, -1) -
         tau[0] * tau[0] * square_times_square(x, 1, y, 1);
}

/// Roots as eigenvalues of the companion matrix.
inline QuarticRoots companion_roots(const Quartic &quartic)
{
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) = -quartic.head<4>() / quartic[4];
  if (!companion.allFinite())
    return {};
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(companion, false);
  const auto &roots = solver.eigenvalues();
  return {{roots[0], roots[1], roots[2], roots[3]}};
}

/// The root that is the multiplier of a point outside of the cone and its polar, or NaN: real, positive, and
/// on the side of 1 that the sign of tau_n gives. Roots that rounding has split into a complex pair count as
/// real; of several, the one that fulfils the equation before squaring best.
inline double wanted_root(const OrthotropicFriction &law, const Eigen::Vector3d &tau,
                          const QuarticRoots &roots)
{
  double wanted = std::numeric_limits<double>::quiet_NaN();
  double least = std::numeric_limits<double>::infinity();
  for (const std::complex<double> &root : roots)
  {
    const double lambda = root.real();
    if (!(lambda > 0 && (1 - lambda) * tau[0] >= 0 && std::abs(root.imag()) < 1e-3 * std::abs(lambda)))
      continue;
    const double norm = friction_norm(law, tau[1] / (1 + lambda / (law.mu_x * law.mu_x)),
                                      tau[2] / (1 + lambda / (law.mu_y * law.mu_y)));
    const double error = std::abs(norm * (1 - lambda) - tau[0]);
    if (error < least)
    {
      least = error;
      wanted = lambda;
    }
  }
  return wanted;
}
} // namespace orthocone::test
