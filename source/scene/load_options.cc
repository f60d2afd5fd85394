// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/scene/computed_steps.h>
#include <orthocone/scene/legs.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
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
  if (wear.law != WearKind::none && wear.largest_jump > 0)
    return std::min(n, 3.);
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
  all.jump_when_periodic = 0;
  const double n_all = least_computed_parts(all, WearOptions{}), n_least = least_computed_parts(load, wear);
  if (n_least <= most_solved_parts && n_all <= most_counted_parts)
    return;
  const auto has_parts = [](const std::vector<Leg> &legs)
  { return std::any_of(legs.begin(), legs.end(), [](const Leg &leg) { return leg.parts > 1; }); };
  const std::string unit =
      has_parts(load.preload) || has_parts(load.legs) ? " parts of load steps" : " load steps";
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

bool may_jump(const LoadOptions &load, const WearOptions &wear)
{
  return load.jump_when_periodic > 0 || (wear.law != WearKind::none && wear.largest_jump > 0);
}

double least_computed_parts(const LoadOptions &load, const WearOptions &wear)
{
  return solved_parts(load.preload) + least_computed_cycles(load, wear) * solved_parts(load.legs);
}

void declare_load(LoadOptions &load, Section &section)
{
  section.add("Preload", load.preload, legs_codec(), "Legs passed through once, before the cycles.");
  section
      .add(
          "Legs", load.legs, legs_codec(),
          "Legs of a cycle: the upper face moves to (ux, uy, uz) in equal steps, from where it was. Named "
          "components, as in 'Fz -2e5 rz 0.5 : 10', are driven by a motion or by a force; the others keep "
          "what they have. ': 10 * 4' solves each of 10 steps in 4 parts, of which only the last is written.")
      .also_called({"force", "normal force", "load", "displacement", "amplitude", "steps"});
  section.add(
      "Accuracy", load.accuracy, percentage_codec(NumberRange{0.01, 50, true, true}),
      "Largest wanted error by the size of the load steps, of the quantities of Mesh/Accuracy and of the "
      "work "
      "of the upper face in the first cycle: the program divides the steps of each leg into as many parts as "
      "it estimates to need. States are written at the steps of the legs. 0 = the legs are taken as they "
      "are.");
  section.add("Cycles", load.cycles, count_codec(0, 1000000), "How many times the legs are passed through.")
      .may_change_on_resume();
  const Codec<double> share = number_codec(NumberRange{0, 1, true, false});
  section
      .add("Stop when periodic", load.stop_when_periodic, share,
           "The run is complete as soon as a cycle ends as it began: nodal forces within this share of the "
           "largest one, displacements within this share of the largest motion of the upper face; 0 = never.")
      .may_change_on_resume();
  section
      .add("Jump when periodic", load.jump_when_periodic, share,
           "When a cycle ends as it began, in the same measure, the next ones are not computed: accumulated "
           "slip and dissipated energy grow as in this one; 0 = never. The last cycle is always computed.")
      .may_change_on_resume();
  section
      .add("Jump cycles", load.jump_cycles, count_codec(1, 1000000),
           "Most cycles that are jumped before another one is computed, which shows whether the response is "
           "still periodic.")
      .may_change_on_resume();
}

void check_load(const LoadOptions &load, const WearOptions &wear)
{
  if (load.preload.empty() && load.legs.empty())
    throw InputError(
        "Load program/Legs is empty and Load program/Preload is empty: allowed is at least one leg, "
        "such as '0 0 -0.1 : 5'");
  if (load.preload.empty() && load.cycles == 0)
    throw InputError(
        "Load program/Cycles = 0 and Load program/Preload is empty: allowed is at least one cycle or "
        "a preload");
  check_number_of_steps(load, wear);
  if (load.stop_when_periodic > 0 && load.jump_when_periodic > 0)
    throw InputError("Load program/Stop when periodic = " + to_text(load.stop_when_periodic) +
                     " and Load program/Jump when periodic = " + to_text(load.jump_when_periodic) +
                     ": allowed is one of them, the other 0 (a run that stops has nothing to jump)");
}

namespace
{
/// Forces may differ by a hundred times the residual that the solver leaves: W is that ill-conditioned.
void warn_of_unresolved_period(const std::string &entry, const double bound, const double tolerance,
                               std::vector<std::string> &warnings)
{
  constexpr double resolved = 100;
  if (bound > 0 && bound < resolved * tolerance)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       " is less than a hundred times Contact solver/Tolerance = " + to_text(tolerance) +
                       ": what the solver leaves may hide, or look like, a change from cycle to cycle");
}

/// Cycles that differ count as alike, so that what is jumped or left out has errors of about this size.
void warn_of_loose_period(const std::string &entry, const double bound, std::vector<std::string> &warnings)
{
  constexpr double most = 1e-3, percent = 100;
  if (bound > most)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       ": cycles count as alike whose forces differ by " + to_text(percent * bound) +
                       " % of the largest; slip and dissipation of the later ones may be as wrong, "
                       "1e-3 and less keeps them");
}
} // namespace

void warn_of_periods(const LoadOptions &load, const double tolerance, std::vector<std::string> &warnings)
{
  warn_of_unresolved_period("Stop when periodic", load.stop_when_periodic, tolerance, warnings);
  warn_of_unresolved_period("Jump when periodic", load.jump_when_periodic, tolerance, warnings);
  warn_of_loose_period("Stop when periodic", load.stop_when_periodic, warnings);
  warn_of_loose_period("Jump when periodic", load.jump_when_periodic, warnings);
}
} // namespace orthocone
