// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "line_search.h"

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Whether a step of this length from `start` was worth it.
bool reduces(const Iterate &trial, const Iterate &start, const double length)
{
  constexpr double sufficient_decrease = 1e-4;
  return trial.linearization.error <= (1 - sufficient_decrease * length) * start.linearization.error;
}
} // namespace

Iterate line_search(Map *const map, const ContactStep &step, const Iterate &start, const VectorXd &change,
                    const double smallest_step, const double rho_factor)
{
  const NodeVector moved = step.change_of_displacement(change);
  for (double length = 1;; length /= 2)
  {
    Iterate trial(map, step, start.unknowns + length * change, start.displacement + length * moved,
                  rho_factor);
    if (reduces(trial, start, length) || length <= smallest_step)
      return trial;
  }
}
} // namespace orthocone
