// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "linearization.h"

#include <utility>

namespace orthocone
{
/// linearize() or linearize_on_elliptic_cone().
using Map = Linearization(const ContactStep &, const Eigen::VectorXd &, const NodeVector &, double);

/// Unknowns, the displacement and the body that belong to them, and a map that is linearized there.
struct Iterate
{
  Iterate(Map *map, const ContactStep &step, Eigen::VectorXd unknowns_, NodeVector displacement_,
          BodyPart body_, double rho_factor);

  Eigen::VectorXd unknowns;
  NodeVector displacement;
  BodyPart body; ///< empty with a dense compliance
  Linearization linearization;
  double body_residual; ///< norm of what the body lacks of its equilibrium, N; 0 with a dense compliance
  double error;         ///< of the law and of the body's equilibrium together, N
};

/// How far a step goes along Newton's change.
struct LineSearch
{
  /// What is taken where no length is low enough, because pieces of the map meet there, or because its error
  /// has a minimum beside the solution.
  enum class Fallback
  {
    shortest,    ///< it passes the corner at least
    least_error, ///< if that is little worse than the last error, and the full step otherwise
  };

  double bound;                     ///< that the error must stay below, N
  double shortest_length = 1. / 64; ///< shares of the change: 1, 1/2, ... down to this one
  Fallback fallback = Fallback::shortest;
  /// How often the full step may still be taken where half of it is too long, too, and where it raises the
  /// error no more than tenfold; it is counted down. Null: never.
  unsigned int *leaps = nullptr;
};

/// The steps of Newton's method on one map, of which all variants of the method are made: with W, and with
/// the whole body in place of W. With the generalized Jacobian J of the map F (docs/theory.md, section 3),
/// J change = -F, and a line search on ||F|| (Qi and Sun, Math. Programming 58 (1993) 353).
class NewtonSteps
{
public:
  /// `conditions` must outlive the steps.
  NewtonSteps(Map *const map, const ConditionSolver &conditions, const double rho_factor)
      : map_(map),
        conditions_(conditions),
        rho_factor_(rho_factor)
  {
  }

  /// The iterate of these unknowns, with the displacement W r that they cause.
  Iterate at(const ContactStep &step, const Eigen::VectorXd &unknowns) const;

  /// The same with ContactStep::approximate().
  Iterate approximately_at(const ContactStep &step, const Eigen::VectorXd &unknowns) const;

  /// Newton's change with its displacement, up to a relative error `accuracy` or the best that can be
  /// reached. Not finite if the linearization is singular.
  ContactChange change(const ContactStep &step, const Iterate &from, double accuracy) const;

  /// The iterate behind a share `length` of a change. Since W is linear, it costs no product with it.
  Iterate behind(const ContactStep &step, const Iterate &from, const ContactChange &change,
                 double length) const;

  /// The first iterate along a change whose error is low enough, or the search's fallback.
  Iterate search(const ContactStep &step, const Iterate &from, const ContactChange &change,
                 const LineSearch &line_search) const;

  double rho_factor() const { return rho_factor_; }

private:
  Map *map_;
  const ConditionSolver &conditions_;
  double rho_factor_;
};
} // namespace orthocone
