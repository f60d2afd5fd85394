// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/driven_field.h>

#include "fe/cell_stiffness.h"
#include "fe/local_dofs.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// With the rigid motion R m of the held face the body moves by u = R m + v, where v is zero on the held face
// and v_s = -(R m)_s on the supports s. A rigid motion strains nothing, so that the free unknowns f obey
//   K_ff v_f = -K_fs v_s,
// and the energy of the motion is v^T K v/2 = m^T A m/2. With v = g + w, where g is v_s on the supports and
// what hangs on them, and w is zero there,
//   A = g^T K g - h^T w,   h = -(K g)_f,   K_ff w = h   for each pair of columns
// (static condensation on the supported displacements, one solve a component).
namespace
{
/// g, and what it does to the body.
struct SupportLoad
{
  MatrixXd given;    ///< g, n_dofs x 6, mm
  MatrixXd forces;   ///< h, n_free x 6, N
  MatrixXd products; ///< g^T K g, 6 x 6, of this process
};

RigidMotion unit_motion(const unsigned int component)
{
  RigidMotion unit;
  unit[component] = 1;
  return unit;
}

/// Values of all local degrees of freedom: `values` as far as this process owns them, and those of their
/// owners.
template<int dim>
VectorXd with_ghosts(const DisplacementSpace<dim> &space, const VectorXd &values)
{
  VectorXd all = VectorXd::Zero(space.n_dofs());
  all.head(values.size()) = values;
  if (!space.is_shared())
    return all;
  dealii::LinearAlgebra::distributed::Vector<double> shared(space.partitioner());
  std::copy(values.begin(), values.end(), shared.begin());
  shared.update_ghost_values();
  return Eigen::Map<const VectorXd>(shared.begin(), static_cast<Index>(space.n_dofs()));
}

/// Columns of g: supports stay where the rigid motion leaves, and what hangs on them goes with them.
template<int dim>
MatrixXd given_displacements(const DisplacementSpace<dim> &space, const ModelSymmetry &symmetry)
{
  MatrixXd given = MatrixXd::Zero(space.n_dofs(), n_rigid_components);
  std::vector<bool> is_supported(space.n_dofs(), false);
  for (const unsigned int dof : space.supported())
  {
    is_supported[dof] = true;
    for (unsigned int j = 0; j < n_rigid_components; ++j)
      if (symmetry.leaves(j))
        given(dof, j) = -unit_motion(j).at(space.position(dof) - space.held_centre())[space.direction(dof)];
  }
  // A process does not know the places of those that only move others which hang in its cells.
  for (Index j = 0; j < given.cols(); ++j)
    given.col(j) = with_ghosts(space, given.col(j).head(space.n_owned()));
  const auto &partitioner = *space.partitioner();
  const auto is_local = [&](const auto dof)
  { return partitioner.in_local_range(dof) || partitioner.is_ghost_entry(dof); };
  const auto hanging = hanging_constraints(space.dof_handler());
  for (const auto &line : hanging.get_lines())
    if (is_local(line.index) && space.hanging().contains(space.local_dof(line.index)))
      for (const auto &[mover, weight] : line.entries)
        if (is_supported[space.local_dof(mover)])
          given.row(space.local_dof(line.index)) += weight * given.row(space.local_dof(mover));
  return given;
}

/// Adds up what each process has of the rows of unknowns, and returns those of the free ones of this process.
template<int dim>
MatrixXd summed(const DisplacementSpace<dim> &space, const MatrixXd &rows)
{
  MatrixXd free = rows.topRows(space.n_free());
  if (!space.is_shared())
    return free;
  dealii::LinearAlgebra::distributed::Vector<double> sums(space.partitioner());
  for (Index j = 0; j < rows.cols(); ++j)
  {
    sums = 0;
    std::copy(rows.col(j).begin(), rows.col(j).end(), sums.begin());
    sums.compress(dealii::VectorOperation::add);
    free.col(j) = Eigen::Map<const VectorXd>(sums.begin(), free.rows());
  }
  return free;
}

template<int dim>
SupportLoad support_load(const DisplacementSpace<dim> &space, const Materials &materials,
                         const ModelSymmetry &symmetry)
{
  SupportLoad load{
      given_displacements(space, symmetry), {}, MatrixXd::Zero(n_rigid_components, n_rigid_components)};
  MatrixXd forces = MatrixXd::Zero(space.n_dofs(), n_rigid_components);
  CellStiffness<dim> stiffness(space, materials);
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const auto dofs = dofs_by_node(space, cell);
    MatrixXd of_cell(dofs.size(), n_rigid_components);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      of_cell.row(static_cast<Index>(i)) = load.given.row(static_cast<Index>(dofs[i]));
    if (of_cell.isZero(0))
      continue;
    const MatrixXd pulled = stiffness.of(cell) * of_cell;
    load.products += of_cell.transpose() * pulled;
    const CellBasis moving(space.hanging(), dofs);
    const MatrixXd on_moving = moving.basis.size() == 0 ? pulled : moving.basis.transpose() * pulled;
    for (std::size_t i = 0; i < moving.dofs.size(); ++i)
      forces.row(static_cast<Index>(moving.dofs[i])) -= on_moving.row(static_cast<Index>(i));
  }
  load.forces = summed(space, forces);
  return load;
}

/// Displacements (mm) of the contact nodes in their local axes; those of other processes are added.
MatrixXd at_contact_nodes(const ContactFrame &frame, const MatrixXd &volume)
{
  const auto &nodes = frame.nodes();
  MatrixXd contact = MatrixXd::Zero(3 * static_cast<Index>(nodes.size()), volume.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (!nodes[i].is_here())
      continue;
    MatrixXd global = MatrixXd::Zero(3, volume.cols());
    for (unsigned int d = 0; d < 3; ++d)
      if (nodes[i].is_free[d] || nodes[i].is_supported[d])
        global.row(d) = volume.row(nodes[i].dofs[d]);
    contact.middleRows<3>(3 * static_cast<Index>(i)) = frame.global_in_local(i).transpose() * global;
  }
  sum_over_ranks(contact.data(), static_cast<std::size_t>(contact.size()));
  return contact;
}
} // namespace

DrivenField driven_field(const Body &body, const ContactFrame &frame, const ModelSymmetry &symmetry,
                         const std::function<VectorXd(const VectorXd &)> &solve)
{
  const SupportLoad load =
      body.visit([&](const auto &space) { return support_load(space, body.materials(), symmetry); });
  MatrixXd energies = load.products;
  DrivenField field{load.given, {}, {}};
  for (unsigned int j = 0; j < n_rigid_components; ++j)
  {
    if (any_rank(!load.forces.col(j).isZero(0)))
    {
      const VectorXd free = solve(load.forces.col(j));
      energies.col(j) -= load.forces.transpose() * free;
      field.volume.col(j) += body.visit(
          [&](const auto &space)
          {
            VectorXd all = with_ghosts(space, free);
            space.hanging().distribute(all.data());
            return all;
          });
    }
  }
  sum_over_ranks(energies.data(), static_cast<std::size_t>(energies.size()));
  field.contact = at_contact_nodes(frame, field.volume);
  field.stiffness = 0.5 * (energies + energies.transpose());
  return field;
}
} // namespace orthocone
