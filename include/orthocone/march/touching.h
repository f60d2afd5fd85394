// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>

namespace orthocone
{
/// Share of a step in which a node touches the obstacle. It is 1 where the node is closed at both ends of the
/// step, and 0 where it is open at both. A node that closes or opens within the step has one end with a gap
/// and one with a normal force: gap and force are taken as linear in between, with the force that would pull
/// the gap shut as its continuation. `compliance` is node_compliance() of the node, mm/N. docs/theory.md,
/// section 4.
double share_in_contact(const ContactState &before, const ContactState &after, Eigen::Index node,
                        double compliance);

/// Half the sum of the forces before and after, times the motion of the nodes that close or open while they
/// do not touch, N mm, of the modelled part. There is no force on this motion, but the trapezoidal rule for
/// the held face takes the force as if it grew over the whole step. The work of the face is that of the rule
/// and this. `opening` is node_compliance() of all nodes.
double work_without_contact(const ContactState &before, const ContactState &after,
                            const Eigen::VectorXd &opening);
} // namespace orthocone
