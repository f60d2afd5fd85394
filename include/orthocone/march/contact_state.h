// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>
#include <orthocone/march/wear.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>
#include <orthocone/surface/rigid_motion.h>

namespace orthocone
{
/// All that the next step needs to know of the past, and all that output reads. Vectors have one number, or
/// three in local axes, for each node of the model.
struct ContactState
{
  /// The state before the first step, on the plane.
  explicit ContactState(Eigen::Index n_nodes)
      : ContactState(NodeVector(NodeVector::Zero(3 * n_nodes)))
  {
  }

  /// The state before the first step, without loads. `gaps` is the displacement relative to the obstacle (3
  /// n, mm).
  explicit ContactState(const NodeVector &gaps, Eigen::Index n_loads = 0);

  Eigen::Index n_nodes() const { return accumulated_slip.size(); }

  unsigned int step = 0;
  RigidMotion motion{};  ///< of the held face
  Eigen::VectorXd loads; ///< as Scene takes them: with the motion of surfaces that find it
  double work = 0; ///< of face and loads over all solved parts of steps (docs/theory.md, section 4), N mm
  FaceState leg_begin{};             ///< the face when the present leg began
  NodeVector force;                  ///< of the plane on the body, N
  NodeVector displacement;           ///< relative to the plane (gap, slip), mm
  Eigen::VectorXd accumulated_slip;  ///< path length of the slip in contact, mm
  Eigen::VectorXd dissipated_energy; ///< N mm
  Eigen::VectorXd wear_depth;        ///< worn off since the start, mm
  Eigen::VectorXd found_depth;       ///< worn before the last step: `displacement` is relative to it, mm
  Eigen::VectorXd slip_at_stick;     ///< slip (x, y) where the node last stuck or turned round, mm
  std::vector<NodeStatus> status;
  // Of friction with memory; empty without it, or where its factor does not depend on the speed.
  Eigen::VectorXd friction_factor{}; ///< of the last step
  Eigen::VectorXd slip_speed{};      ///< in the last step, mm/s
};

/// The friction law of a node in the last step.
FrictionLaw law_of(const ContactSystem &system, const ContactState &state, Eigen::Index node);

/// Displacement of a state (3 n, mm) relative to the obstacle, without the room that wear has made: the gap
/// before the first step, and the motion of the nodes since.
NodeVector unworn_displacement(const ContactState &state);

/// How far a node has slipped since it last stuck or turned round, mm.
double slip_since_stick(const ContactState &state, Eigen::Index node);

/// Work of friction, N mm, along a node's slip `change` (mm) while its tangential force goes from `before` to
/// `after` (N); not negative if `after` opposes the slip. docs/theory.md, section 4.
double dissipation(const Eigen::Vector2d &before, const Eigen::Vector2d &after,
                   const Eigen::Vector2d &change);

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

/// Enters the solution of a step into the state: displacement, status, accumulated slip, wear, and
/// dissipation. This is the work of the mean friction force, or of the final one where the slip reverses. A
/// node that closes or lifts off within the step counts for the share in which it touches (docs/theory.md,
/// section 4). The work of the face is not entered. `opening` is node_compliance() of all nodes, `tolerance`
/// the one of the solver: what it leaves open decides neither on stick nor on slip (slip_memory.h).
void advance(ContactState &state, const ContactStep &step, const Eigen::VectorXd &opening,
             const Eigen::VectorXd &unknowns, const RigidMotion &motion, const WearLaw &wear = {},
             double tolerance = 0);
} // namespace orthocone
