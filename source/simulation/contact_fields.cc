// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/contact_fields.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Vector2d;
using Eigen::Vector3d;

ContactFieldEvaluator::ContactFieldEvaluator(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                             const SurfaceAxes &axes, const OrthotropicFriction &law,
                                             const MaterialOptions &material)
    : surface_(surface),
      symmetry_(symmetry),
      axes_(axes),
      law_(law),
      shares_(symmetry.force_shares(surface)),
      stick_area_(surface, material)
{
}

ContactFields ContactFieldEvaluator::fields(const ContactState &state, const unsigned int node) const
{
  const ContactNode &place = surface_.nodes[node];
  const Eigen::Index first = 3 * static_cast<Eigen::Index>(node);
  const Vector3d d = state.displacement.segment<3>(first);
  const Vector3d r = state.force.segment<3>(first);
  const Vector2d slip = axes_.to_global(d.tail<2>());
  const Vector2d friction = axes_.to_global(r.tail<2>());
  const double share = shares_[node];
  ContactFields fields;
  fields.displacement << slip, d[0];
  fields.slip << slip, 0;
  fields.accumulated_slip = state.accumulated_slip[node];
  fields.gap = d[0];
  fields.pressure = r[0] / place.area;
  fields.friction_traction << friction / place.area, 0;
  if (state.status[node] != NodeStatus::open)
    fields.friction_criterion = is_frictionless(law_) ? 0 : friction_norm(law_, r[1], r[2]) / r[0] - 1;
  fields.status = state.status[node];
  fields.nodal_force << friction / share, r[0] / share;
  fields.dissipated_energy = state.dissipated_energy[node] / place.area;
  return fields;
}

std::vector<ContactFields> ContactFieldEvaluator::all_fields(const ContactState &state) const
{
  std::vector<ContactFields> all;
  for (unsigned int node = 0; node < surface_.nodes.size(); ++node)
    all.push_back(fields(state, node));
  return all;
}

double ContactFieldEvaluator::stick_area(const ContactState &state) const
{
  std::vector<StickSample> samples(surface_.nodes.size());
  for (unsigned int node = 0; node < samples.size(); ++node)
  {
    StickSample &sample = samples[node];
    const Vector3d r = state.force.segment<3>(3 * static_cast<Eigen::Index>(node));
    // The friction coefficient is that along the force, but has to stay defined where there is no such
    // direction.
    const double load = r[0] > 0 ? friction_norm(law_, r[1], r[2]) / r[0] : 1;
    const double friction =
        r[0] > 0 ? r.tail<2>().norm() / r[0] + (1 - load) * std::sqrt(law_.mu_x * law_.mu_y) : 0;
    sample.status = state.status[node];
    sample.reserve = friction * std::max(0., (1 - load) * r[0]) / surface_.nodes[node].area;
    sample.slip = slip_since_stick(state, node);
  }
  return symmetry_.n_copies() * stick_area_(samples);
}
} // namespace orthocone
