// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/history.h>

#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

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

History::History(RunFolder &folder, const Parameters &parameters)
    : folder_(folder),
      columns_(with_factor(with_surfaces(with_loads(history_columns(), parameters.load.loads),
                                         parameters.geometry.touching_surfaces()),
                           parameters.friction))
{
}

void History::start()
{
  folder_.append("history.csv", header_line(columns_));
  folder_.append("checks.csv", header_line(checks_columns()));
  folder_.append("timing.csv", header_line(timing_columns()));
}

void History::write(const SolvedStep &step)
{
  folder_.append("history.csv", row_line(columns_, step));
  folder_.append("checks.csv", row_line(checks_columns(), step));
  folder_.append("timing.csv", row_line(timing_columns(), step));
}

static std::string probe_file(const Probe &probe)
{
  return "probe-" + probe.name + ".csv";
}

std::vector<std::string> probe_files(const std::vector<Probe> &probes)
{
  std::vector<std::string> names;
  for (const Probe &probe : probes)
    names.push_back(probe_file(probe));
  return names;
}

ProbeHistories::ProbeHistories(RunFolder &folder, const std::vector<Probe> &probes,
                               const ContactFieldEvaluator &evaluator)
    : folder_(folder),
      evaluator_(evaluator)
{
  for (const Probe &probe : probes)
  {
    const Vector2d position(probe.position[0], probe.position[1]);
    const Matrix2d map = evaluator.symmetry().map_to(position);
    places_.push_back(
        {probe_file(probe), nearest_node(evaluator.surface(), map.transpose() * position), map});
  }
}

void ProbeHistories::start(const TableMarks &there)
{
  for (const Place &place : places_)
    if (there.count(place.file) == 0)
      folder_.append(place.file, header_line(probe_columns()));
}

void ProbeHistories::write(const ContactState &state)
{
  for (const Place &place : places_)
  {
    const ProbedStep probed{state, mapped(evaluator_.fields(state, place.node), place.map)};
    folder_.append(place.file, row_line(probe_columns(), probed));
  }
}

CycleTable::CycleTable(RunFolder &folder, const Parameters &parameters)
    : folder_(folder),
      columns_(with_factor(cycle_columns(), parameters.friction))
{
}

void CycleTable::start()
{
  folder_.append("cycles.csv", header_line(columns_));
}

void CycleTable::write(const CycleRow &row)
{
  folder_.append("cycles.csv", row_line(columns_, row));
}
} // namespace orthocone
