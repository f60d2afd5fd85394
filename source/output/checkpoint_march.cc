// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A march as a checkpoint stores it: its state, and the starts of later steps.
#include "checkpoint_json.h"

#include <utility>

namespace orthocone::checkpoint_json
{
using Eigen::Index;

namespace
{
/// An array whose size only others know: a body, whose mesh does, or the loads.
Eigen::VectorXd body_from(const Json &json)
{
  return array_from(json, static_cast<Index>(json.get_binary().size() / sizeof(double)));
}
/// A number for each of the nodes, or none at all.
Eigen::VectorXd of_nodes_or_none(const Json &json, const Index n)
{
  return array_from(json, json.get_binary().empty() ? 0 : n);
}
} // namespace

Json state_json(const ContactState &state)
{
  return {{"step", state.step},
          {"motion", array_json(state.motion.components)},
          {"loads", array_json(state.loads)},
          {"work", state.work},
          {"leg_motion", array_json(state.leg_begin.motion.components)},
          {"leg_wrench", array_json(state.leg_begin.wrench.components)},
          {"n_nodes", state.n_nodes()},
          {"force", array_json(state.force)},
          {"displacement", array_json(state.displacement)},
          {"accumulated_slip", array_json(state.accumulated_slip)},
          {"dissipated_energy", array_json(state.dissipated_energy)},
          {"wear_depth", array_json(state.wear_depth)},
          {"found_depth", array_json(state.found_depth)},
          {"slip_at_stick", array_json(state.slip_at_stick)},
          {"friction_factor", array_json(state.friction_factor)},
          {"slip_speed", array_json(state.slip_speed)},
          {"status", state.status}};
}

ContactState state_from(const Json &json)
{
  const auto n = static_cast<Index>(count_from(json.at("n_nodes")));
  ContactState state(0);
  state.step = count_from(json.at("step"));
  state.motion.components = array_from(json.at("motion"), n_rigid_components);
  state.loads = body_from(json.at("loads"));
  state.work = number_from(json.at("work"));
  state.leg_begin.motion.components = array_from(json.at("leg_motion"), n_rigid_components);
  state.leg_begin.wrench.components = array_from(json.at("leg_wrench"), n_rigid_components);
  state.accumulated_slip = array_from(json.at("accumulated_slip"), n);
  state.dissipated_energy = array_from(json.at("dissipated_energy"), n);
  state.wear_depth = array_from(json.at("wear_depth"), n);
  state.found_depth = array_from(json.at("found_depth"), n);
  state.slip_at_stick = array_from(json.at("slip_at_stick"), 2 * n);
  state.force = array_from(json.at("force"), 3 * n);
  state.displacement = array_from(json.at("displacement"), 3 * n);
  state.friction_factor = of_nodes_or_none(json.at("friction_factor"), n);
  state.slip_speed = of_nodes_or_none(json.at("slip_speed"), n);
  for (const auto &status : json.at("status"))
    switch (status.get<int>())
    {
    case static_cast<int>(NodeStatus::open):
    case static_cast<int>(NodeStatus::stick):
    case static_cast<int>(NodeStatus::slip):
      state.status.push_back(static_cast<NodeStatus>(status.get<int>()));
      break;
    default:
      throw CheckpointError("is damaged (unknown status of a node)");
    }
  if (static_cast<Index>(state.status.size()) != n)
    throw CheckpointError("is damaged (an array has the wrong size)");
  return state;
}

namespace
{
Json phases_json(const std::map<unsigned int, NodeVector> &forces)
{
  Json json = Json::array();
  for (const auto &[phase, force] : forces)
    json.push_back({phase, array_json(force)});
  return json;
}

std::map<unsigned int, NodeVector> phases_from(const Json &json, const Index n)
{
  std::map<unsigned int, NodeVector> forces;
  for (const auto &entry : json)
    forces[count_from(entry.at(0))] = array_from(entry.at(1), n);
  return forces;
}

Json bodies_json(const std::vector<Eigen::VectorXd> &bodies)
{
  Json json = Json::array();
  for (const Eigen::VectorXd &body : bodies)
    json.push_back(array_json(body));
  return json;
}

std::vector<Eigen::VectorXd> bodies_from(const Json &json)
{
  std::vector<Eigen::VectorXd> bodies;
  for (const Json &body : json)
    bodies.push_back(body_from(body));
  return bodies;
}

std::map<unsigned int, Eigen::VectorXd> phase_bodies_from(const Json &json)
{
  std::map<unsigned int, Eigen::VectorXd> bodies;
  for (const Json &entry : json)
    bodies[count_from(entry.at(0))] = body_from(entry.at(1));
  return bodies;
}

/// Starts without those of coarser marches.
Json own_starts_json(const StartMemory &starts)
{
  return {{"change", array_json(starts.change)},
          {"of_phase", phases_json(starts.of_phase)},
          {"drift", phases_json(starts.drift)},
          {"bodies", bodies_json(starts.bodies)},
          {"body_of_phase", phases_json(starts.body_of_phase)}};
}

StartMemory own_starts_from(const Json &json, const ContactState &state)
{
  // The motion of the held face and the loads are behind the forces.
  const Index n = 3 * state.n_nodes() + n_rigid_components + state.loads.size();
  // Before the first step there is no change, unless a search for a mesh has marched through it.
  const bool has_change = state.step > 0 || !json.at("change").get_binary().empty();
  return {array_from(json.at("change"), has_change ? n : 0),
          phases_from(json.at("of_phase"), n),
          phases_from(json.at("drift"), n),
          bodies_from(json.at("bodies")),
          {},
          phase_bodies_from(json.at("body_of_phase"))};
}

/// The coarser march, its coarser march and so on side by side, so that levels do not nest JSON.
Json coarser_json(const StartMemory &starts)
{
  Json json = Json::array();
  for (const std::vector<MarchMemory> *coarser = &starts.coarser; !coarser->empty();
       coarser = &coarser->front().starts.coarser)
    json.push_back({state_json(coarser->front().state), own_starts_json(coarser->front().starts)});
  return json;
}

std::vector<MarchMemory> coarser_from(const Json &json)
{
  constexpr std::size_t most = 64; // levels
  if (json.size() > most)
    throw CheckpointError("is damaged (a number is out of range)");
  std::vector<MarchMemory> coarser;
  for (auto march = json.rbegin(); march != json.rend(); ++march)
  {
    const ContactState state = state_from(march->at(0));
    StartMemory starts = own_starts_from(march->at(1), state);
    starts.coarser = std::exchange(coarser, {});
    coarser.push_back({state, std::move(starts)});
  }
  return coarser;
}
} // namespace

Json starts_json(const StartMemory &starts)
{
  Json json = own_starts_json(starts);
  json["coarser"] = coarser_json(starts);
  return json;
}

StartMemory starts_from(const Json &json, const ContactState &state)
{
  StartMemory starts = own_starts_from(json, state);
  starts.coarser = coarser_from(json.at("coarser"));
  return starts;
}
} // namespace orthocone::checkpoint_json
