// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_solver.h"
#include "level.h"

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// One V-cycle over the mesh of a body and the meshes before its refinements, with trilinear elements on the
/// coarsest of them. It is close to the inverse of the stiffness with the relations of contact, which every
/// level has.
class VCycle
{
public:
  /// `space` must outlive this object.
  VCycle(const Discretization &space, const MeshOptions &mesh, const GeometryOptions &geometry,
         const MaterialOptions &material, CoarseMethod on_coarsest = CoarseMethod::by_size);
  ~VCycle();
  VCycle(const VCycle &) = delete; // levels refer to their spaces
  VCycle &operator=(const VCycle &) = delete;

  /// Sets the relations of the contact nodes of the finest level. Coarser nodes are held as the nearest finer
  /// ones.
  void hold(const std::vector<NodeRelation> &relations);
  void release() { hold({}); }

  /// Displacement (mm) by forces (N), both of all degrees of freedom, and zero where they are held.
  void vmult(BodyVector<double> &displacement, const BodyVector<double> &forces) const;

  /// Displacements of the free degrees of freedom of the level below the finest one, interpolated to the
  /// finest one.
  Eigen::VectorXd prolonged(const Eigen::VectorXd &coarser) const;

  /// How often vmult() was called.
  unsigned long n_cycles() const { return n_cycles_; }

private:
  struct Mesh; ///< of a level that is not the finest
  using Vector = Level::Vector;
  using Transfer = dealii::MGTwoLevelTransfer<3, Vector>;

  const Discretization &space_of(std::size_t level) const;
  void connect(std::size_t level);
  std::vector<NodeRelation> coarser(std::size_t level, const std::vector<NodeRelation> &fine) const;
  void solve(std::size_t level, Vector &displacement, const Vector &forces) const;
  void solve_coarsest(Vector &displacement, const Vector &forces) const;

  /// Vectors of the levels.
  struct Workspace
  {
    Vector forces, displacement, residual;
  };

  const Discretization &finest_;
  std::vector<std::unique_ptr<const Mesh>> meshes_;  ///< of all levels but the finest, from the coarsest on
  std::unique_ptr<CoarseSolver> coarsest_;           ///< level 0
  std::vector<std::unique_ptr<Level>> levels_;       ///< from level 1 on
  std::vector<std::unique_ptr<Transfer>> transfers_; ///< from the level below, from level 1 on
  std::vector<std::vector<std::size_t>>
      nearest_; ///< for every node of level l the nearest one of level l + 1
  mutable std::vector<Workspace> work_;
  mutable unsigned long n_cycles_ = 0;
};
} // namespace orthocone
