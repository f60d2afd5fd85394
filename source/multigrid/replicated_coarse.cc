// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "replicated_coarse.h"

#include <orthocone/base/ranks.h>

namespace orthocone
{
ReplicatedCoarse::ReplicatedCoarse(const Discretization &shared, const MeshOptions &mesh,
                                   const GeometryOptions &geometry, const MaterialOptions &material,
                                   const CoarseMethod method)
    : triangulation_(dealii::Triangulation<3>::limit_level_difference_at_vertices)
{
  MeshOptions options = mesh;
  options.degree = shared.scalar_fe().degree;
  options.quadrature_points = shared.n_quadrature_points();
  options.volumetric_quadrature = shared.volumetric_quadrature();
  triangulation_.copy_triangulation(shared.dof_handler().get_triangulation());
  whole_ = std::make_unique<Discretization>(triangulation_, options, geometry.top_face);
  solver_ = make_coarse_solver(*whole_, material, method);
  number(shared);
}

/// Relates the numbers of both spaces: the same cell has the same degrees of freedom in the same order.
void ReplicatedCoarse::number(const Discretization &shared)
{
  whole_dof_.resize(shared.n_free());
  std::vector<dealii::types::global_dof_index> here(shared.fe().n_dofs_per_cell()), there(here.size());
  for (const auto &cell : shared.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(here);
      Discretization::Cell(&triangulation_, cell->level(), cell->index(), &whole_->dof_handler())
          ->get_dof_indices(there);
      for (std::size_t i = 0; i < here.size(); ++i)
        if (const unsigned int dof = shared.local_dof(here[i]); dof < shared.n_free())
          whole_dof_[dof] = static_cast<unsigned int>(there[i]);
    }
}

Eigen::VectorXd ReplicatedCoarse::solve(Eigen::VectorXd forces) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(whole_->n_free());
  for (std::size_t i = 0; i < whole_dof_.size(); ++i)
    all[whole_dof_[i]] = forces[static_cast<Eigen::Index>(i)];
  sum_over_ranks(all.data(), static_cast<std::size_t>(all.size()));
  const Eigen::VectorXd solution = solver_->solve(std::move(all));
  for (std::size_t i = 0; i < whole_dof_.size(); ++i)
    forces[static_cast<Eigen::Index>(i)] = solution[whole_dof_[i]];
  return forces;
}
} // namespace orthocone
