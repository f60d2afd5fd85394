// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <optional>

namespace orthocone
{
/// What fretting tests read off the loop of tangential force over tangential motion; docs/theory.md, section
/// 6, has definitions and sources. What a loop does not have is nothing.
struct LoopFigures
{
  double stroke = 0;                          ///< between the ends of the motion, mm
  double peak_force = 0;                      ///< largest tangential force along the stroke, N
  std::optional<double> slip_ratio{};         ///< width at zero force over the stroke
  std::optional<double> energy_ratio{};       ///< area of the loop over 2 peak_force stroke
  std::optional<double> friction_largest{};   ///< peak_force over the normal force at that moment
  std::optional<double> friction_energy{};    ///< area over twice normal force and width
  std::optional<double> friction_geometric{}; ///< tangential over normal force in the middle of the stroke
  std::optional<double> stiffness{};          ///< slope behind the reversals, N/mm
};

/// A row of cycles.csv: a completed cycle, or several that are jumped.
struct CycleRow
{
  unsigned int cycle = 0;          ///< the last of the row, counted from 1
  unsigned int n_cycles = 1;       ///< that the row stands for
  unsigned int last_step = 0;      ///< number of the last step of `cycle`
  double peak_force_z = 0;         ///< when the total force is largest, N
  double force_z = 0;              ///< at the end, N
  double max_slip = 0;             ///< largest in the cycle, mm
  double max_accumulated_slip = 0; ///< at the end, since the start of the run, mm
  double accumulated_slip = 0;     ///< largest of a node in the cycles of the row, mm
  double dissipation = 0;          ///< in the cycles of the row, N mm
  double total_dissipation = 0;    ///< at the end, since the start of the run, N mm
  double work = 0;                 ///< of the upper face in the cycles of the row, N mm
  double into_wear = 0;            ///< the part of it that leaves the body with worn material, N mm
  double missing = 0;              ///< what the steps leave of the energy balance, N mm
  double change = 0;               ///< change_of_state() of the (last computed) cycle
  unsigned int iterations = 0;     ///< of the contact solver
  double worn_volume = 0;          ///< at the end, mm^3
  double max_wear_depth = 0;       ///< at the end, mm
  double wear_error = 0;           ///< WearMemory::error at the end, mm^3
  LoopFigures loop{};              ///< of the (last computed) cycle
  double worst_energy = 0;         ///< largest dissipation per area of a node in the cycles of the row, N/mm
  double least_factor = 0;         ///< of friction over nodes in contact, in the cycle (FactorRange)
  double mean_factor = 0;          ///< in the last step of the cycle that has contact; 0 without contact
  double largest_factor = 0;       ///< in the cycle
  double factor_error = 0;         ///< FrictionJumpMemory::error at the end
  double worst_wear = 0;           ///< largest depth that a node loses in the cycles of the row, mm
};
} // namespace orthocone
