// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

#include <optional>
#include <vector>

namespace orthocone
{
/// Newton's `change` of `unknowns`, altered so that some nodes obey their laws exactly, while all others obey
/// their linearized `conditions`: the law of a node that changes its status to and fro between full steps has
/// no use of a slope. The compliance of these nodes, with the others' conditions, takes three solutions a
/// node. Nothing if no forces are found that obey the laws. `change` must have its displacement (mm).
std::optional<ContactChange> with_exact_nodes(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                              const NodeVector &displacement,
                                              const ContactConditions &conditions,
                                              const ConditionSolver &solver, ContactChange change,
                                              const std::vector<Eigen::Index> &nodes);
} // namespace orthocone
