// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_system.h>
#include <orthocone/contact/problem/free_face.h>

#include <memory>

namespace orthocone
{
/// Status of a contact node; the numbers are those of the output field `status`.
enum class NodeStatus : int
{
  open = 0,
  stick = 1,
  slip = 2,
};

/// The displacement q of a step (mm): the free gap, and the change of the free slip. `free` are the
/// displacements (gap, x, y) relative to the obstacle without forces, `previous` those at the end of the last
/// step; each has three numbers a node, mm.
NodeVector step_displacement(const NodeVector &free, const NodeVector &previous);

/// The contact problem of one load step, a value: the system, and the displacement q = (gap, slip since the
/// last step) that the nodes would have without forces (docs/theory.md, section 3). With forces r (N) the
/// relative displacement is d = q + W r (mm), and r and d obey the law at every node. Where forces drive the
/// held face, its motion y is unknown, too: d = q + C y + W r with the columns C of the face, and r obeys the
/// balance of the face.
///
/// The unknowns are one vector of size n_unknowns() = 3 n + m: three forces a node (N), and behind them y
/// (mm). Vectors of displacements have size 3 n. Sizes are asserted, not checked. It throws only what the
/// compliance throws.
class ContactStep
{
public:
  /// `system` must outlive the step; `q` has size 3 n, mm. The laws are those of the system.
  ContactStep(const ContactSystem &system, NodeVector q, FreeFace face = {});

  /// The same step with other laws, one a node: friction may change from step to step, with wear or heat.
  ContactStep with_laws(FrictionLaws laws) const;

  /// The same step with the law of each node scaled by its factor (> 0), or as it is without factors.
  ContactStep with_factors(const Eigen::VectorXd &factors) const;

  const ContactSystem &system() const { return *system_; }
  Eigen::Index n_nodes() const { return system_->n_nodes(); }
  Eigen::Index n_unknowns() const { return 3 * n_nodes() + face_.n(); }
  const FrictionLaws &laws() const { return own_laws_ ? *own_laws_ : system_->laws(); }
  const FrictionLaw &law(const Eigen::Index node) const { return laws()[node]; }
  const NodeVector &q() const { return q_; }
  const FreeFace &face() const { return face_; }

  /// d, mm, size 3 n.
  NodeVector displacement(const Eigen::VectorXd &unknowns) const;

  /// d (mm) as far as it is known without long work, and what the rest of the body lacks of its equilibrium
  /// then (N): Compliance::approximate().
  ContactChange approximate(const Eigen::VectorXd &unknowns) const;

  /// W and C times a change of the unknowns: the change of d, mm.
  NodeVector change_of_displacement(const Eigen::VectorXd &change) const;

  /// The unknowns with every force moved into its cone: admissible_force().
  Eigen::VectorXd admissible(Eigen::VectorXd unknowns) const;

  /// Natural map r - TrialForce(r, d).admitted() of all nodes, and behind it what the face lacks of its
  /// balance: size n_unknowns(), N. Both vanish at the solution and only there.
  Eigen::VectorXd natural_map(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

  /// C^T r - S y less the balance wanted: size m, N.
  Eigen::VectorXd imbalance(const Eigen::VectorXd &unknowns) const;

  /// Force (N) to which residuals are related: max(||r||, the least force that a solution can have). This
  /// least force closes the free penetration, ||min(q_n, 0)|| / softness, or is what the face must carry.
  /// Gaps that stay open and free slides cost no force and do not count.
  double force_scale(const Eigen::VectorXd &unknowns) const;

  /// ||natural map|| / force_scale(), from the unknowns alone: the measure that every solver stops on
  /// (docs/theory.md, section 3). It is 0 where no more than rounding of q is left, and infinite for unknowns
  /// that are not finite.
  double residual(const Eigen::VectorXd &unknowns) const;
  double residual(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

  /// The same without long work: with the d of approximate(), and with its rest as one more entry of the
  /// natural map.
  double approximate_residual(const Eigen::VectorXd &unknowns) const;

  /// The same from the natural map at `unknowns`.
  double residual_of(const Eigen::VectorXd &map, const Eigen::VectorXd &unknowns) const;

  /// Status of each of the n nodes. A node is open if it carries no force, or one that differs from none by
  /// rounding only.
  std::vector<NodeStatus> statuses(const Eigen::VectorXd &unknowns, const NodeVector &displacement) const;

private:
  double negligible_force(const Eigen::VectorXd &unknowns) const;

  const ContactSystem *system_;
  std::shared_ptr<const FrictionLaws> own_laws_; ///< or none
  NodeVector q_;
  FreeFace face_;
  double least_force_;
  double rounding_force_; ///< of the natural map, N
};
} // namespace orthocone
