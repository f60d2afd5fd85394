// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/totals.h>

#include <algorithm>
#include <array>
#include <limits>

namespace orthocone
{
using Eigen::Vector3d;

namespace
{
void count_status(const NodeStatus status, const unsigned int n, Totals &totals)
{
  switch (status)
  {
  case NodeStatus::open:
    totals.n_open += n;
    break;
  case NodeStatus::stick:
    totals.n_stick += n;
    break;
  case NodeStatus::slip:
    totals.n_slip += n;
    break;
  }
}

/// Sets to zero what cancels: forces across a plane of symmetry cancel between the copies, and so do moments,
/// except the one about the normal of a plane. Around a ring all cancels but what is along or about its axis.
void leave_out_what_cancels(const ModelSymmetry &symmetry, Totals &totals)
{
  if (symmetry.is_axisymmetric())
  {
    totals.force.head<2>().setZero();
    totals.moment.head<2>().setZero();
    if (!symmetry.has_third())
      totals.moment[2] = 0;
    return;
  }
  const std::array<bool, 2> mirrored{{symmetry.planes().normal_to_x, symmetry.planes().normal_to_y}};
  for (unsigned int normal = 0; normal < 2; ++normal)
    if (mirrored[normal])
    {
      totals.force[normal] = 0;
      totals.moment[1 - normal] = 0;
      totals.moment[2] = 0;
    }
}
void add_loads(const Scene &scene, const ContactState &state, Totals &totals)
{
  if (scene.n_loads() == 0)
    return;
  totals.loads = scene.face_state(state.force, state.motion, state.loads).loads;
  totals.load_areas = scene.load_areas();
  totals.conjugates = scene.load_conjugates(state.force, state.motion, state.loads);
  for (Eigen::Index k = 0; k < scene.n_loads(); ++k)
    if (scene.parameters().load.loads[static_cast<std::size_t>(k)].kind->is_force_of_surface())
      totals.conjugates[k] = state.loads[k];
}

/// The maps (2 x 2) from the modelled part to all copies of it.
std::vector<Eigen::Matrix2d> copies_of(const SymmetryPlanes &planes)
{
  std::vector<Eigen::Matrix2d> maps;
  for (const double x : {1., -1.})
    for (const double y : {1., -1.})
      if ((x > 0 || planes.normal_to_x) && (y > 0 || planes.normal_to_y))
        maps.emplace_back(Eigen::Vector2d(x, y).asDiagonal());
  return maps;
}

/// Adds a node of the model to the sums of its surface, or of their images, copy by copy.
void add_node(const ContactFieldEvaluator &evaluator, const ContactState &state, const unsigned int node,
              const ContactFields &fields, std::vector<SurfaceTotals> &surfaces)
{
  const ModelSymmetry &symmetry = evaluator.symmetry();
  const ContactNode &place = evaluator.surface().nodes[node];
  const Vector3d force = evaluator.model_force(state, node);
  for (const Eigen::Matrix2d &map : copies_of(symmetry.planes()))
  {
    SurfaceTotals &totals =
        surfaces[image_of_surface(evaluator.scene().parameters().geometry, place.surface, map)];
    if (!symmetry.is_axisymmetric()) // around a ring forces across the axis cancel
      totals.force.head<2>() += map * force.head<2>();
    totals.force[2] += force[2];
    totals.normal_force += state.force[3 * static_cast<Eigen::Index>(node)];
    totals.contact_area += fields.status == NodeStatus::open ? 0 : place.area;
    totals.max_pressure = std::max(totals.max_pressure, fields.pressure);
    totals.max_slip = std::max(totals.max_slip, fields.slip.norm());
    totals.total_dissipation += state.dissipated_energy[node];
  }
}
/// The factor of friction over the nodes in contact; nothing where there are none, or no factor.
std::optional<FactorRange> factor_range(const ContactSurface &surface, const ContactState &state)
{
  FactorRange range{std::numeric_limits<double>::infinity()};
  double area = 0;
  for (Eigen::Index node = 0; node < state.friction_factor.size(); ++node)
  {
    const auto i = static_cast<std::size_t>(node);
    if (state.status[i] == NodeStatus::open)
      continue;
    const double factor = state.friction_factor[node];
    range.least = std::min(range.least, factor);
    range.largest = std::max(range.largest, factor);
    range.mean += surface.nodes[i].area * factor;
    area += surface.nodes[i].area;
  }
  range.mean /= area;
  return area > 0 ? std::optional(range) : std::nullopt;
}
} // namespace

Totals compute_totals(const ContactFieldEvaluator &evaluator, const ContactState &state)
{
  const ModelSymmetry &symmetry = evaluator.symmetry();
  const ContactSurface &surface = evaluator.surface();
  const unsigned int n_copies = symmetry.n_copies();
  const Scene &scene = evaluator.scene();
  Totals totals;
  totals.min_pressure = std::numeric_limits<double>::max();
  if (const std::size_t n = scene.parameters().geometry.touching_surfaces().size(); n > 1)
    totals.surfaces.resize(n);
  for (unsigned int node = 0; node < surface.nodes.size(); ++node)
  {
    const ContactNode &place = surface.nodes[node];
    const ContactFields fields = evaluator.fields(state, node);
    const Vector3d force = symmetry.n_images(surface, place) * fields.nodal_force;
    totals.force += force;
    totals.moment += evaluator.arm(node).cross(force);
    totals.max_slip = std::max(totals.max_slip, fields.slip.norm());
    totals.max_accumulated_slip = std::max(totals.max_accumulated_slip, fields.accumulated_slip);
    totals.min_pressure = std::min(totals.min_pressure, fields.pressure);
    totals.max_pressure = std::max(totals.max_pressure, fields.pressure);
    totals.contact_area += fields.status == NodeStatus::open ? 0 : n_copies * place.area;
    count_status(fields.status, symmetry.n_counted(surface, place), totals);
    totals.worn_volume += n_copies * fields.wear_depth * scene.pressed_areas()[node];
    totals.max_wear_depth = std::max(totals.max_wear_depth, fields.wear_depth);
    totals.max_dissipated_energy = std::max(totals.max_dissipated_energy, fields.dissipated_energy);
    totals.total_dissipation += n_copies * state.dissipated_energy[node];
    if (!totals.surfaces.empty())
      add_node(evaluator, state, node, fields, totals.surfaces);
  }
  leave_out_what_cancels(symmetry, totals);
  totals.stick_area = evaluator.stick_area(state);
  totals.zones = evaluator.zones(state);
  totals.factor = factor_range(surface, state);
  totals.elastic_energy = scene.elastic_energy(state.force, state.motion, state.loads);
  totals.held.components << -totals.force, -totals.moment; // without supports it balances the counterface
  if (scene.body().driven() != nullptr)
    totals.held = scene.held_wrench(state.force, state.motion, state.loads);
  add_loads(scene, state, totals);
  return totals;
}
} // namespace orthocone
