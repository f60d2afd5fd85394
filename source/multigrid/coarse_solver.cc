// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "coarse_solver.h"

#include "node_stiffness.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/multigrid/multigrid_body.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>
#include <array>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
std::vector<unsigned int> answering_dofs(const std::vector<ContactNode> &nodes,
                                         const std::vector<NodeRelation> &relations)
{
  std::vector<unsigned int> dofs;
  for (std::size_t i = 0; i < relations.size(); ++i)
    if (relations[i].hold != Hold::nothing)
      for (unsigned int d = 0; d < 3; ++d)
        if (nodes[i].is_free[d])
          dofs.push_back(nodes[i].dofs[d]);
  return dofs;
}

/// Solver for a coarsest mesh that is small. It is exact: the stiffness is factorized once, and held
/// directions are a small dense system in its compliance.
class FactorizedCoarse : public CoarseSolver
{
public:
  /// Throws as StiffnessFactor does.
  FactorizedCoarse(const Discretization &space, const MaterialOptions &material)
      : space_(space),
        factor_(Stiffness(space, material).matrix(), space.n_interior()),
        compliance_(factor_.trailing_inverse())
  {
  }

  void hold(const std::vector<NodeRelation> &relations) override
  {
    answering_ = answering_dofs(space_.contact_surface().nodes, relations);
    const auto n = static_cast<Index>(answering_.size());
    if (n == 0)
      return;
    MatrixXd compliance(n, n);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i)
        compliance(i, j) =
            compliance_(answering_[i] - space_.n_interior(), answering_[j] - space_.n_interior());
    const MatrixXd of_force = set_equations(relations, compliance.diagonal().cwiseInverse());
    system_.compute(of_force + of_displacement_ * compliance);
  }

  VectorXd solve(VectorXd forces) const override
  {
    const auto n = static_cast<Index>(answering_.size());
    if (n == 0)
      return factor_.solve(forces);
    // The displacement without the reaction of contact, then with it.
    const VectorXd free = factor_.solve(forces);
    VectorXd moved(n);
    for (Index i = 0; i < n; ++i)
      moved[i] = free[answering_[i]];
    const VectorXd answer = -system_.solve(of_displacement_ * moved);
    for (Index i = 0; i < n; ++i)
      forces[answering_[i]] += answer[i];
    return factor_.solve(forces);
  }

private:
  MatrixXd set_equations(const std::vector<NodeRelation> &relations, const VectorXd &stiffness);

  const Discretization &space_;
  StiffnessFactor factor_;
  MatrixXd compliance_; ///< of the contact unknowns, mm/N
  // Contact reacts with forces f at these degrees of freedom, such that of_force f + of_displacement u = 0.
  std::vector<unsigned int> answering_;
  MatrixXd of_displacement_;
  Eigen::PartialPivLU<MatrixXd> system_;
};

/// With W the compliance of the contact unknowns and u_0 their displacement without contact, contact reacts
/// with f = -(A + B W)^-1 B u_0, where A f + B u = 0 are the relations: u = u_0 + W f.
/// Sets of_displacement_ and returns of_force. In held directions the displacement is zero, in units of
/// force, so that all equations have one size. In the others friction resists: f_t + coupling f_z + robin u_t
/// = 0.
MatrixXd FactorizedCoarse::set_equations(const std::vector<NodeRelation> &relations,
                                         const VectorXd &stiffness)
{
  const auto &nodes = space_.contact_surface().nodes;
  MatrixXd of_force = MatrixXd::Zero(stiffness.size(), stiffness.size());
  of_displacement_ = of_force;
  Index next = 0;
  for (std::size_t i = 0; i < relations.size(); ++i)
  {
    if (relations[i].hold == Hold::nothing)
      continue;
    std::array<Index, 3> row{};
    for (unsigned int d = 0; d < 3; ++d)
      row[d] = nodes[i].is_free[d] ? next++ : -1;
    for (unsigned int d = 0; d < 3; ++d)
      if (row[d] >= 0 && relations[i].holds(d))
        of_displacement_(row[d], row[d]) = stiffness[row[d]];
      else if (row[d] >= 0)
      {
        of_force(row[d], row[d]) = 1;
        of_force(row[d], row[2]) = relations[i].coupling[d];
        for (unsigned int e = 0; e < 2; ++e)
          if (row[e] >= 0)
            of_displacement_(row[d], row[e]) = relations[i].robin(d, e);
      }
  }
  return of_force;
}

/// Solver for a coarsest mesh that is large: one V-cycle of smoothed aggregation (Trilinos ML) on its
/// assembled stiffness with the relations of contact. Aggregates know all six rigid motions.
class AlgebraicCoarse : public CoarseSolver
{
public:
  /// Throws SolveError if ML finds no hierarchy.
  AlgebraicCoarse(const Discretization &space, const MaterialOptions &material)
      : stiffness_(space, material),
        rigid_motions_(stiffness_.rigid_motions())
  {
    if (!aggregate(of_free_, stiffness_.free()))
      throw SolveError("multigrid: the nodes of the coarsest mesh cannot be aggregated; cells that are far "
                       "from cubes make it so, or a Poisson ratio next to 0.5");
  }

  /// If ML finds no hierarchy with the relations of contact, the aggregates of the free body serve: they only
  /// precondition.
  void hold(const std::vector<NodeRelation> &relations) override
  {
    is_held_ = std::any_of(relations.begin(), relations.end(),
                           [](const NodeRelation &relation) { return relation.hold != Hold::nothing; });
    if (!is_held_)
      return;
    stiffness_.hold(relations, held_);
    is_held_ = aggregate(of_held_, held_);
  }

