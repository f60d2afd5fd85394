// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/materials/material_law.h>
#include <orthocone/surface/rigid_motion.h>

#include <Eigen/Dense>

#include <vector>

namespace orthocone
{
/// What the fields of a body are made of.
struct Deformation
{
  Eigen::VectorXd displacement; ///< of all degrees of freedom, mm
  Strain free_strain{};         ///< causes no stress
  RigidMotion motion{};         ///< of the held face, which `displacement` contains
  /// On the body at its contact nodes, in global axes, MPa; with none no surface has a known traction.
  std::vector<Eigen::Vector3d> tractions{};
};
} // namespace orthocone
