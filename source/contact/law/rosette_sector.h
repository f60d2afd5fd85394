// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Core>

namespace orthocone
{
/// Two unit vectors e_0 and e_1 that enclose the vectors x e_0 + y e_1 with x > 0 and y >= 0.
struct Corner
{
  Corner(double first_angle, double angle_between);

  /// (x, y). What lies on the border by rounding is taken as inside.
  Eigen::Vector2d coordinates(const Eigen::Vector2d &v) const;

  Eigen::Vector2d first, second;
  double angle, sine;   ///< between them
  Eigen::Matrix2d dual; ///< its rows' products with a vector are (x, y)
};

/// A measured law between two neighbouring rows, of which the first one has the smaller angles. Directions
/// are ratios of coordinates: p = y/x of a direction of slip e(a) in the slip directions of the rows, q of
/// the force in their forces.
///
/// Turning: q = a b p (a + b p)/(b + a p), a = alpha and b = beta, is monotone for all positive alpha and
/// beta, is the same seen from the other row, and has an inverse in closed form. dq/dp is alpha^2 at the
/// first row and goes to beta^2 at the other one. With alpha = beta it is q = alpha^2 p, as for two ellipses.
///
/// Size: the gauge G(r), homogeneous of degree one, is 1 where a force slips under the normal force 1:
/// G^2 = g_0 x^2 + 2 m x y + g_1 y^2, which is that of an ellipse if m is constant. m goes from m_0 to m_1,
/// and with `tension` it leans to sqrt(g_0 g_1), the straight line between the forces of the rows.
struct RosetteSector
{
  Corner slips, forces; ///< e(a) and e(b)
  double alpha, beta;
  double g_0, g_1, m_0, m_1;
  double tension;

  double force_ratio(double p) const; ///< q
  double slip_ratio(double q) const;  ///< p, the inverse
  double ratio_slope(double p) const; ///< dq/dp
  /// (d^2 q/dp^2)/(dq/dp).
  double relative_curvature(double p) const;

  double square_of_gauge(const Eigen::Vector2d &coordinates) const;
  /// Half the derivative of G^2 by the two coordinates.
  Eigen::Vector2d half_gradient(const Eigen::Vector2d &coordinates) const;

  /// What has to be positive at the direction p for the law to be well posed (Rosette).
  struct Conditions
  {
    double along, kappa, turning;
  };
  Conditions conditions(double p) const;
};
} // namespace orthocone
