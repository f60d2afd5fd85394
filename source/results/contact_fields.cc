// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/contact_fields.h>

#include <orthocone/base/numbers.h>
#include <orthocone/body/node_compliance.h>
#include <orthocone/body/shapes/supports.h>
#include <orthocone/march/slip_memory.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d ContactField::value(const ContactFields &fields) const
{
  if (const Vector *const vector = std::get_if<Vector>(&of))
    return fields.*(*vector);
  if (const Scalar *const scalar = std::get_if<Scalar>(&of))
    return {fields.*(*scalar), 0, 0};
  return {std::get<Derived>(of)(fields), 0, 0};
}

const std::vector<ContactField> &contact_field_list()
{
  using F = ContactFields;
  static const std::vector<ContactField> list{
      {"displacement", "mm", "displacement of the surface of the body", &F::displacement},
      {"slip", "mm", "displacement relative to the counterface, along it; 0 where the node is open",
       &F::slip},
      {"slip_magnitude", "mm", "magnitude of the slip", [](const F &f) { return f.slip.norm(); }},
      {"accumulated_slip", "mm",
       "accumulated slip: length of the path along which the node has slipped since the start",
       &F::accumulated_slip},
      {"gap", "mm", "gap between the surfaces, > 0 where the node is open", &F::gap},
      {"pressure", "MPa", "normal traction", &F::pressure},
      {"friction_traction", "MPa", "friction traction of the counterface on the body", &F::friction_traction},
      {"friction_criterion", "",
       "friction criterion ||r_t||_m / r_n - 1: 0 where the node slips, -1 where it has no friction force or "
       "is open",
       &F::friction_criterion},
      {"status", "", "0 open, 1 stick, 2 slip", [](const F &f) { return static_cast<double>(f.status); }},
      {"nodal_force", "N", "force of the counterface on the node", &F::nodal_force},
      {"dissipated_energy", "N/mm", "energy that friction has dissipated per area since the start",
       &F::dissipated_energy},
      {"wear_depth", "mm", "depth that slip has worn off", &F::wear_depth},
      {"surface_id", "", "number of the contact surface in Geometry/Contact surface, counted from 0",
       [](const F &f) { return static_cast<double>(f.surface); }},
      {"friction_factor", "", "Friction/Factor on the coefficients of friction in the step, where it is set",
       &F::friction_factor, [](const Parameters &p) { return p.friction.has_factor(); }}};
  return list;
}

std::vector<ContactField> contact_field_list(const Parameters &parameters)
{
  std::vector<ContactField> list;
  for (const ContactField &field : contact_field_list())
    if (field.is_there == nullptr || field.is_there(parameters))
      list.push_back(field);
  return list;
}

unsigned int image_of_surface(const GeometryOptions &geometry, const unsigned int number,
                              const Eigen::Matrix2d &map)
{
  if (geometry.is_from_file() || geometry.contact_surfaces.size() < 2 || geometry.ignores_contact_surfaces())
    return number;
  std::string name = geometry.contact_surfaces[number];
  for (const unsigned int plane : {0u, 1u})
    if (map(plane, plane) < 0)
      name = mirrored_surface(name, plane);
  return geometry.number_of_contact(name);
}

ContactFields mapped(ContactFields fields, const Eigen::Matrix2d &map)
{
  for (const ContactField &field : contact_field_list())
    if (const auto *const vector = std::get_if<ContactField::Vector>(&field.of))
      (fields.*(*vector)).head<2>() = map * (fields.*(*vector)).head<2>().eval();
  return fields;
}

/// The contact node with the largest weight in a hanging node.
static unsigned int nearest(const HangingNode &hanging)
{
  return std::max_element(hanging.terms.begin(), hanging.terms.end(),
                          [](const HangingNode::Term &a, const HangingNode::Term &b)
                          { return a.weight < b.weight; })
      ->node;
}

ContactFields between(const HangingNode &hanging, const std::vector<ContactFields> &all)
{
  ContactFields fields;
  for (const auto &[node, weight] : hanging.terms)
    for (const ContactField &field : contact_field_list())
      if (const auto *const vector = std::get_if<ContactField::Vector>(&field.of))
        fields.*(*vector) += weight * all[node].*(*vector);
      else if (const auto *const scalar = std::get_if<ContactField::Scalar>(&field.of))
        fields.*(*scalar) += weight * all[node].*(*scalar);
  fields.status = all[nearest(hanging)].status;
  fields.surface = all[nearest(hanging)].surface;
  fields.friction_criterion = all[nearest(hanging)].friction_criterion;
  if (fields.status == NodeStatus::open)
    fields.slip.setZero();
  fields.nodal_force.setZero();
  return fields;
}

