// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/scene/computed_steps.h>
#include <orthocone/scene/legs.h>
#include <orthocone/scene/program_file.h>

#include "periods.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
// Each in a file of its name, which may be compiled together with this one.
// NOLINTBEGIN(readability-redundant-declaration)
Kind<StopRule> periodic_stop();
// NOLINTEND(readability-redundant-declaration)

template<>
std::vector<Kind<StopRule>> &kinds_of<StopRule>()
{
  static std::vector<Kind<StopRule>> kinds{periodic_stop()};
  return kinds;
}

namespace
{
double solved_parts(const std::vector<Leg> &legs)
{
  double n = 0;
  for (const Leg &leg : legs)
    n += static_cast<double>(leg.steps) * leg.parts;
  return n;
}

double least_computed_cycles(const LoadOptions &load, const WearOptions &wear)
{
  const double n = load.cycles;
  // Behind a jump of wear one cycle settles, and the next one has the rate of the next jump. The last cycle
  // is always computed, in wear as in a response that is periodic.
  if (wear.wears() && wear.largest_jump > 0)
    return std::min(n, 3.);
  if (load.jump_change_of_friction > 0) // likewise
    return n == 0 ? 0 : 1 + std::ceil(2 * (n - 1) / (load.jump_cycles + 2.));
  if (load.jump_when_periodic > 0)
    return n == 0 ? 0 : 1 + std::ceil((n - 1) / (load.jump_cycles + 1.));
  return n;
}

/// All digits of a number of steps.
std::string counted(const double n)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << n;
  return text.str();
}

/// Bounds what is computed, and what is counted: cycles that may be jumped are not computed.
void check_number_of_steps(const LoadOptions &load, const WearOptions &wear)
{
  LoadOptions all = load;
  all.jump_when_periodic = all.jump_change_of_friction = 0;
  const double n_all = least_computed_parts(all, WearOptions{}), n_least = least_computed_parts(load, wear);
  if (n_least <= most_solved_parts && n_all <= most_counted_parts)
    return;
  const auto has_parts = [](const std::vector<Leg> &legs)
  { return std::any_of(legs.begin(), legs.end(), [](const Leg &leg) { return leg.parts > 1; }); };
  const std::string unit =
      has_parts(load.preload) || has_parts(load.cycle_legs()) ? " parts of load steps" : " load steps";
  const std::string made = "Load program: Preload, Legs and Cycles = " + std::to_string(load.cycles) +
                           " make " + counted(n_all) + unit;
  if (!may_jump(load, wear))
    throw InputError(made + ": allowed are 1000000");
  if (n_least <= most_solved_parts)
    throw InputError(made + ": allowed are 4000000000 where cycles are jumped");
  throw InputError(made + ", of which at least " + counted(n_least) +
                   " are computed however many cycles are jumped: allowed are 1000000 computed ones");
}
} // namespace

unsigned int LoadOptions::n_cycles() const
{
  if (program_file.empty() || cycles != 1)
    return cycles;
  const auto last =
      std::find_if(rows.rbegin(), rows.rend(), [](const Leg &leg) { return leg.row->ends_cycle; });
  return last == rows.rend() ? 0 : last->row->cycle;
}

bool may_jump(const LoadOptions &load, const WearOptions &wear)
{
  return load.jump_when_periodic > 0 || load.jump_change_of_friction > 0 ||
         (wear.wears() && wear.largest_jump > 0);
}

double least_computed_parts(const LoadOptions &load, const WearOptions &wear)
{
  return solved_parts(load.preload) + least_computed_cycles(load, wear) * solved_parts(load.cycle_legs());
}

