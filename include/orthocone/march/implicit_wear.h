// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/march/contact_state.h>

namespace orthocone
{
/// Up to this ratio of unfound_wear() a step wears explicitly: beyond, contact would flicker from node to
/// node (docs/theory.md, section 3, "Wear").
constexpr double most_explicit_wear = 0.9;

/// The largest depth that a step has worn and the next one will find, relative to what the normal force of
/// the step flattens at the node by itself. `opening` is node_compliance() of all nodes, mm/N.
double unfound_wear(const ContactState &before, const ContactState &after, const Eigen::VectorXd &opening);

/// Weight of the force at the end of a step, beside that at its beginning, in the depth that the step wears.
/// `depth_of_flattening` is that depth relative to the flattening, z >= 0. The force of a node that wears by
/// itself decays as exp(-z), and its mean is theirs with this weight: theta = 1/(1 - exp(-z)) - 1/z, which is
/// 1/2 for little wear and 1 for much (exponential fitting: Liniger, Willoughby, SIAM J. Numer. Anal. 7,
/// 1970, 47).
double weight_of_end(double depth_of_flattening);

/// Finds how deep a step wears whose surface gives way while it is worn. In proportion to the force, depth is
/// one more compliance: h = D (theta r_n + (1 - theta) r_n before), with the depth D that a unit of force
/// wears while the step slips. So the step is solved with W + theta D on the normal diagonal, whatever the
/// length of the slip. docs/theory.md, section 3, "Wear".
class ImplicitWear
{
public:
  /// `opening` is node_compliance() of all nodes, mm/N.
  ImplicitWear(WearLaw law, ContactSolverOptions options, Eigen::VectorXd opening);

  /// Whether the step from `before` to `after` has worn so deep that it is to be solved with its depth.
  bool is_for(const ContactState &before, const ContactState &after) const;

  /// Depths (n, mm) that the step of `problem` wears from the state before it, if its nodes slide as far as
  /// from `before` to `after`. `unknowns` is a start, and then the solution. Empty where W is not known or
  /// the solver does not converge.
  Eigen::VectorXd depths(const ContactStep &problem, const ContactState &before, const ContactState &after,
                         Eigen::VectorXd &unknowns) const;

private:
  Eigen::VectorXd depths_of_a_unit(const ContactStep &problem, const ContactState &before,
                                   const ContactState &after) const;

  WearLaw law_;
  ContactSolverOptions options_;
  Eigen::VectorXd opening_;
};

/// A step with the room that it wears itself: its free gaps are larger by `depths` (n, mm).
ContactStep with_depths(const ContactStep &step, const Eigen::VectorXd &depths);
} // namespace orthocone
