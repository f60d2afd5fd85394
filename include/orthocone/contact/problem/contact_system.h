// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>
#include <orthocone/surface/compliance.h>

#include <vector>

namespace orthocone
{
/// The laws of nodes, in their order.
using FrictionLaws = std::vector<FrictionLaw>;

/// The data that all load steps share: the compliance W of the n contact nodes (3 n x 3 n, mm/N), and the
/// friction law of each node.
class ContactSystem
{
public:
  /// `compliance` must outlive the system; `laws` has one entry a node, which is asserted.
  ContactSystem(const Compliance &compliance, FrictionLaws laws);

  Eigen::Index n_nodes() const { return compliance_.n_nodes(); }
  const Compliance &compliance() const { return compliance_; } ///< W, mm/N

  /// The laws of the nodes, which a step may replace by its own.
  const FrictionLaws &laws() const { return laws_; }
  const FrictionLaw &law(Eigen::Index node) const { return laws_[node]; }

  /// Step of the natural map of a node, 1 / max(diagonal of its block of W), N/mm.
  double rho(Eigen::Index node) const { return rho_[node]; }

  /// Compliance::softness(), mm/N.
  double softness() const { return softness_; }

  /// Residual below which rounding of the displacement decides: the machine's precision times the largest
  /// product of a node's rho and the largest eigenvalue of W.
  double rounding() const;

private:
  const Compliance &compliance_;
  FrictionLaws laws_;
  std::vector<double> rho_;
  double softness_;
};
} // namespace orthocone
