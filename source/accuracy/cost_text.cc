// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/cost_text.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
std::string describe(const Estimate &estimate, const ComputedSteps &n_steps, const MemoryLimit &limit,
                     const bool is_least)
{
  const char *const about = is_least ? "more than " : "about ";
  const auto counted = [](const double n) { return std::to_string(static_cast<unsigned long>(n)); };
  const bool has_jumps = n_steps.least < n_steps.most;
  std::ostringstream text;
  text << std::setprecision(2) << "memory         " << about << estimate.gigabytes << " GB; " << limit.source
       << " " << (limit.gigabytes < 10 ? limit.gigabytes : std::round(limit.gigabytes)) << " GB\n"
       << "time           " << about << estimate.seconds(n_steps.least) << " s";
  if (has_jumps)
    text << ", and " << estimate.seconds(n_steps.most) << " s if no cycle is jumped";
  text << ": set-up " << estimate.set_up_seconds << " s, "
       << (has_jumps ? counted(n_steps.least) + " to " : "") << counted(n_steps.most) << " load steps of "
       << estimate.step_seconds << " s" << (is_least ? "" : " (to a factor of 3)");
  return text.str();
}

std::string describe(const ModelSize &size)
{
  std::ostringstream text;
  text << std::setprecision(2) << "mesh           about " << size.cells << " cells\n"
       << "unknowns       about " << size.dofs << "\n"
       << "contact nodes  about " << size.contact_nodes;
  return text.str();
}
} // namespace orthocone
