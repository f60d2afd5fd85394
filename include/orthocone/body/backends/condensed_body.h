// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/contact_frame.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/elastic_body.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// The body condensed to its n contact nodes. Its displacement under a motion of the held face and contact
/// forces r is the rigid motion plus K^-1 r, because the rest of the body is free: only the plane keeps it
/// from following the face (docs/theory.md, section 2).
class CondensedBody
{
public:
  /// `unknowns` and `factor` must outlive the body. Throws as StiffnessFactor::trailing_inverse() does.
  CondensedBody(const BodyUnknowns &unknowns, const StiffnessFactor &factor, LocalAxes axes);

  /// The same body with other local axes: W is turned from global axes to these by the same operations as it
  /// was made, so that it has the same bits as if it were condensed anew. Throws std::logic_error unless
  /// other.can_turn().
  CondensedBody(const CondensedBody &other, LocalAxes axes);

  /// Whether all local axes are global axes, from which W turns back without rounding.
  bool can_turn() const;

  const DenseCompliance &compliance() const { return compliance_; } ///< W, 3 n x 3 n, local axes, mm/N

  const ContactFrame &frame() const { return frame_; }

  /// K^-1 r (mm, size n_free()) under the contact forces r = `force` (3 n, local axes, N).
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const;

  /// ElasticBody::mismatch().
  BodyMismatch mismatch(const Stiffness &stiffness, const NodeVector &force, const NodeVector &elastic,
                        double bound) const;

private:
  Eigen::MatrixXd local_compliance() const;
  Eigen::MatrixXd turned_compliance(const CondensedBody &other) const;

  const BodyUnknowns &unknowns_;
  const StiffnessFactor &factor_;
  ContactFrame frame_;
  DenseCompliance compliance_;
};
} // namespace orthocone
