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

FactorizedBody::FactorizedBody(const BodyOptions &options, const ModelSymmetry &symmetry,
                               const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                               const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
    : mesh_(timed(seconds.mesh, [&] { return Body(options, symmetry); })),
      stiffness_(announced_stiffness(mesh_, on_meshed, seconds.assembly)),
      factor_(timed(seconds.factorization,
                    [&] { return StiffnessFactor(stiffness_.matrix(), mesh_.unknowns().n_interior()); })),
      condensed_(timed(seconds.condensation,
                       [&] { return CondensedBody(mesh_.unknowns(), factor_, axes_of(surface())); })),
      driven_(timed(seconds.condensation, [&] { return driven_field(options, symmetry); }))
{
}

std::optional<DrivenField> FactorizedBody::driven_field(const BodyOptions &options,
                                                        const ModelSymmetry &symmetry) const
{
  if (!is_driven(mesh_, options))
    return std::nullopt;
  const auto solve = [this](const Eigen::VectorXd &forces)
  {
    Eigen::VectorXd u = factor_.solve(forces);
    u += factor_.solve(forces - stiffness_.vmult(u)); // rounding, as in CondensedBody::mismatch()
    return u;
  };
  return orthocone::driven_field(mesh_, options, frame(), symmetry, solve);
}
} // namespace orthocone
