// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/surface/model_symmetry.h>
#include <orthocone/surface/rigid_motion.h>

#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// The motions and forces that drive the held face to the end of a step, or to a point on the way there.
struct FaceTarget
{
  std::array<bool, n_rigid_components> by_force{};
  RigidMotion motion{};    ///< of the components that motions drive
  Wrench force{};          ///< on the held face, of the components that forces drive
  Eigen::VectorXd loads{}; ///< of the whole body: MPa, mm, K, and N where a surface finds its motion

  /// Whether a force drives a component.
  bool has_forces() const;
};

/// Motion and wrench of the held face at a moment, and the loads as FaceTarget has them.
struct FaceState
{
  RigidMotion motion{};
  Wrench wrench{};
  Eigen::VectorXd loads{};
};

/// One load step: what drives the held face at its end, and its place in the program.
struct LoadStep
{
  RigidMotion motion;       ///< of the held face at the end of the step, where motions drive it
  unsigned int number;      ///< counted from 1
  unsigned int step_of_leg; ///< counted from 1
  unsigned int cycle;       ///< counted from 1; 0 in the preload
  unsigned int phase;       ///< step of the cycle (or of the preload), counted from 0
  Wrench force{};           ///< on the held face at the end of the step, where forces drive it
  std::array<bool, n_rigid_components> by_force{};
  /// Components that the leg has taken over from the other kind: they start from where the face is when the
  /// leg begins, and `motion` or `force` has the target of the leg.
  std::array<bool, n_rigid_components> from_present{};
  double share = 1; ///< of the leg, up to the end of the step
  bool ends_cycle = false;
  std::vector<double> loads{};  ///< at the end of the step
  std::optional<double> time{}; ///< at the end of the step, s; nothing in a program without times
  double seconds = 0;           ///< that the step takes; 0 in a program without times, and in the preload
  /// The parts in which the step is solved; the last one ends where the step does. If empty, it is solved in
  /// one. Their `step_of_leg` and `phase` count parts.
  std::vector<LoadStep> parts{};

  /// The target at the end of the step, in a leg that began with the face in the state `begin`.
  FaceTarget target(const FaceState &begin) const;

  /// The same step with the motion and force of target().
  LoadStep resolved(const FaceState &begin) const;

  /// The driven components, such as "ux uy Fz", of those that `symmetry` and the held face leave.
  std::string driven(const ModelSymmetry &symmetry, TopFace top_face) const;
};
} // namespace orthocone