static void declare_jumps(LoadOptions &load, Section &section)
{
  section
      .add("Jump when periodic", load.jump_when_periodic, period_codec(),
           "Jumps cycles as soon as one ends as it began, in the measure of Stop when periodic: accumulated "
           "slip and dissipated energy grow in each jumped cycle as in that one. The last cycle is always "
           "computed. 0 = never.")
      .may_change_on_resume();
  section
      .add("Jump cycles", load.jump_cycles, count_codec(1, 1000000),
           "Largest number of cycles that are jumped before another one is computed, which shows whether the "
           "response is still periodic.")
      .may_change_on_resume();
  section.add(
      "Jump change of friction", load.jump_change_of_friction, number_codec(NumberRange{0, 0.5, true, true}),
      "Jumps cycles of friction with memory (Friction/Factor): the largest change of the factor at a "
      "node, relative to its value, in cycles that are jumped, each of which slips and dissipates like "
      "the last computed one. The program jumps fewer cycles where the factor changes differently from "
      "jump to jump. 0 = all cycles are computed.");
}

static void declare_loads(LoadOptions &load, Section &section)
{
  section
      .add("Loads", load.loads, loads_codec(),
           "Loads beside the motion and force of the held face: 'NAME: KIND on SURFACE along x ; ...'. Legs "
           "drive them by their names, as in 'Fz -500 bulk 100 : 10', and history.csv lists each load and "
           "its conjugate. Kinds: " +
               help_of_load_kinds() +
               ". Surfaces are those of Supports, and may be several with spaces between; with 'lower' in "
               "front they are those of the lower body.")
      .read_first()
      .also_called({"pressure", "traction", "bulk stress", "neumann", "temperature"});
}

void declare_load(LoadOptions &load, Section &section)
{
  const std::string unit_of_legs = "(mm, degrees, N, N mm : steps)";
  const Condition has_legs{[&load] { return load.program_file.empty(); }, [&load]
                           { return "Load program/Program file = " + shown_path(load.program_file); }};
  declare_loads(load, section);
  section
      .add("Preload", load.preload, legs_codec(load.loads),
           "Legs, in the form of the entry Legs, that are passed through once before the cycles.")
      .unit(unit_of_legs);
  section
      .add("Legs", load.legs, legs_codec(load.loads),
           "Legs of a cycle, each of which moves the held face from where it is to (ux, uy, uz) in equal "
           "load steps. With names, as in 'Fz -2e5 rz 0.5 : 10', a leg drives these components by a motion "
           "or by a force, and the others keep the motion or force that they have. ': 10 * 4' solves each of "
           "10 steps in 4 parts, of which only the last is written.")
      .unit(unit_of_legs)
      .only_if(has_legs)
      .also_called({"force", "normal force", "load", "displacement", "amplitude", "steps"});
  declare_program_file(load, section);
  section
      .add("Accuracy", load.accuracy, percentage_codec(NumberRange{0.01, 50, true, true}),
           "Error, in percent, that the size of the load steps may cause in the quantities of Mesh/Accuracy "
           "and in the work of the held face in the first cycle: the program divides the steps of each leg "
           "into as many parts as this needs by its estimate. States are written at the steps of the legs "
           "only. 0 = the legs are taken as they are.")
      .unit("%");
  section.add("Cycles", load.cycles, count_codec(0, 1000000), "How many times the legs are passed through.")
      .may_change_on_resume();
  for (const auto &rule : load.stops)
    rule->declare(section);
  declare_jumps(load, section);
}

void check_load(const LoadOptions &load, const WearOptions &wear)
{
  if (!load.program_file.empty() && load.accuracy != 0)
    throw InputError(
        "Load program/Accuracy = " + to_text(load.accuracy) +
        " % with Load program/Program file: allowed is 0; Steps per row divides the rows of a file");
  if (load.preload.empty() && load.cycle_legs().empty())
    throw InputError(
        "Load program/Legs is empty and Load program/Preload is empty: allowed is at least one leg, "
        "such as '0 0 -0.1 : 5'");
  if (load.preload.empty() && load.cycles == 0)
    throw InputError(
        "Load program/Cycles = 0 and Load program/Preload is empty: allowed is at least one cycle or "
        "a preload");
  check_number_of_steps(load, wear);
  for (const auto &rule : load.stops)
    rule->check(load, wear);
}

void warn_of_periods(const LoadOptions &load, const double tolerance, std::vector<std::string> &warnings)
{
  for (const auto &rule : load.stops)
    rule->warn(tolerance, warnings);
  warn_of_period("Jump when periodic", load.jump_when_periodic, tolerance, warnings);
}
} // namespace orthocone
