// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

#include <optional>

namespace orthocone
{
/// A change with the displacement that it causes, which a solver with a dense compliance leaves to others.
ContactChange with_displacement(const ContactStep &step, ContactChange change);

/// The node that holds most of the natural map: nine tenths of its square or more. Nothing if no node does.
std::optional<Eigen::Index> hardest_node(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                         const NodeVector &displacement);

/// Newton's `change` of `unknowns`, altered so that one node obeys its law exactly, while all others obey
/// their linearized `conditions`: the law of a node that changes its status to and fro between full steps has
/// no use of a slope. The compliance of the node, with the others' conditions, takes three solutions. Nothing
/// if it is singular. `change` must have its displacement (mm).
std::optional<ContactChange> with_exact_node(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                             const NodeVector &displacement,
                                             const ContactConditions &conditions,
                                             const ConditionSolver &solver, ContactChange change,
                                             Eigen::Index node);
} // namespace orthocone