  VectorXd solve(VectorXd forces) const override
  {
    dealii::Vector<double> right_side(stiffness_.n_rows()), solution(stiffness_.n_rows());
    for (Index dof = 0; dof < forces.size(); ++dof)
      right_side[stiffness_.row(dof)] = forces[dof];
    if (is_held_)
      stiffness_.test(right_side);
    (is_held_ ? of_held_ : of_free_).vmult(solution, right_side);
    if (is_held_)
      stiffness_.clear_held(solution);
    for (Index dof = 0; dof < forces.size(); ++dof)
      forces[dof] = solution[stiffness_.row(dof)];
    return forces;
  }

private:
  using Hierarchy = dealii::TrilinosWrappers::PreconditionAMG;
  bool aggregate(Hierarchy &hierarchy, const NodeStiffness::Matrix &matrix) const;

  NodeStiffness stiffness_;
  std::vector<double> rigid_motions_; ///< one after the other, each with all rows
  NodeStiffness::Matrix held_;
  Hierarchy of_free_, of_held_;
  bool is_held_ = false;
};

/// Smoothed aggregation (Vanek, Mandel, Brezina, Computing 56 (1996) 179-196): nodes that are strongly
/// coupled become one, with six unknowns, so that each aggregate moves as a rigid body; interpolation is
/// smoothed once. Threshold 0 takes all couplings for strong, because cells of o-grids are far from cubes.
/// Returns whether ML found a hierarchy. The random numbers are the same every time, because a resumed run
/// must find the same hierarchy.
bool AlgebraicCoarse::aggregate(Hierarchy &hierarchy, const NodeStiffness::Matrix &matrix) const
{
  Teuchos::ParameterList options;
  ML_Epetra::SetDefaults("SA", options);
  options.set("ML output", 0);
  options.set("initialize random seed", true);
  options.set("smoother: type", "Chebyshev");
  options.set("smoother: sweeps", 3);
  options.set("smoother: Chebyshev alpha", 20.);
  options.set("aggregation: type", "Uncoupled");
  options.set("aggregation: threshold", 0.);
  options.set("coarse: type", "Amesos-KLU");
  options.set("coarse: max size", 2000);
  options.set("PDE equations", 3);
  options.set("null space: type", "pre-computed");
  options.set("null space: dimension", NodeStiffness::n_rigid_motions);
  options.set("null space: vectors", const_cast<double *>(rigid_motions_.data())); // ML only reads them
  hierarchy.clear();
  hierarchy.initialize(matrix, options);
  const auto *const ml =
      dynamic_cast<const ML_Epetra::MultiLevelPreconditioner *>(&hierarchy.trilinos_operator());
  return ml != nullptr && ml->IsPreconditionerComputed();
}

/// Solver for the coarsest mesh of several processes. Forces are summed over all processes, and each one
/// solves the whole mesh on its own, so that none waits for the answer of another.
class ReplicatedCoarse : public CoarseSolver
{
public:
  /// `shared` belongs to this process and others; its mesh has no halved cells.
  ReplicatedCoarse(const Discretization &shared, MeshOptions options, const HeldSurfaces &held,
                   const MaterialOptions &material, const CoarseMethod method)
      : triangulation_(dealii::Triangulation<3>::limit_level_difference_at_vertices)
  {
    options.degree = shared.scalar_fe().degree;
    options.quadrature_points = shared.n_quadrature_points();
    options.volumetric_quadrature = shared.volumetric_quadrature();
    triangulation_.copy_triangulation(shared.dof_handler().get_triangulation());
    whole_ = std::make_unique<Discretization>(triangulation_, options, held);
    solver_ = make_coarse_solver(*whole_, material, method);
    number(shared);
  }

  void hold(const std::vector<NodeRelation> &relations) override { solver_->hold(relations); }

  VectorXd solve(VectorXd forces) const override
  {
    VectorXd all = VectorXd::Zero(whole_->n_free());
    for (std::size_t i = 0; i < whole_dof_.size(); ++i)
      all[whole_dof_[i]] = forces[static_cast<Index>(i)];
    sum_over_ranks(all.data(), static_cast<std::size_t>(all.size()));
    const VectorXd solution = solver_->solve(std::move(all));
    for (std::size_t i = 0; i < whole_dof_.size(); ++i)
      forces[static_cast<Index>(i)] = solution[whole_dof_[i]];
    return forces;
  }

private:
  void number(const Discretization &shared);

  dealii::Triangulation<3> triangulation_;
  std::unique_ptr<const Discretization> whole_;
  std::unique_ptr<CoarseSolver> solver_;
  std::vector<unsigned int> whole_dof_; ///< for the free degrees of freedom that this process owns
};

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
} // namespace

// Small coarsest meshes are factorized, because an exact solver makes a cycle as good as its smoother. With
// many contact nodes its dense compliance is the dearest part of a cycle, so that aggregates take over.
std::unique_ptr<CoarseSolver> make_coarse_solver(const Discretization &space, const MaterialOptions &material,
                                                 const CoarseMethod method)
{
  const auto n_contact_nodes = static_cast<double>(space.contact_surface().nodes.size());
  if (method == CoarseMethod::algebraic ||
      (method == CoarseMethod::by_size && aggregates_coarsest(space.n_dofs(), n_contact_nodes)))
    return std::make_unique<AlgebraicCoarse>(space, material);
  return std::make_unique<FactorizedCoarse>(space, material);
}

std::unique_ptr<CoarseSolver> make_shared_coarse_solver(const Discretization &shared, const MeshOptions &mesh,
                                                        const HeldSurfaces &held,
                                                        const MaterialOptions &material,
                                                        const CoarseMethod method)
{
  return std::make_unique<ReplicatedCoarse>(shared, mesh, held, material, method);
}
} // namespace orthocone
