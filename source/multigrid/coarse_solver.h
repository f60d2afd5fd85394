// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "node_relation.h"

#include <orthocone/body/fe/displacement_space.h>

#include <Eigen/Dense>

#include <memory>
#include <vector>

namespace orthocone
{
/// Solver for the coarsest mesh of a V-cycle, with the relations of its contact nodes.
class CoarseSolver
{
public:
  virtual ~CoarseSolver() = default;

  /// `relations` has one relation for each contact node; if it is empty, contact holds nothing.
  virtual void hold(const std::vector<NodeRelation> &relations) = 0;

  /// Displacement (mm) of the free degrees of freedom by forces (N) on them, exact or close to it. Forces in
  /// directions that contact holds count through friction, by the relations' coupling.
  virtual Eigen::VectorXd solve(Eigen::VectorXd forces) const = 0;
};

enum class CoarseMethod : unsigned char
{
  by_size, ///< factorized up to a size
  factorized,
  algebraic,
};

/// The solver of a mesh that no other process shares; `space` must outlive it. It is exact where it is
/// factorized; a large mesh is solved by one V-cycle of aggregates (Trilinos ML). Throws as StiffnessFactor
/// does, or SolveError where nodes cannot be aggregated.
std::unique_ptr<CoarseSolver> make_coarse_solver(const Discretization &space, const MaterialOptions &material,
                                                 CoarseMethod method);

/// The solver of a mesh without halved cells that several processes share: each of them solves the whole
/// mesh, so that none waits for the answer of another. `shared` need not outlive it.
std::unique_ptr<CoarseSolver> make_shared_coarse_solver(const Discretization &shared, const MeshOptions &mesh,
                                                        const HeldSurfaces &held,
                                                        const MaterialOptions &material, CoarseMethod method);
} // namespace orthocone
