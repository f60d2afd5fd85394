// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/phases.h>
#include <orthocone/body/elastic_body.h>

#include <functional>
#include <memory>

namespace orthocone
{
/// An elastic half-space above its contact surface, on a regular grid: no mesh, no stiffness, and a
/// compliance by fast Fourier transforms. Displacements count from the far field, which moves as the held
/// face of other bodies does. Its volume has no unknowns: elastic_displacement() is that of the surface.
class HalfSpaceBody : public ElasticBody
{
public:
  /// As FactorizedBody. The material of `options` must be isotropic.
  HalfSpaceBody(const BodyOptions &options, const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds);

  const Body &mesh() const override { return body_; }
  const Compliance &compliance() const override { return *compliance_; }
  const ContactFrame &frame() const override { return *frame_; }
  std::unique_ptr<const Compliance> compliance_on(const MaterialOptions &counterface) const override;
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const override;

  NodeVector prolonged_forces(const Eigen::VectorXd &coarser) const override;

  /// There is nothing to balance, so that `unbalanced` is how far the displacement of the most loaded node
  /// differs from the sum of what all forces do there by the closed forms, relative to the displacement.
  BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, double bound) const override;

private:
  std::unique_ptr<const Compliance> make_compliance(const std::optional<HalfSpace> &counterface) const;

  SurfaceGrid grid_;
  HalfSpace material_;
  Body body_;
  LocalAxes axes_;
  std::unique_ptr<const ContactFrame> frame_;
  std::unique_ptr<const Compliance> compliance_;
};
} // namespace orthocone
