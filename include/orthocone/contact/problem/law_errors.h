// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// How far a solution is from the contact law as the paper states it (section 2), in the law's own terms:
/// without the projection, the natural map or anything else that solvers use (docs/theory.md, section 5).
/// These are largest values over the nodes, without units: relative to the largest force, and to the largest
/// displacement that forces cause or prevent. So gaps that stay open and free slides do not count, except in
/// the slip rule, which is about directions of slip. NaN where forces are no numbers.
struct LawErrors
{
  double penetration = 0;     ///< -gap
  double complementarity = 0; ///< smaller of gap and normal force, in magnitude: one must vanish
  double friction_cone = 0;   ///< |r'| - r_n
  double slip_rule = 0;       ///< slip against the slip rule or inside the cone, weighted with friction

  /// Takes the larger value of each error; NaN wins.
  void merge(const LawErrors &other);
};

/// Errors of `unknowns` (ContactStep), with the displacement that they cause (3 n, mm), as the solution of
/// `step`. Throws only what the compliance throws.
LawErrors law_errors(const ContactStep &step, const Eigen::VectorXd &unknowns,
                     const NodeVector &displacement);
} // namespace orthocone