/// The sample of a hanging node: the mean over the contact nodes, where slip counts against reserve by the
/// stiffness of the nodes (MPa/mm).
static StickSample between(const HangingNode &hanging, const std::vector<StickSample> &samples,
                           const std::vector<double> &stiffness)
{
  StickSample sample;
  double reserve = 0, slip = 0, of_stiffness = 0, of_weights = 0, slipping = 0;
  for (const auto &[node, weight] : hanging.terms)
  {
    const double share = std::abs(weight) * samples[node].slip;
    reserve += weight * samples[node].reserve;
    slip += weight * samples[node].slip;
    of_stiffness += std::abs(weight) * stiffness[node];
    of_weights += std::abs(weight);
    slipping += share;
    sample.normal_by_slip += share * samples[node].normal_by_slip;
  }
  if (slipping > 0)
    sample.normal_by_slip /= slipping;
  const double mean_stiffness = of_stiffness / of_weights;
  const double difference = std::max(0., reserve) - mean_stiffness * std::max(0., slip);
  sample.status = difference > 0   ? NodeStatus::stick
                  : difference < 0 ? NodeStatus::slip
                                   : samples[nearest(hanging)].status;
  sample.reserve = std::max(0., difference);
  sample.slip = std::max(0., -difference / mean_stiffness);
  return sample;
}

/// Of a node that slips under a friction force: the normal of the cone (StickSample::normal_by_slip), and the
/// direction of slip, both turned to the side of the force. The normal is how associated slip would go.
static std::pair<Vector2d, Vector2d> normal_and_slip(const FrictionLaw &law, const Vector2d &force)
{
  const Vector2d normal = law.cone_normal(force);
  const Vector2d slip = -law.slip_under(force);
  return {force.norm() / normal.dot(force) * normal, slip.normalized()};
}

ContactFieldEvaluator::ContactFieldEvaluator(const Scene &scene)
    : scene_(scene),
      unknowns_(scene.body().unknowns()),
      surface_(scene.surface()),
      symmetry_(scene.symmetry()),
      compliance_(scene.compliance()),
      axes_(scene.axes()),
      system_(scene.system()),
      shares_(symmetry_.force_shares(surface_)),
      compliances_(node_compliance(surface_, symmetry_, scene.contact_material())),
      tolerance_(scene.parameters().contact_solver.tolerance),
      stick_area_(surface_, scene.contact_material(), symmetry_.section().value_or(SectionModel())),
      zones_(surface_)
{
}

ContactFields ContactFieldEvaluator::fields(const ContactState &state, const unsigned int node) const
{
  const ContactNode &place = surface_.nodes[node];
  const Eigen::Index first = 3 * static_cast<Eigen::Index>(node);
  const Vector3d d = state.displacement.segment<3>(first);
  const Vector3d r = state.force.segment<3>(first);
  const Eigen::Matrix3d &axes = axes_.global_in_local(node);
  const Vector3d slip = axes_.to_global(node, d.tail<2>());
  const Vector3d friction = axes_.to_global(node, r.tail<2>());
  const double share = shares_[node];
  ContactFields fields;
  fields.displacement =
      slip + axes.col(0) * (d[0] - scene_.undeformed_gap(node, state.loads) - state.found_depth[node]);
  if (state.status[node] != NodeStatus::open)
    fields.slip = slip;
  fields.accumulated_slip = state.accumulated_slip[node];
  fields.gap = d[0];
  const double area = scene_.pressed_areas()[node];
  fields.pressure = r[0] / area;
  fields.friction_traction = friction / area;
  if (const FrictionLaw law = law_of(system_, state, first / 3); state.status[node] != NodeStatus::open)
    fields.friction_criterion = law.is_frictionless() ? 0 : law.load(r.tail<2>()) / r[0] - 1;
  fields.status = state.status[node];
  fields.nodal_force = friction / share + axes.col(0) * (r[0] / share);
  fields.normal_force = r[0] / share;
  fields.dissipated_energy = state.dissipated_energy[node] / area;
  fields.wear_depth = state.wear_depth[node];
  fields.surface = place.surface;
  fields.friction_factor = state.friction_factor.size() == 0 ? 1 : state.friction_factor[node];
  return fields;
}

