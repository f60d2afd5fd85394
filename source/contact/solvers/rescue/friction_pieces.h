// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/natural_map.h>
#include <orthocone/contact/problem/contact_step.h>

#include <vector>

namespace orthocone
{
/// A point in the space of the unknowns of a step (N, mm) and of the share of friction behind them, and what
/// belongs to it.
struct FrictionPoint
{
  Eigen::VectorXd values;         ///< size n_unknowns() + 1
  NodeVector displacement;        ///< d, mm
  std::vector<TrialForce> trials; ///< of the nodes

  double share() const { return values[values.size() - 1]; }
};

/// A border of the piece in which a node has its status.
struct PieceBorder
{
  Eigen::Index node;
  bool is_of_normal; ///< where the node opens or closes; else where it begins or ceases to slip
};

/// The natural map of a step over a share of friction: the circle of the law (friction_law.h) has the radius
/// m N, and m = share (1 + spread (1 - share)) grows from 0, where there is no friction, to 1. The spread is
/// small and differs from node to node, so that as a rule no two nodes change their status at once, not even
/// where a scene is symmetric (the generic position of path following). With statuses given, the map is
/// smooth (docs/theory.md, section 3, "The path of friction"): r = 0 at open nodes, d = 0 at stuck ones, and
/// d_n = 0 and r' = m N y/|y| at slipping ones, with N and y of TrialForce. The maps of two pieces agree at
/// their border.
class FrictionPieces
{
public:
  /// `step` must outlive this object, and its compliance must be dense.
  explicit FrictionPieces(const ContactStep &step);

  const ContactStep &step() const { return step_; }

  /// m of every node.
  Eigen::VectorXd factors(double share) const;

  FrictionPoint at(Eigen::VectorXd values) const;
  std::vector<NodeStatus> statuses(const FrictionPoint &point) const;

  /// The map, N: size n_unknowns().
  Eigen::VectorXd map(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const;

  /// Places of the unknowns that are not held at 0, in order: the forces of the nodes that are not open, the
  /// motions of the face, and the share.
  std::vector<Eigen::Index> active(const std::vector<NodeStatus> &statuses) const;

  /// Derivative of the map's active rows in the active unknowns and the share: k x (k + 1).
  Eigen::MatrixXd slopes(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const;

  /// How far within its piece each node is, N: of the normal borders of all nodes, and of their others
  /// behind. Infinite where there is no such border.
  Eigen::VectorXd margins(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const;

  /// Derivative of a margin in all values.
  Eigen::VectorXd slope_of_margin(const FrictionPoint &point, const std::vector<NodeStatus> &statuses,
                                  const PieceBorder &border) const;

  /// Derivatives of all margins along a direction of the values; 0 where there is no border.
  Eigen::VectorXd rates_of_margins(const FrictionPoint &point, const std::vector<NodeStatus> &statuses,
                                   const Eigen::VectorXd &direction) const;

private:
  /// Derivatives in the force and the displacement of a node, and in the share.
  template<typename Matrix>
  struct Slopes
  {
    Matrix of_force = Matrix::Zero(), of_displacement = Matrix::Zero();
    Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> of_share =
        Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>::Zero();
  };
  using MapSlopes = Slopes<Eigen::Matrix3d>;
  using RowSlopes = Slopes<Eigen::RowVector3d>;

  double factor(Eigen::Index node, double share) const { return share * (1 + spread_[node] * (1 - share)); }
  double slope_of_factor(Eigen::Index node, double share) const
  {
    return 1 + spread_[node] * (1 - 2 * share);
  }
  MapSlopes slipping(const FrictionPoint &point, Eigen::Index node) const;
  MapSlopes slopes_of(const FrictionPoint &point, Eigen::Index node, NodeStatus status) const;
  RowSlopes margin_slopes(const FrictionPoint &point, NodeStatus status, const PieceBorder &border) const;

  const ContactStep &step_;
  Eigen::VectorXd spread_;
};
} // namespace orthocone
