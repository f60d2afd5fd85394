// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/accuracy/cost_model.h>

#include <string>

namespace orthocone
{
/// Numbers of steps that a run may compute, each counted with all its parts: all of them where no cycle is
/// jumped, and fewer where cycles are.
struct ComputedSteps
{
  double least, most;
};

/// The estimate in two lines, with the available memory. `is_least`: it is a lower bound.
std::string describe(const Estimate &estimate, const ComputedSteps &n_steps, const MemoryLimit &limit,
                     bool is_least);

/// Cells, unknowns and contact nodes in lines.
std::string describe(const ModelSize &size);
} // namespace orthocone
