// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// One node on an elastic layer of shear stiffness 1 under pressure 1, and schemes that integrate its slip. t
// is the traction that the layer transmits, top - slip; it stays within the friction ellipse, and the slip
// grows along the normal S t of the slip ellipse, S = diag(1/p_x^2, 1/p_y^2).
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <string>
#include <vector>

namespace orthocone::studies
{
/// One step of a march. `previous_slip` and `slip` are those at the starts of the last step and of this one.
struct LayerStep
{
  Eigen::Vector2d old_top, top;
  Eigen::Vector2d previous_slip, slip;
  bool is_first_of_leg = true;
};

class Layer
{
public:
  explicit Layer(const OrthotropicFriction &law);

  /// The slip at the end of a step; schemes: backward-euler, trapezoidal, midpoint, bdf2, bdf2-guarded,
  /// richardson-local. Throws std::runtime_error for others.
  Eigen::Vector2d advance(const std::string &scheme, const LayerStep &step);

  double norm(const Eigen::Vector2d &t) const { return friction_norm(law_, t[0], t[1]); }

  unsigned int n_solves() const { return n_solves_; }
  unsigned int n_failures() const { return n_failures_; } ///< steps that backward Euler had to do

private:
  /// Backward Euler from `slip`: the normal at the new force.
  Eigen::Vector2d euler(const Eigen::Vector2d &top, const Eigen::Vector2d &slip);
  Eigen::Vector2d trapezoidal(const LayerStep &step);
  Eigen::Vector2d midpoint(const LayerStep &step);
  Eigen::Vector2d richardson(const LayerStep &step);

  /// Solves |t(lambda)| = 1 for t_i = (a_i - lambda b_i)/(1 + lambda c_i) by Newton's method from lambda = 0,
  /// with |a| > 1; false if that fails.
  bool solve(Eigen::Vector2d a, const Eigen::Vector2d &b, const Eigen::Vector2d &c, Eigen::Vector2d &t);

  OrthotropicFriction law_;
  Eigen::Vector2d s_;
  unsigned int n_solves_ = 0, n_failures_ = 0;
};
} // namespace orthocone::studies