/// Adds the displacement of the counterface to that of the nodes relative to it. Forces and loads on the
/// lower body open gaps where they move the counterface away.
void ContactFieldEvaluator::add_counterface(const ContactState &state, std::vector<ContactFields> &all) const
{
  NodeVector parted = scene_.given_way(state.force);
  if (scene_.lower() != nullptr && scene_.lower()->body().driven() != nullptr)
    parted += scene_.lower()->parted(scene_.lower()->body().moved_with({}, state.loads));
  for (std::size_t node = 0; node < all.size(); ++node)
    all[node].displacement -=
        axes_.global_in_local(node) * parted.segment<3>(3 * static_cast<Eigen::Index>(node));
}

std::vector<ContactFields> ContactFieldEvaluator::all_fields(const ContactState &state) const
{
  std::vector<ContactFields> all;
  for (unsigned int node = 0; node < surface_.nodes.size(); ++node)
    all.push_back(fields(state, node));
  add_counterface(state, all);
  for (const HangingNode &hanging : surface_.hanging)
    all.push_back(between(hanging, all));
  return all;
}

/// The part that would carry the load under an even pressure has the area (sum r)^2 / sum(r^2 / area); of the
/// pressure of Hertz it is 0.89 of the contact, of one that falls linearly across a square 0.75.
double ContactFieldEvaluator::load_width(const ContactState &state) const
{
  constexpr double most_of_contact = 0.5;
  double force = 0, squares = 0, of_nodes = 0, contact = 0;
  for (unsigned int node = 0; node < surface_.nodes.size(); ++node)
    if (state.status[node] != NodeStatus::open)
    {
      const double r = state.force[3 * static_cast<Eigen::Index>(node)], area = surface_.nodes[node].area;
      force += r;
      squares += r * r / area;
      of_nodes += r * area / shares_[node];
      contact += area;
    }
  if (force <= 0)
    return 0;
  const double area = force * force / squares;
  return symmetry_.is_section() || area > most_of_contact * contact
             ? std::numeric_limits<double>::infinity()
             : std::sqrt(symmetry_.n_copies() * area * force / of_nodes);
}

ZoneWidths ContactFieldEvaluator::zones(const ContactState &state) const
{
  std::vector<NodeStatus> statuses = state.status;
  for (const HangingNode &hanging : surface_.hanging)
    statuses.push_back(state.status[nearest(hanging)]);
  ZoneWidths widths = zones_.widths(statuses);
  widths.load = load_width(state);
  return widths;
}

/// What is unresolved counts as reserve, and slip and gap count against it. So a sample is a continuous
/// function of forces and displacements, also where a node sticks, slips or opens.
StickSample ContactFieldEvaluator::stick_sample(const ContactState &state, const unsigned int node,
                                                const double unresolved) const
{
  const Eigen::Index first = 3 * static_cast<Eigen::Index>(node);
  const Vector3d r = state.force.segment<3>(first);
  const FrictionLaw law = law_of(system_, state, first / 3);
  const double compliance = compliances_[first / 3];
  const bool is_open = state.status[node] == NodeStatus::open;
  const double way = slip_since_stick(state, node) + (is_open ? std::max(0., state.displacement[first]) : 0);
  const double level = (is_open ? 0 : compliance * friction_reserve(law, r)) + unresolved - way;
  StickSample sample;
  if (!is_open)
    sample.status = level >= 0 && !law.is_frictionless() ? NodeStatus::stick : NodeStatus::slip;
  sample.slip = std::max(0., -level);
  if (sample.status == NodeStatus::stick)
  {
    sample.reserve = level / (compliance * surface_.nodes[node].area);
    return sample;
  }
  sample.normal_by_slip = stick_area_.of_unknown_direction(axes_.normal(node));
  if (law.is_frictionless() || r.tail<2>().isZero(0))
    return sample;
  const auto [normal, slip] = normal_and_slip(law, r.tail<2>());
  const double known = std::clamp(relative(compliance * r.tail<2>().norm(), unresolved) - 1, 0., 1.);
  sample.normal_by_slip *= 1 - known;
  sample.normal_by_slip += known * axes_.to_global(node, normal) * axes_.to_global(node, slip).transpose();
  return sample;
}

double ContactFieldEvaluator::stick_area(const ContactState &state) const
{
  const double unresolved = unresolved_slip(state.force, compliances_, tolerance_);
  std::vector<StickSample> samples;
  std::vector<double> stiffness;
  for (unsigned int node = 0; node < surface_.nodes.size(); ++node)
  {
    samples.push_back(stick_sample(state, node, unresolved));
    stiffness.push_back(1 / (compliances_[node] * surface_.nodes[node].area));
  }
  for (const HangingNode &hanging : surface_.hanging)
    samples.push_back(between(hanging, samples, stiffness));
  return symmetry_.n_copies() * stick_area_(samples);
}
} // namespace orthocone
