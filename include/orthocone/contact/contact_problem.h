// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/compliance/compliance.h>
#include <orthocone/contact/friction_law.h>

#include <vector>

namespace orthocone
{
/// Status of a contact node; the numbers are those of the output field `status`.
enum class NodeStatus : int
{
  open = 0,
  stick = 1,
  slip = 2,
};

/// What happens at the contact nodes in one load step: the compliance W, the friction law of each node and
/// the displacement q = (gap, slip since the last step) that the nodes would have without forces. With forces
/// r (N) the relative displacement is d = q + W r (mm), and r and d obey the law node by node.
class ContactProblem
{
public:
  /// `compliance` must outlive the problem; `laws` holds one entry a node.
  ContactProblem(const Compliance &compliance, std::vector<OrthotropicFriction> laws);

  /// Sets the next step by the displacements (gap, x, y) relative to the plane without forces, `free`, and at
  /// the end of the last step, `previous`, in mm: q is the free gap and the change of the free slip.
  void set_step(const NodeVector &free, const NodeVector &previous);

  Eigen::Index n_nodes() const { return compliance_.n_nodes(); }
  const Compliance &compliance() const { return compliance_; }

  /// The law as given, and the same law with p scaled for the natural map.
  const OrthotropicFriction &given_law(Eigen::Index node) const { return given_laws_[node]; }
  const OrthotropicFriction &law(Eigen::Index node) const { return laws_[node]; }

  const NodeVector &free_displacement() const { return free_; }

  /// Step of the natural map of a node, 1 / max(diagonal of its block of W).
  double rho(Eigen::Index node) const { return rho_[node]; }

  /// Largest eigenvalue of W (estimated from below by power iterations to about 1 %).
  double largest_compliance() const { return largest_compliance_; }

  /// Residual below which rounding of the displacement decides: the machine's precision times the largest
  /// product of a node's rho and the largest eigenvalue of W.
  double rounding() const;

  /// d = q + W r.
  NodeVector displacement(const NodeVector &force) const;

  /// Forces moved to the nearest ones in the cone, where the law wants them.
  NodeVector admissible(NodeVector force) const;

  /// Natural map r - project(r - rho G(d)) of all nodes; it vanishes at the solution.
  NodeVector natural_map(const NodeVector &force, const NodeVector &displacement) const;

  /// Force to which residuals are related: max(||r||, ||q|| / largest compliance), the latter being the least
  /// force that the free displacement can cost.
  double force_scale(const NodeVector &force) const;

  /// ||natural map|| / force scale, from the forces alone: the measure that every solver stops on. NaN-safe:
  /// forces that are not finite give infinity.
  double residual(const NodeVector &force) const;
  double residual(const NodeVector &force, const NodeVector &displacement) const;

  /// The same from the natural map at `force`.
  double residual_of(const NodeVector &map, const NodeVector &force) const;

  /// A node is open if it carries no force, or one so small that only rounding tells it from none.
  NodeStatus status(Eigen::Index node, const NodeVector &force, const NodeVector &displacement) const;

private:
  double estimate_largest_compliance() const;

  const Compliance &compliance_;
  std::vector<OrthotropicFriction> given_laws_;
  std::vector<OrthotropicFriction> laws_; ///< normalized
  std::vector<double> rho_;
  double largest_compliance_ = 0;
  double negligible_force_ = 0;
  NodeVector free_;
};
} // namespace orthocone
