// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/answers.h>

#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
void add(const std::string &name, const std::string &words, const Peaks::Peak &peak, const std::string &unit,
         std::vector<Answer> &answers)
{
  if (peak.second != 0)
    answers.push_back({name, words, peak.first, unit, peak.second});
}

/// The force along z is the normal force where that is the normal. On surfaces with other normals forces may
/// cancel, as around a shaft.
void add_forces(const Summary &summary, std::vector<Answer> &answers)
{
  constexpr double rounding = 1e-9;
  const Peaks &peaks = summary.record.peaks;
  if (summary.parameters.obstacle.has_normal_z())
  {
    add("normal_force", "largest normal force", peaks.force_z, "N", answers);
    add("tangential_force", "largest tangential force", peaks.tangential_force, "N", answers);
    add("mu_eff", "largest tangential / normal force", peaks.friction, "", answers);
    return;
  }
  const double least = rounding * peaks.pressure.first * peaks.contact_area.first;
  if (peaks.force_z.first > least)
    add("force_z", "largest force along z", peaks.force_z, "N", answers);
  if (peaks.tangential_force.first > least)
    add("force_xy", "largest force across z", peaks.tangential_force, "N", answers);
}

/// Areas are compared when the tangential force is largest, for then the stick zone is smallest.
void add_areas(const Peaks &peaks, std::vector<Answer> &answers)
{
  add("contact_area", "largest contact area", peaks.contact_area, "mm^2", answers);
  if (peaks.tangential_force.second == 0)
    return;
  add("sheared_contact_area", "contact area at the largest tangential force", peaks.sheared_contact, "mm^2",
      answers);
  add("stick_area", "stick area at the largest tangential force", peaks.sheared_stick, "mm^2", answers);
}

void add_energies(const Summary &summary, std::vector<Answer> &answers)
{
  const CycleRow &row = summary.cycles.row;
  const Totals &totals = summary.totals;
  if (totals.total_dissipation > 0)
    answers.push_back({"dissipation", "energy dissipated by friction", totals.total_dissipation, "N mm", 0});
  if (summary.cycles.n_completed > 0 && row.cycle == summary.cycles.n_completed && row.dissipation > 0)
    answers.push_back({"last_cycle_energy",
                       "part of it in the last cycle (" + std::to_string(row.cycle) + ")",
                       row.dissipation / row.n_cycles, "N mm", row.last_step});
  if (totals.max_dissipated_energy > 0)
    answers.push_back(
        {"energy_per_area", "most dissipated energy per area", totals.max_dissipated_energy, "N/mm", 0});
}
} // namespace

std::vector<Answer> answers(const Summary &summary)
{
  const Peaks &peaks = summary.record.peaks;
  const Totals &totals = summary.totals;
  std::vector<Answer> answers;
  add_forces(summary, answers);
  add_areas(peaks, answers);
  add("pressure", "largest pressure", peaks.pressure, "MPa", answers);
  add("slip_of_contact", "largest slip of nodes in contact", peaks.slip, "mm", answers);
  add_energies(summary, answers);
  if (totals.max_wear_depth > 0)
  {
    answers.push_back({"wear_depth", "largest wear depth", totals.max_wear_depth, "mm", 0});
    answers.push_back({"worn_volume", "worn volume", totals.worn_volume, "mm^3", 0});
  }
  return answers;
}

std::string describe(const std::vector<Answer> &answers)
{
  constexpr int width_of_words = 46;
  std::ostringstream text;
  for (const Answer &answer : answers)
  {
    std::ostringstream value;
    value << std::setprecision(4) << answer.value << (answer.unit.empty() ? "" : " ") << answer.unit;
    text << (&answer == answers.data() ? "" : "\n") << std::left << std::setw(width_of_words) << answer.words;
    if (answer.step == 0)
      text << value.str();
    else
      text << std::setw(16) << value.str() << " (step " << answer.step << ")";
  }
  return text.str();
}
} // namespace orthocone
