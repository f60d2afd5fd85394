// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <functional>

namespace orthocone
{
/// A square matrix that is known by its products alone, and something close to its inverse. Single precision
/// is enough for inexact Newton steps, whose errors the next one corrects.
struct LinearMap
{
  using Function = std::function<Eigen::VectorXf(const Eigen::VectorXf &)>;

  Eigen::Index size;
  Function apply;
  Function precondition;
};

struct KrylovSolution
{
  Eigen::VectorXf unknowns{};
  bool converged = true;
  Eigen::Index iterations = 0;
};

/// Solution of map x = right_side by preconditioned GMRES (Eigen's), until the preconditioned residual is
/// `tolerance` times the first one, or after `most` iterations, whatever has been reached. Not finite if the
/// products are not.
KrylovSolution solve_gmres(const LinearMap &map, const Eigen::VectorXf &right_side, float tolerance,
                           Eigen::Index most);
} // namespace orthocone
