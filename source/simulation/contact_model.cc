// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/contact_model.h>

#include <orthocone/simulation/stopwatch.h>

namespace orthocone
{
namespace
{
OrthotropicFriction friction_of(const FrictionOptions &options)
{
  return {options.mu[0], options.mu[1], options.p()[0], options.p()[1]};
}

Stiffness announced_stiffness(const Parameters &parameters, const Body &body,
                              const std::function<void(const Body &)> &on_meshed, double &seconds)
{
  if (on_meshed)
    on_meshed(body);
  return timed(seconds, [&] { return body.stiffness(parameters.material); });
}
} // namespace

ContactModel::ContactModel(const Parameters &parameters, const ModelChoice &choice,
                           const std::function<void(const Body &)> &on_meshed)
    : choice_(choice),
      body_(timed(seconds_.mesh, [&] { return Body(parameters, choice.symmetry); })),
      stiffness_(announced_stiffness(parameters, body_, on_meshed, seconds_.assembly)),
      factor_(timed(seconds_.factorization,
                    [&] { return StiffnessFactor(stiffness_.matrix(), body_.unknowns().n_interior()); })),
      axes_(choice.symmetry.is_axisymmetric() ? 0 : parameters.friction.angle),
      condensed_(
          timed(seconds_.condensation, [&] { return CondensedBody(body_.unknowns(), factor_, axes_); })),
      problem_(condensed_.compliance(),
               std::vector<OrthotropicFriction>(surface().nodes.size(), friction_of(parameters.friction))),
      solver_(condensed_, problem_, opening_compliance(surface(), choice.symmetry, parameters.material),
              parameters.contact_solver),
      evaluator_(surface(), choice.symmetry, axes_, friction_of(parameters.friction), parameters.material)
{
}

Totals ContactModel::totals(const ContactState &state) const
{
  return compute_totals(evaluator_, state, condensed_.compliance());
}
} // namespace orthocone
