// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What a state remembers of stick and slip. The law alone says of a node at the limit of friction that does
// not move neither that it sticks nor that it slips, and rounding would decide. Here such a node stays what
// it was. docs/theory.md, section 4, "Stick and slip at rest".
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// Slip (mm) that the tolerance of the solver may leave open where nodes of these compliances
/// (node_compliance(), mm/N) have the forces `force`: what is less is taken for none. It is the same in a
/// model of the whole body, of a half and of a quarter.
double unresolved_slip(const NodeVector &force, const Eigen::VectorXd &compliance, double tolerance);

/// Friction force (N) that would still fit before a node slips, in the direction of its friction force; 0
/// without friction or pressure.
double friction_reserve(const FrictionLaw &law, const Eigen::Vector3d &force);

/// What a step does to a node.
struct NodeStep
{
  NodeStatus before = NodeStatus::open;
  NodeStatus found = NodeStatus::open;              ///< by the law alone
  Eigen::Vector2d slip = Eigen::Vector2d::Zero();   ///< before the step, since the node stuck, mm
  Eigen::Vector2d change = Eigen::Vector2d::Zero(); ///< of the slip in the step, mm
  double gap = 0;                                   ///< before the step, mm; 0 where the node touched
  double reserve = 0;    ///< friction_reserve() behind the step times node_compliance(), mm
  double unresolved = 0; ///< unresolved_slip(), mm
};

/// Status behind the step: that before it where the node touches, is at the limit of friction and does not
/// move, all but for what is unresolved; else the one found.
NodeStatus status_behind(const NodeStep &step);

/// Slip behind the step since the node stuck or turned round, mm. It is a continuous function of reserve,
/// gap and change: what a node forgets when it sticks, turns round or has been open fades between once and
/// twice what is unresolved. Slip that turns aside by more than a right angle keeps 1 + cos(angle) of it.
Eigen::Vector2d slip_behind(const NodeStep &step);
} // namespace orthocone
