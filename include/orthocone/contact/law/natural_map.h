// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <cmath>

namespace orthocone
{
/// What the law makes of a force r and a displacement d of a node, for a step length rho (N/mm): the law is
/// solved where it gives r back. It asks for the normal force first, N = max(0, r_n - rho d_n), and for
/// friction under this normal force then: r' = P_N(r' - rho g(d_t)), with the nearest point P_N of the circle
/// of radius N (Alart and Curnier, Comput. Methods Appl. Mech. Engrg. 92 (1991) 353-375, in the reduced
/// vectors of the law; docs/theory.md, section 3).
struct TrialForce
{
  TrialForce(const FrictionLaw &law, double rho, const Eigen::Vector3d &r, const Eigen::Vector3d &d)
      : normal(r[0] - rho * d[0]),
        reduced(law.reduced_force(r.tail<2>()) - rho * law.reduced_slip(d.tail<2>())),
        length(std::hypot(reduced[0], reduced[1])),
        can_stick(!law.is_frictionless())
  {
  }

  bool is_open() const { return normal <= 0; }
  bool sticks() const { return !is_open() && length <= normal && can_stick; }

  /// The force in the law's cone, N.
  Eigen::Vector3d admitted(const FrictionLaw &law) const;

  double normal;           ///< N
  Eigen::Vector2d reduced; ///< N
  double length;           ///< of `reduced`
  bool can_stick;          ///< no node does without friction
};

/// The force with its normal part not below 0, and its reduced tangential part drawn back to the circle: the
/// force itself where it is admissible, N.
Eigen::Vector3d admissible_force(const FrictionLaw &law, const Eigen::Vector3d &force);
} // namespace orthocone
