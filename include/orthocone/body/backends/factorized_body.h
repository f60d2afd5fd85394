// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/phases.h>
#include <orthocone/body/backends/condensed_body.h>
#include <orthocone/body/elastic_body.h>

#include <functional>
#include <memory>
#include <optional>

namespace orthocone
{
/// A body whose stiffness is factorized once and condensed to its contact nodes.
class FactorizedBody : public ElasticBody
{
public:
  /// `axes_of` returns the local axes of the contact nodes. `on_meshed` is called with the meshed body before
  /// the long work begins. Wall times are added to `seconds`. Throws what Body and StiffnessFactor throw.
  FactorizedBody(const BodyOptions &options, const ModelSymmetry &symmetry,
                 const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                 const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds);

  /// The body of another one with these local axes, to the last bit as if it were made with them. Mesh and
  /// factor are shared. Throws std::logic_error unless other.can_turn().
  FactorizedBody(const FactorizedBody &other, const LocalAxes &axes);
  FactorizedBody(const FactorizedBody &) = delete; // its modules refer to each other
  FactorizedBody &operator=(const FactorizedBody &) = delete;

  /// Whether the local axes are global axes, out of which W turns without rounding.
  bool can_turn() const { return condensed_.can_turn(); }

  const Body &mesh() const override { return base_->mesh; }
  const Compliance &compliance() const override { return condensed_.compliance(); }
  const ContactFrame &frame() const override { return condensed_.frame(); }
  const DrivenField *driven() const override { return driven_ ? &*driven_ : nullptr; }
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const override
  {
    return condensed_.elastic_displacement(force);
  }
  BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, const double bound) const override
  {
    return condensed_.mismatch(base_->stiffness, force, elastic, bound);
  }

private:
  /// What does not know of local axes.
  struct Base
  {
    Base(const BodyOptions &options, const ModelSymmetry &symmetry,
         const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds);
    Body mesh;
    Stiffness stiffness;
    StiffnessFactor factor;
  };
  std::optional<DrivenField> driven_field(const BodyOptions &options, const ModelSymmetry &symmetry) const;

  std::shared_ptr<const Base> base_;
  CondensedBody condensed_;
  std::optional<DrivenField> driven_; ///< with supports or loads
};
} // namespace orthocone
