// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/factorized_body.h>

#include <orthocone/base/stopwatch.h>

namespace orthocone
{
namespace
{
Stiffness announced_stiffness(const Body &mesh, const std::function<void(const Body &)> &on_meshed,
                              double &seconds)
{
  on_meshed(mesh);
  return timed(seconds, [&] { return mesh.stiffness(mesh.materials()); });
}
} // namespace

FactorizedBody::Base::Base(const BodyOptions &options, const ModelSymmetry &symmetry,
                           const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
    : mesh(timed(seconds.mesh, [&] { return Body(options, symmetry); })),
      stiffness(announced_stiffness(mesh, on_meshed, seconds.assembly)),
      factor(timed(seconds.factorization,
                   [&] { return StiffnessFactor(stiffness.matrix(), mesh.unknowns().n_interior()); }))
{
}

FactorizedBody::FactorizedBody(const BodyOptions &options, const ModelSymmetry &symmetry,
                               const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                               const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
    : base_(std::make_shared<const Base>(options, symmetry, on_meshed, seconds)),
      condensed_(timed(seconds.condensation, [&]
                       { return CondensedBody(base_->mesh.unknowns(), base_->factor, axes_of(surface())); })),
      driven_(timed(seconds.condensation, [&] { return driven_field(options, symmetry); }))
{
}

FactorizedBody::FactorizedBody(const FactorizedBody &other, const LocalAxes &axes)
    : base_(other.base_),
      condensed_(other.condensed_, axes),
      driven_(other.driven_)
{
  if (driven_)
    driven_->contact = at_contact_nodes(frame(), driven_->volume);
}

std::optional<DrivenField> FactorizedBody::driven_field(const BodyOptions &options,
                                                        const ModelSymmetry &symmetry) const
{
  if (!is_driven(base_->mesh, options))
    return std::nullopt;
  const auto solve = [this](const Eigen::VectorXd &forces)
  {
    Eigen::VectorXd u = base_->factor.solve(forces);
    u += base_->factor.solve(forces - base_->stiffness.vmult(u)); // rounding, as in CondensedBody::mismatch()
    return u;
  };
  return orthocone::driven_field(base_->mesh, options, frame(), symmetry, solve);
}
} // namespace orthocone
