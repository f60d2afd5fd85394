// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/history.h>

#include "csv.h"

#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
using csv::row;
using Eigen::Matrix2d;
using Eigen::Vector2d;

const char *word_of(const NodeStatus status)
{
  return status == NodeStatus::open ? "open" : status == NodeStatus::stick ? "stick" : "slip";
}

unsigned int nearest_node(const ContactSurface &surface, const Vector2d &position)
{
  unsigned int nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (unsigned int node = 0; node < surface.nodes.size(); ++node)
  {
    const auto &place = surface.nodes[node].position;
    const double distance = std::hypot(place[0] - position[0], place[1] - position[1]);
    if (distance < least)
    {
      least = distance;
      nearest = node;
    }
  }
  return nearest;
}
} // namespace

History::History(const RunFolder &folder, const ContactMethod method)
    : folder_(folder),
      method_(method)
{
}

void History::start() const
{
  folder_.append("history.csv",
                 "step,ux,uy,uz,force_x,force_y,force_z,max_slip,max_accumulated_slip,min_pressure,"
                 "max_pressure,n_open,n_stick,n_slip,stick_area,dissipation,total_dissipation,"
                 "elastic_energy,method,iterations,residual\n");
  folder_.append("checks.csv", "step,equilibrium,penetration,complementarity,friction_cone,slip_rule,work,"
                               "energy_identity,energy_defect\n");
  folder_.append("timing.csv", "step,seconds,iterations\n");
}

void History::write(const SolvedStep &step) const
{
  const auto &[state, before, totals, report, checks, seconds] = step;
  folder_.append("history.csv",
                 row(state.step, state.top[0], state.top[1], state.top[2], totals.force[0], totals.force[1],
                     totals.force[2], totals.max_slip, totals.max_accumulated_slip, totals.min_pressure,
                     totals.max_pressure, totals.n_open, totals.n_stick, totals.n_slip, totals.stick_area,
                     totals.total_dissipation - before.total_dissipation, totals.total_dissipation,
                     totals.elastic_energy, to_word(method_), report.iterations, report.residual));
  const LawErrors &law = checks.law;
  folder_.append("checks.csv",
                 row(state.step, checks.equilibrium, law.penetration, law.complementarity, law.friction_cone,
                     law.slip_rule, checks.work, checks.energy_identity, checks.energy_defect));
  folder_.append("timing.csv", row(state.step, seconds, report.iterations));
}

ProbeHistories::ProbeHistories(const RunFolder &folder, const std::vector<Probe> &probes,
                               const ContactFieldEvaluator &evaluator)
    : folder_(folder),
      evaluator_(evaluator)
{
  for (const Probe &probe : probes)
  {
    const Vector2d position(probe.position[0], probe.position[1]);
    const Matrix2d map = evaluator.symmetry().map_to(position);
    places_.push_back(
        {"probe-" + probe.name + ".csv", nearest_node(evaluator.surface(), map.transpose() * position), map});
  }
}

void ProbeHistories::start(const TableMarks &there) const
{
  for (const Place &place : places_)
    if (there.count(place.file) == 0)
      folder_.append(place.file, "step,uz,slip_x,slip_y,accumulated_slip,force_n,force_x,force_y,pressure,"
                                 "traction_x,traction_y,status\n");
}

void ProbeHistories::write(const ContactState &state) const
{
  for (const Place &place : places_)
  {
    const ContactFields fields = evaluator_.fields(state, place.node);
    const Vector2d slip = place.map * fields.slip.head<2>();
    const Vector2d force = place.map * fields.nodal_force.head<2>();
    const Vector2d traction = place.map * fields.friction_traction.head<2>();
    folder_.append(place.file, row(state.step, state.top[2], slip[0], slip[1], fields.accumulated_slip,
                                   fields.nodal_force[2], force[0], force[1], fields.pressure, traction[0],
                                   traction[1], std::string(word_of(fields.status))));
  }
}
} // namespace orthocone
