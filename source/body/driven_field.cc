// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/driven_field.h>

#include "fe/cell_stiffness.h"
#include "fe/local_dofs.h"
#include "loads/load_forces.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <iterator>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Let x be the motion m of the held face, displacements s of other surfaces, and temperatures T (x_d
// together), and lambda the loads that act by tractions. With the rigid motion R m of the held face the body
// moves by u = R m + v, where v is zero on the held face, v_s = -(R m)_s on the supports, and s on surfaces
// that loads move. A rigid motion strains nothing. Let g be what is given of v, with what hangs on it, e_0
// the free strain of x_d, and f the forces of load_forces(). The unknowns w, zero where g is given, obey
//   K_ff w = h,   h = -(K g)_f + f_f   for each column of x_d,   and   h = f_f   for each one of lambda.
// The elastic energy of x_d and lambda is x_d^T A x_d/2 + lambda^T G lambda/2, because what is in equilibrium
// without forces does no work on w:
//   A = g^T K g - h^T w - g^T f - f^T g + int e_0 : C : e_0 dV,   G = f^T w
// (static condensation, one solve a column). Let V = f^T (R + g + w) be the work of the tractions of a unit
// of lambda on the displacements of a unit of x_d. Then the conjugates without contact forces are
//   A x_d - V^T lambda,   which hold the surfaces and hinder free strains, and   V x_d + G lambda,
// the mean displacements times the areas: derivatives of the energy, and of minus the complementary energy.
namespace
{
/// g, the forces h that it asks for, and g^T K g.
struct GivenLoad
{
  MatrixXd given;    ///< g, n_dofs x (6 + m), mm
  MatrixXd forces;   ///< -(K g)_f, n_free x (6 + m), N
  MatrixXd products; ///< g^T K g, of this process
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

/// Adds what hangs on supported degrees of freedom to columns of g.
template<int dim>
void distribute_given(const DisplacementSpace<dim> &space, const std::vector<bool> &is_supported,
                      MatrixXd &given)
{
  const auto &partitioner = *space.partitioner();
  const auto is_local = [&](const auto dof)
  { return partitioner.in_local_range(dof) || partitioner.is_ghost_entry(dof); };
  const auto hanging = hanging_constraints(space.dof_handler());
  for (const auto &line : hanging.get_lines())
    if (is_local(line.index) && space.hanging().contains(space.local_dof(line.index)))
      for (const auto &[mover, weight] : line.entries)
        if (is_supported[space.local_dof(mover)])
          given.row(space.local_dof(line.index)) += weight * given.row(space.local_dof(mover));
}

/// The degrees of freedom that a load moves, of those that this process works with, by numbers of this
/// process.
template<int dim>
std::vector<unsigned int> moved_by_load(const DisplacementSpace<dim> &space, const GeometryOptions &geometry,
                                        const Load &load)
{
  std::array<bool, 3> directions{};
  directions[axis_of(load.direction)] = true;
  std::vector<unsigned int> moved;
  for (const std::string &surface : load.surfaces)
    for (const auto dof : space.dofs_on(boundary_of_marked(geometry, surface), directions))
      if (space.partitioner()->in_local_range(dof) || space.partitioner()->is_ghost_entry(dof))
        moved.push_back(space.local_dof(dof));
  std::sort(moved.begin(), moved.end());
  return moved;
}

/// Where surfaces that loads move have the value 1 along their direction. `is_supported` are the degrees of
/// freedom that the held face does not move.
template<int dim>
void set_moved_surfaces(const DisplacementSpace<dim> &space, const GeometryOptions &geometry,
                        const std::vector<bool> &is_supported, MatrixXd &given)
{
  for (std::size_t k = 0; k < geometry.loads.size(); ++k)
  {
    const Load &load = geometry.loads[k];
    if (!geometry.has(load) || !load.kind->moves_surface())
      continue;
    const unsigned int axis = axis_of(load.direction);
    const double value = load.direction[axis] * (geometry.is_mirrored() && axis == 2 ? -1 : 1);
    for (const unsigned int dof : moved_by_load(space, geometry, load))
      if (is_supported[dof])
        given(dof, n_rigid_components + static_cast<Index>(k)) = value;
  }
}

/// Columns of g: supports stay where the rigid motion leaves, and what hangs on them goes with them.
template<int dim>
MatrixXd given_displacements(const DisplacementSpace<dim> &space, const GeometryOptions &geometry,
                             const ModelSymmetry &symmetry)
{
  MatrixXd given =
      MatrixXd::Zero(space.n_dofs(), n_rigid_components + static_cast<Index>(geometry.loads.size()));
  std::vector<bool> is_supported(space.n_dofs(), false);
  for (const unsigned int dof : space.supported())
  {
    is_supported[dof] = true;
    for (unsigned int j = 0; j < n_rigid_components; ++j)
      if (symmetry.leaves(j))
        given(dof, j) = -unit_motion(j).at(space.position(dof) - space.held_centre())[space.direction(dof)];
  }
  set_moved_surfaces(space, geometry, is_supported, given);
  // A process does not know the places of those that only move others which hang in its cells.
  for (Index j = 0; j < given.cols(); ++j)
    given.col(j) = with_ghosts(space, given.col(j).head(space.n_owned()));
  distribute_given(space, is_supported, given);
  return given;
}

template<int dim>
GivenLoad given_load(const DisplacementSpace<dim> &space, const Materials &materials,
                     const GeometryOptions &geometry, const ModelSymmetry &symmetry)
{
  GivenLoad load{given_displacements(space, geometry, symmetry), {}, {}};
  const Index n = load.given.cols();
  load.products = MatrixXd::Zero(n, n);
  MatrixXd forces = MatrixXd::Zero(space.n_dofs(), n);
  CellStiffness<dim> stiffness(space, materials);
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const auto dofs = dofs_by_node(space, cell);
    MatrixXd of_cell(dofs.size(), n);
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

/// Displacements of rigid motions and of `added`, at all local degrees of freedom.
template<int dim>
MatrixXd whole_displacements(const DisplacementSpace<dim> &space, const ModelSymmetry &symmetry,
                             MatrixXd added)
{
  for (unsigned int dof = 0; dof < space.n_dofs(); ++dof)
    for (unsigned int j = 0; j < n_rigid_components; ++j)
      if (symmetry.leaves(j))
        added(dof, j) += unit_motion(j).at(space.position(dof) - space.held_centre())[space.direction(dof)];
  return added;
}

} // namespace

/// Those of other processes are added.
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

/// Columns that only tractions drive: 1, others 0.
static VectorXd by_traction(const GeometryOptions &geometry)
{
  VectorXd is_traction = VectorXd::Zero(n_rigid_components + static_cast<Index>(geometry.loads.size()));
  for (std::size_t k = 0; k < geometry.loads.size(); ++k)
    if (geometry.has(geometry.loads[k]) && geometry.loads[k].kind->acts_by_traction())
      is_traction[n_rigid_components + static_cast<Index>(k)] = 1;
  return is_traction;
}

/// The solutions w of all columns, at all local degrees of freedom.
static MatrixXd solutions(const Body &body, const MatrixXd &forces,
                          const std::function<VectorXd(const VectorXd &)> &solve)
{
  MatrixXd all = MatrixXd::Zero(body.unknowns().n_dofs(), forces.cols());
  for (Index j = 0; j < forces.cols(); ++j)
    if (any_rank(!forces.col(j).isZero(0)))
    {
      const VectorXd free = solve(forces.col(j));
      all.col(j) = body.visit(
          [&](const auto &space)
          {
            VectorXd whole = with_ghosts(space, free);
            space.hanging().distribute(whole.data());
            return whole;
          });
    }
  return all;
}

/// DrivenField::conjugates from A, G and V, of which only some blocks are used: `is_traction` is 1 for
/// columns of lambda. All are of this process.
static MatrixXd conjugates_of(const MatrixXd &a, const MatrixXd &g, const MatrixXd &v,
                              const VectorXd &is_traction)
{
  MatrixXd conjugates = a;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      if (is_traction[i] != 0)
        conjugates(i, j) = is_traction[j] != 0 ? g(i, j) : v(i, j);
      else if (is_traction[j] != 0)
        conjugates(i, j) = -v(j, i);
  sum_over_ranks(conjugates.data(), static_cast<std::size_t>(conjugates.size()));
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < i; ++j)
      if (is_traction[i] == is_traction[j])
        conjugates(i, j) = conjugates(j, i) = 0.5 * (conjugates(i, j) + conjugates(j, i));
  return conjugates;
}

DrivenField driven_field(const Body &body, const BodyOptions &options, const ContactFrame &frame,
                         const ModelSymmetry &symmetry,
                         const std::function<VectorXd(const VectorXd &)> &solve)
{
  const auto m = static_cast<Index>(options.geometry.loads.size()), n = n_rigid_components + m;
  const GivenLoad given = body.visit(
      [&](const auto &space) { return given_load(space, body.materials(), options.geometry, symmetry); });
  LoadForces loads =
      body.visit([&](const auto &space) { return load_forces(space, options, body.materials()); });
  MatrixXd forces = given.forces, hindered = MatrixXd::Zero(n, n),
           nodal = MatrixXd::Zero(body.unknowns().n_dofs(), n);
  forces.rightCols(m) += loads.on_free;
  hindered.bottomRightCorner(m, m) = loads.hindered;
  nodal.rightCols(m) = loads.nodal;
  const MatrixXd found = solutions(body, forces, solve);
  DrivenField field{given.given + found, {}, {}, VectorXd::Ones(n), loads.areas};
  const MatrixXd on_given = given.given.transpose() * nodal;
  const MatrixXd flexibility = forces.transpose() * found.topRows(forces.rows());
  const MatrixXd work =
      nodal.transpose() *
      body.visit([&](const auto &space) { return whole_displacements(space, symmetry, field.volume); });
  const VectorXd is_traction = by_traction(options.geometry);
  field.signs -= 2 * is_traction;
  field.conjugates = conjugates_of(given.products - flexibility - on_given - on_given.transpose() + hindered,
                                   flexibility, work, is_traction);
  sum_over_ranks(field.areas.data(), static_cast<std::size_t>(field.areas.size()));
  field.contact = at_contact_nodes(frame, field.volume);
  return field;
}

std::string moved_twice(const Body &body, const GeometryOptions &geometry)
{
  const std::vector<Load> &loads = geometry.loads;
  const auto moves = [&](const Load &load) { return geometry.has(load) && load.kind->moves_surface(); };
  for (auto load = loads.begin(); load != loads.end(); ++load)
    for (auto other = loads.begin(); other != load; ++other)
    {
      if (!moves(*load) || !moves(*other) || axis_of(load->direction) != axis_of(other->direction))
        continue;
      std::vector<unsigned int> both;
      body.visit(
          [&](const auto &space)
          {
            const auto one = moved_by_load(space, geometry, *load),
                       two = moved_by_load(space, geometry, *other);
            std::set_intersection(one.begin(), one.end(), two.begin(), two.end(), std::back_inserter(both));
            return 0;
          });
      if (any_rank(!both.empty()))
        return other->name + " and " + load->name + " along " + "xyz"[axis_of(load->direction)];
    }
  return {};
}

bool is_driven(const Body &body, const BodyOptions &options)
{
  const auto &loads = options.geometry.loads;
  return any_rank(body.visit([](const auto &space) { return !space.supported().empty(); })) ||
         std::any_of(loads.begin(), loads.end(),
                     [&](const Load &load) { return options.geometry.has(load); });
}
} // namespace orthocone
