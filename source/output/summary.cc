// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/summary.h>

#include "motion_warnings.h"

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/contact/problem/law_errors.h>
#include <orthocone/march/implicit_wear.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace orthocone
{
namespace
{
void consider(std::pair<double, unsigned int> &peak, const double value, const unsigned int step)
{
  if (value > peak.first)
    peak = {value, step};
}
} // namespace

void RunRecord::add_step(const unsigned int step, const Totals &before, const Totals &totals,
                         const SolverReport &report, const StepChecks &checks)
{
  work += checks.work;
  dissipation += totals.total_dissipation - before.total_dissipation;
  into_wear += checks.into_wear;
  stored = totals.elastic_energy;
  missing += checks.energy_defect * checks.energy;
  n_iterations += report.iterations;
  largest_residual = std::max(largest_residual, report.residual);
  largest_energy = checks.energy;
  peaks.consider(step, totals);
  consider(energy_defect, checks.energy_defect, step);
  consider(wear_of_flattening, checks.wear_of_flattening, step);
  consider(slip_of_change, checks.slip_of_change, step);
  consider(flattening, checks.motion.flattening, step);
  consider(pressure_of_modulus, checks.motion.pressure_of_modulus, step);
  consider(slide_of_face, checks.motion.slide_of_face, step);
  consider(border, checks.motion.border, step);
  consider(change_of_factor, checks.change_of_factor, step);
  energy_of_fall += checks.energy_of_fall;
  consider(largest_factor, totals.factor ? totals.factor->largest : 0, step);
  zones.add_step(step, totals.force[2], totals.zones);
}

void RunRecord::add_jump(const CycleRow &jumped)
{
  work += jumped.work;
  dissipation += jumped.dissipation;
  into_wear += jumped.into_wear;
  missing += jumped.missing;
}

double RunRecord::energy_scale() const
{
  return std::max(largest_energy, dissipation);
}

std::string describe(const CriticalFrictionRecord &critical)
{
  std::ostringstream text;
  text << std::setprecision(3) << "critical friction ";
  if (std::isnan(critical.factor))
    text << "not known, because it is computed from the compliance of single nodes, which a "
            "condensed body alone has, and for friction ellipses only";
  else if (!std::isfinite(critical.factor))
    text << "none, because there is no friction, or because normal and tangential directions are not coupled";
  else
    text << critical.factor << " times the given one, at (" << critical.position[0] << ", "
         << critical.position[1] << ") mm";
  return text.str();
}

std::vector<std::string> model_warnings(const RunRecord &record)
{
  std::vector<std::string> warnings = record.of_files;
  if (record.critical_friction.factor <= 1)
    warnings.push_back(
        describe(record.critical_friction) +
        ": a node can wedge there, so that a load step may have several solutions, or none that a solver "
        "finds; compare runs with other steps and methods before you trust a result");
  constexpr double most_stretch = 10; // docs/performance.md, "Multigrid"
  if (record.stretch > most_stretch)
    warnings.push_back("Mesh: the longest edge of a cell is " + to_text(std::round(record.stretch)) +
                       " times as long as its shortest one, and multigrid takes V-cycles in proportion; "
                       "cells nearer to cubes take fewer, and Mesh/Backend = condensed takes none");
  return warnings;
}

/// Wear is explicit: a node that wears deeper than it was flattened carries nothing in the next step, and its
/// neighbours carry all. The bound holds for forces that alternate from node to node on a half-space
/// (docs/theory.md, section 3, "Wear").
static void warn_of_fast_wear(const RunRecord &record, std::vector<std::string> &warnings)
{
  if (record.wear_of_flattening.first > most_explicit_wear)
    warnings.push_back("load step " + std::to_string(record.wear_of_flattening.second) + ": wears a node " +
                       to_text(std::round(10 * record.wear_of_flattening.first) / 10) +
                       " times as deep as pressure flattens it there; above 0.9 contact flickers from node "
                       "to node, so that the worn volume is wrong. Take Wear/Deep steps = implicit with "
                       "Mesh/Backend = condensed, or more load steps");
}

/// What load steps leave of the energy balance is what slip that turns round within them leaves. One sentence
/// is enough: on the step that leaves most, or on the dissipated energy.
static void warn_of_energy(const RunRecord &record, std::vector<std::string> &warnings)
{
  constexpr double large = 0.05; // docs/theory.md, section 5, "Energy defect"
  constexpr double noticeable = 0.01;
  constexpr double least_loop = 1e-3; // a press or a lift has less of the largest energy, a loop has more
  const double percent = 100 * record.missing / record.dissipation;
  if (record.energy_defect.first > large)
    warnings.push_back("load step " + std::to_string(record.energy_defect.second) +
                       ": the energy balance misses " +
                       to_text(std::round(100 * record.energy_defect.first)) +
                       " % of the largest energy, because slip reverses within the step, so that work and "
                       "dissipation of this leg may be wrong; take more steps in it (Load program/Legs)");
  else if (record.missing > noticeable * record.dissipation &&
           record.dissipation > least_loop * record.energy_scale())
    warnings.push_back("dissipated energy: " + to_text(std::round(10 * percent) / 10) +
                       " % of it are missing in the energy balance, because slip reverses within load steps; "
                       "take more steps in the legs that turn back (Load program/Legs)");
}

/// Friction that falls when a node begins to slip.
static void warn_of_fall(const RunRecord &record, std::vector<std::string> &warnings)
{
  constexpr double noticeable = 0.01, percent = 100;
  if (record.energy_of_fall > noticeable * record.dissipation)
    warnings.push_back("dissipated energy: up to " +
                       to_text(std::round(percent * record.energy_of_fall / record.dissipation)) +
                       " % of it was set free where friction fell as nodes began to slip (k in "
                       "Friction/Factor); in truth it "
                       "becomes motion and sound, which load steps do not know, and more of them do not "
                       "change it. Take it for the "
                       "error of the energy (docs/stability.md, \"Static and kinetic friction\")");
}

/// The factor of a step is that of the state before it: what changes meanwhile is an error of first order.
static void warn_of_friction(const Parameters &parameters, const RunRecord &record,
                             std::vector<std::string> &warnings)
{
  constexpr double most_change = 0.2, percent = 100; // docs/theory.md, section 3, "Friction with memory"
  if (parameters.friction.factor.is_static_and_kinetic())
    warn_of_fall(record, warnings);
  else if (record.change_of_factor.first > most_change)
    warnings.push_back("load step " + std::to_string(record.change_of_factor.second) +
                       ": Friction/Factor of a node is " +
                       to_text(std::round(percent * record.change_of_factor.first)) +
                       " % off that of the step before; a step is solved with the factor of the state before "
                       "it, which is good for changes up to 20 %. Take more load steps (Load program/Legs), "
                       "or a smaller Load program/Jump change of friction");
  const double growth =
      record.largest_factor.first / parameters.friction.factor.at_start(parameters.load.first_cycle());
  if (record.critical_friction.factor > 1 && record.critical_friction.factor <= growth)
    warnings.push_back(
        "load step " + std::to_string(record.largest_factor.second) + ": Friction/Factor has grown to " +
        to_text(record.largest_factor.first) + ", and " + describe(record.critical_friction) +
        ": a node may wedge, so that a load step may have several solutions; compare runs with "
        "other steps and methods before you trust a result");
}

std::vector<std::string> all_warnings(const Parameters &parameters, const RunRecord &record)
{
  constexpr double percent = 100;
  std::vector<std::string> warnings = parameter_warnings(parameters);
  for (std::string &warning : model_warnings(record))
    warnings.push_back(std::move(warning));
  warn_of_energy(record, warnings);
  warn_of_fast_wear(record, warnings);
  warn_of_friction(parameters, record, warnings);
  warn_of_large_motions(record, warnings);
  if (record.peaks.n_steps > 0 && record.peaks.contact_area.second == 0 && !parameters.obstacle.is_plane())
    warnings.emplace_back(
        "Load program: the bodies do not touch in any load step; let uz close the gap, or make "
        "Obstacle/Gap smaller");
  for (std::string &warning : zone_warnings(parameters, record.zones))
    warnings.push_back(std::move(warning));
  constexpr double most_of_change = 0.1; // docs/theory.md, section 3, "Gaps and friction that varies"
  if (record.slip_of_change.first > most_of_change)
    warnings.push_back(
        "load step " + std::to_string(record.slip_of_change.second) + ": a node slips by " +
        to_text(std::round(percent * record.slip_of_change.first)) +
        " % of the length over which gap or friction change there; both are taken at the reference position "
        "of the nodes, which is good for slips up to a tenth of this length");
  if (record.accuracy && !record.accuracy->is_reached())
    warnings.push_back("Mesh/Accuracy = " + to_text(record.accuracy->wanted) +
                       " % is not reached on the finest mesh, so that errors stay larger than wanted: " +
                       describe(*record.accuracy));
  if (record.steps && !record.steps->estimate.is_reached())
    warnings.push_back("Load program/Accuracy is not reached with 64 parts a step, or 1000000 in all, so "
                       "that errors stay larger than wanted: " +
                       describe(record.steps->estimate));
  return warnings;
}

std::string describe_seconds(const RunRecord &record)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "seconds: ";
  for (const auto &[name, phase] : phases)
  {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    text << words << " " << record.seconds.*phase << ", ";
  }
  text << "total " << record.total_seconds;
  return text.str();
}

std::string describe_energy(const RunRecord &record, const bool has_loads)
{
  std::ostringstream text;
  text << std::setprecision(4) << "energy: work of the held face " << (has_loads ? "and of loads " : "")
       << record.work << " N mm = dissipated " << record.dissipation << " + stored " << record.stored;
  if (record.into_wear != 0)
    text << " + gone with worn material " << record.into_wear;
  text << ", but for " << record.missing << " N mm (" << std::setprecision(2)
       << 100 * relative(record.missing, record.energy_scale())
       << " % of the largest energy) that the load steps leave open";
  return text.str();
}
} // namespace orthocone
