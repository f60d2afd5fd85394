// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>
#include <orthocone/surface/mirror_images.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace orthocone
{
/// The contact problem of a load step by itself, as a value: the data of a ContactStep and its ContactSystem.
/// It has n nodes, in local axes (normal, x, y).
struct ContactProblem
{
  Eigen::MatrixXd w;                     ///< 3 n x 3 n, symmetric, mm/N
  Eigen::VectorXd q;                     ///< 3 n, mm
  std::vector<OrthotropicFriction> laws; ///< n
  Eigen::MatrixXd face;                  ///< 3 n x m: FreeFace's motions; no columns: no face is free
  Eigen::VectorXd balance{};             ///< m: what face^T r must be, N
  std::string title{};
  MirrorDifference mirrored{}; ///< of the W in the file, whose symmetric part w is
};

/// Forces and displacements that solve a problem.
struct ProblemSolution
{
  Eigen::VectorXd force;        ///< 3 n, N
  Eigen::VectorXd displacement; ///< 3 n, mm
  Eigen::VectorXd motions{};    ///< m, of the face
  double residual = 0;          ///< ContactStep::residual(), at which the solver stopped
};
} // namespace orthocone
