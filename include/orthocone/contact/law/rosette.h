// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <vector>

namespace orthocone
{
struct RosetteTable;

/// Friction as a tribometer measures it, in any direction: f(a) = mu_along(a) e(a) + mu_across(a) e'(a) is
/// the force per unit normal force against slip along -e(a), with e' = e turned by 90 degrees to the left
/// (docs/theory.md, section 1, "The circle"). Between two rows of the table directions and sizes are those
/// that two ellipses have, with coefficients that go from one row to the other, so that tables of ellipses
/// give these ellipses, and the derivative of f is continuous.
///
/// With b the angle of f(a) and R(b) = |f(a)| the maps are r' = r_t / R(b) and g = -|d_t|/M b'(a)^(-1/2)
/// e(b(a)), where M is the geometric mean of R.
class Rosette : public TangentMaps
{
public:
  struct Row
  {
    double angle;         ///< of e(a), radians
    double along, across; ///< coefficients of friction
  };

  static constexpr std::size_t least_rows = 8;
  static constexpr double same_angle = 1e-9; ///< rows that are no farther apart are the same, radians

  /// Rows in any order. Throws std::invalid_argument, whose message says what is allowed, for fewer rows than
  /// that, angles that are the same or leave more than 90 degrees between them, and where one of the three
  /// conditions fails somewhere, also between the rows: mu_along > 0; kappa = mu_along + d mu_across/da > 0,
  /// so that a push on a node on equal springs has one slip; and b' > 0, so that a force has one slip
  /// direction. They hold between two rows where b grows from one to the other, each force is within 90
  /// degrees of both directions e, and the straight line from force to force goes along both e'; else they
  /// may fail, although a finer table would keep them.
  explicit Rosette(std::vector<Row> rows);
  ~Rosette() override;
  Rosette(const Rosette &) = delete;
  Rosette &operator=(const Rosette &) = delete;

  /// Those of the rows, ascending from 0 to 2 pi.
  std::vector<double> angles() const;
  /// The coefficients at any angle.
  Row row(double angle) const;

  Eigen::Vector2d reduced_force(const Eigen::Vector2d &force) const override;
  Eigen::Matrix2d reduced_force_derivative(const Eigen::Vector2d &force) const override;
  Eigen::Vector2d force(const Eigen::Vector2d &reduced) const override;
  Eigen::Vector2d reduced_slip(const Eigen::Vector2d &slip) const override;
  Eigen::Matrix2d reduced_slip_derivative(const Eigen::Vector2d &slip) const override;
  Eigen::Vector2d slip(const Eigen::Vector2d &reduced) const override;

private:
  std::unique_ptr<const RosetteTable> table_;
  double mean_ = 1;
};
} // namespace orthocone
