// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_system.h>
#include <orthocone/contact/problem/free_face.h>

namespace orthocone
{
/// Status of a contact node; the numbers are those of the output field `status`.
enum class NodeStatus : int
{
  open = 0,
  stick = 1,
  slip = 2,
};

/// The displacement q of a step: the free gap, and the change of the free slip. `free`: displacements (gap,
/// x, y) relative to the obstacle without forces; `previous`: those at the end of the last step, mm.
NodeVector step_displacement(const NodeVector &free, const NodeVector &previous);

/// What happens at the contact nodes in one load step, a value: the system, and the displacement q = (gap,
/// slip since the last step) that the nodes would have without forces. With forces r (N) the relative
/// displacement is d = q + W r (mm), and r and d obey the law node by node. Where forces drive the held face,
/// its motion y is unknown, too: d = q + face y + W r, and r obeys the balance of the face.
///
/// Unknowns are one vector: three forces a node (N), and behind them y (mm).
class ContactStep
{
public:
  /// `system` must outlive the step.
  ContactStep(const ContactSystem &system, NodeVector q, FreeFace face = {});

  const ContactSystem &system() const { return *system_; }
  Eigen::Index n_nodes() const { return system_->n_nodes(); }
  Eigen::Index n_unknowns() const { return 3 * n_nodes() + face_.n(); }
  const OrthotropicFriction &law(const Eigen::Index node) const { return system_->law(node); }
  const NodeVector &q() const { return q_; }
  const FreeFace &face() const { return face_; }

  /// d, mm.
  NodeVector displacement(const Eigen::VectorXd &unknowns) const;

  /// d as far as it is known without long work, and what the rest of the body lacks of its equilibrium then
  /// (Compliance::near()).
  ContactChange near(const Eigen::VectorXd &unknowns) const;

  /// W and the face times a change of the unknowns, mm.
  NodeVector change_of_displacement(const Eigen::VectorXd &change) const;

  /// Unknowns with forces moved to the nearest ones in the cone, where the law wants them.
  Eigen::VectorXd admissible(Eigen::VectorXd unknowns) const;

  /// Natural map r - project(r - rho G(d)) of all nodes, and what the face lacks of its balance behind it
  /// (N); both vanish at the solution.
  Eigen::VectorXd natural_map(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

  /// Columns of the face times the forces less the balance wanted, N.
  Eigen::VectorXd imbalance(const Eigen::VectorXd &unknowns) const;

  /// Force to which residuals are related: max(||r||, the least force that a solution can have). This is what
  /// closes the free penetration, ||min(q_n, 0)|| / softness, or what the face must carry. Gaps that stay
  /// open and free slides cost no force and do not count.
  double force_scale(const Eigen::VectorXd &unknowns) const;

  /// ||natural map|| / force scale, from the unknowns alone: the measure that every solver stops on; 0 where
  /// no more than rounding of q is left. NaN-safe: unknowns that are not finite give infinity.
  double residual(const Eigen::VectorXd &unknowns) const;
  double residual(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

  /// The same without long work: with d and the rest of near(), which counts as the natural map does.
  double near_residual(const Eigen::VectorXd &unknowns) const;

  /// The same from the natural map at `unknowns`.
  double residual_of(const Eigen::VectorXd &map, const Eigen::VectorXd &unknowns) const;

  /// Status of every node. A node is open if it carries no force, or one that differs from none by rounding
  /// only.
  std::vector<NodeStatus> statuses(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

  /// Whether a node without force has a gap, or none to close: it obeys the law, whatever rounding makes of
  /// its slip.
  static bool is_free(const Eigen::Vector3d &force, const Eigen::Vector3d &displacement)
  {
    return force.isZero(0) && displacement[0] >= 0;
  }

private:
  NodeStatus status(Eigen::Index node, const Eigen::Vector3d &force,
                    const Eigen::Vector3d &displacement) const;
  double negligible_force(const Eigen::VectorXd &unknowns) const;

  const ContactSystem *system_;
  NodeVector q_;
  FreeFace face_;
  double least_force_;
  double rounding_force_; ///< of the natural map, N
};
} // namespace orthocone
