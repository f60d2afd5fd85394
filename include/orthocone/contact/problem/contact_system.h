// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>
#include <orthocone/surface/compliance.h>

#include <vector>

namespace orthocone
{
/// The data that all load steps share: the compliance W of the n contact nodes (3 n x 3 n, mm/N), and the
/// friction law of each node.
class ContactSystem
{
public:
  /// `compliance` must outlive the system; `laws` has one entry a node, which is asserted.
  ContactSystem(const Compliance &compliance, std::vector<OrthotropicFriction> laws);

  Eigen::Index n_nodes() const { return compliance_.n_nodes(); }
  const Compliance &compliance() const { return compliance_; } ///< W, mm/N

  /// The law as given, and the same law with p scaled for the natural map.
  const OrthotropicFriction &given_law(Eigen::Index node) const { return given_laws_[node]; }
  const OrthotropicFriction &law(Eigen::Index node) const { return laws_[node]; }

  /// Step of the natural map of a node, 1 / max(diagonal of its block of W), N/mm.
  double rho(Eigen::Index node) const { return rho_[node]; }

  /// Compliance::softness(), mm/N.
  double softness() const { return softness_; }

  /// Residual below which rounding of the displacement decides: the machine's precision times the largest
  /// product of a node's rho and the largest eigenvalue of W.
  double rounding() const;

private:
  const Compliance &compliance_;
  std::vector<OrthotropicFriction> given_laws_;
  std::vector<OrthotropicFriction> laws_; ///< normalized
  std::vector<double> rho_;
  double softness_;
};
} // namespace orthocone
