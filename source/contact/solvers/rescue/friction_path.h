// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "friction_pieces.h"

#include <orthocone/contact/solvers/contact_solver.h>

#include <functional>
#include <optional>

namespace orthocone
{
/// The path of solutions of a step over the share of friction, from where there is hardly any
/// (FrictionPieces). It may turn back: behind such a fold there are several solutions for shares that it
/// passes again, and every method that lets friction only grow must fail at it. So the path is followed by
/// its own length (arc length continuation: Allgower and Georg, Numerical Continuation Methods, 1990): along
/// its tangent to the next border of a piece, and back to the path by Newton's method on the map and the
/// border's equation.
class FrictionPath
{
public:
  /// Starts at the solution of the step for factors() of the share of friction that `unknowns` belong to.
  FrictionPath(const ContactStep &step, const Eigen::VectorXd &unknowns, double share);

  /// Goes on until all friction is there, or it has factorized so often or with so many operations, or it
  /// cannot go on. Returns whether all friction is there.
  bool follow(unsigned int most_factorizations, double most_operations);

  Eigen::VectorXd unknowns() const { return point_.values.head(pieces_.step().n_unknowns()); }
  const Folds &folds() const { return folds_; }
  unsigned int n_factorizations() const { return n_factorizations_; }

private:
  /// An equation that fixes the place on the path: its value and its derivative in all values.
  struct Equation
  {
    double value;
    Eigen::VectorXd slope;
  };
  using Condition = std::function<Equation(const FrictionPoint &)>;

  /// The map's slopes above a row that fixes the place, factorized.
  struct Bordered
  {
    std::vector<Eigen::Index> places; ///< of the unknowns
    Eigen::PartialPivLU<Eigen::MatrixXd> factor;

    Eigen::VectorXd solve(const Eigen::VectorXd &map, double last, Eigen::Index size) const;
  };

  /// What the next step aims at.
  struct Aim
  {
    double length;                        ///< along the tangent
    std::optional<Eigen::Index> margin{}; ///< the one that is to vanish
    bool is_end = false;                  ///< all friction
  };

  bool advance();
  void orient();
  Aim first_aim(const Eigen::VectorXd &margins) const;
  std::optional<Aim> better_aim(const Aim &aim, const Eigen::VectorXd &margins,
                                const std::optional<FrictionPoint> &next) const;
  Condition condition_of(const Aim &aim) const;
  std::optional<FrictionPoint> corrected(Eigen::VectorXd values, const Condition &condition);
  std::optional<FrictionPoint> by_last_factor(Eigen::VectorXd values, const Condition &condition) const;
  std::optional<FrictionPoint> by_newton(Eigen::VectorXd values, const Condition &condition);
  Bordered factorized(const FrictionPoint &point, const Eigen::VectorXd &row);
  PieceBorder border(Eigen::Index margin) const;
  void cross(Eigen::Index margin);
  double error(const Eigen::VectorXd &map, const Equation &equation) const;
  double norm(const Eigen::VectorXd &direction) const;
  Eigen::VectorXd weighted(const Eigen::VectorXd &direction) const;

  FrictionPieces pieces_;
  FrictionPoint point_;
  std::vector<NodeStatus> statuses_;
  double force_;                       ///< that forces are measured by, N
  Eigen::VectorXd tangent_;            ///< of norm 1
  std::optional<Bordered> bordered_{}; ///< at the point
  int orientation_ = 0;                ///< sign of the determinant along the path
  double longest_;                     ///< step
  double share_before_ = 0;            ///< where the last step began
  bool is_at_end_ = false;
  Folds folds_{};
  unsigned int n_factorizations_ = 0;
  double operations_ = 0;
};
} // namespace orthocone
