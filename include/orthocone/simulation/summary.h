// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/load_program.h>
#include <orthocone/simulation/model_choice.h>
#include <orthocone/simulation/totals.h>

#include <string>
#include <utility>

namespace orthocone
{
/// Wall time of the phases of a run, in seconds.
struct PhaseSeconds
{
  double mesh = 0; ///< with the numbering of the unknowns
  double assembly = 0;
  double factorization = 0;
  double condensation = 0;
  double contact = 0;
  double output = 0;
};

/// Largest values over the run and the steps that had them.
struct Peaks
{
  void consider(unsigned int step, const Totals &totals);

  std::pair<double, unsigned int> slip{0, 0};     ///< mm
  std::pair<double, unsigned int> pressure{0, 0}; ///< MPa
  std::pair<double, unsigned int> force_z{0, 0};  ///< N
};

/// Everything that summary.json tells.
struct Summary
{
  std::string status = "running"; ///< or "complete", or why not
  const Parameters &parameters;
  const ModelChoice &model;
  const Discretization &discretization;
  unsigned int n_steps;
  unsigned int n_solved = 0;
  unsigned int n_iterations = 0;
  double largest_residual = 0;
  double total_dissipation = 0; ///< N mm
  Peaks peaks{};
  PhaseSeconds seconds{};
  double total_seconds = 0;
};

/// Text of summary.json.
std::string summary_json(const Summary &summary);

/// The resolved model in a few lines: kind, cells, unknowns, contact nodes, steps.
std::string describe_model(const Parameters &parameters, const ModelChoice &model,
                           const Discretization &discretization, unsigned int n_steps);
} // namespace orthocone
