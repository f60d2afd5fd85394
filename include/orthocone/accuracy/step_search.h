// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Accuracy on demand, of the load steps: each leg is solved in finer and finer parts until what halving them
// changes shows that the quantities that users look at are accurate enough.
#pragma once

#include <orthocone/accuracy/accuracy.h>
#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/options.h>

#include <functional>
#include <string>

namespace orthocone
{
/// Takes lines for screen and log.
using Reporter = std::function<void(const std::string &)>;

/// The errors of load steps, and of the tolerance of the contact solver.
struct StepAccuracy
{
  AccuracyEstimate estimate{};
  Quantities solver{}; ///< changes by ten times the tolerance, percent
};

/// Load program with its steps in parts.
struct DividedSteps
{
  LoadOptions load; ///< Accuracy = 0
  StepAccuracy accuracy{};
};

/// Divides the steps of each leg into parts until the estimated errors of all quantities are at most `wanted`
/// percent, or a step has 64 parts. What halving a leg's parts changes is taken for half of its error, or for
/// less where the halving before shows that they converge more slowly; errors of legs add up. All is measured
/// on a mesh that is no finer than the run's. docs/accuracy.md, "A number: `Load program/Accuracy`". Throws
/// std::runtime_error if a step is not solved.
DividedSteps find_steps(const Parameters &parameters, const ModelChoice &choice, double wanted,
                        const Reporter &report);
} // namespace orthocone
