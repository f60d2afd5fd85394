// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The contact to be expected before anything is computed.
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// Contact of two half-spaces whose gap has the curvature of the scene's (Hertz).
struct ExpectedContact
{
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();      ///< where the gap is smallest, mm
  Eigen::Vector2d first_axis = Eigen::Vector2d::UnitX(); ///< unit vector along which the gap is curved most
  std::array<double, 2> radii{};       ///< of the gap along and across that axis, mm; infinite along a line
  std::array<double, 2> half_widths{}; ///< likewise, mm; that of the base along a line
  double force = 0;                    ///< N
  double pressure = 0;                 ///< the largest, MPa

  bool is_line() const { return half_widths[1] != 0 && !(radii[1] < 1e300); }

  /// Whether a place (mm) lies in it.
  bool contains(const Eigen::Vector2d &place) const;
};

/// What the smallest gap, its curvature there and the largest force or motion along z let expect; nothing
/// where the gap is flat, the contact would reach the rim, or the shape or the loads do not tell.
std::optional<ExpectedContact> expected_contact(const Parameters &parameters);

/// How many nodes lie across the narrower side of the contact, about.
double nodes_across(const ExpectedContact &contact, const ContactSurface &surface,
                    const ModelSymmetry &symmetry);

/// "radius 0.54 mm, pressure 411 MPa (Hertz, 250 N on radius 100 mm)".
std::string describe(const ExpectedContact &contact);
} // namespace orthocone
