// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "matrix_free_stiffness.h"

#include "monomials.h"

#include <orthocone/body/fe/projected_divergence.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/materials/lame.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace orthocone
{
namespace
{
/// Values, or first derivatives, of the polynomials through `nodes` (columns) at `points` (rows).
template<typename Number>
std::vector<Number> line_table(const std::vector<dealii::Point<1>> &nodes,
                               const std::vector<dealii::Point<1>> &points, const unsigned int derivative)
{
  const auto polynomials = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
  std::vector<Number> table;
  std::vector<double> values(2);
  for (const dealii::Point<1> &point : points)
    for (const auto &polynomial : polynomials)
    {
      polynomial.value(point[0], values);
      table.push_back(static_cast<Number>(values[derivative]));
    }
  return table;
}

/// Of the polynomials that the divergence is projected to; 0 where it is not.
unsigned int n_polynomials(const Discretization &space)
{
  const unsigned int k = space.scalar_fe().degree;
  return space.volumetric_quadrature() == VolumetricQuadrature::full ? 0 : k * (k + 1) * (k + 2) / 6;
}

template<typename Number>
CellBatches<Number> empty_batches(const Discretization &space, const MaterialOptions &material)
{
  const LameParameters lame(material);
  const unsigned int n_nodes = space.scalar_fe().degree + 1, n_points = space.n_quadrature_points();
  const auto nodes = dealii::QGaussLobatto<1>(n_nodes).get_points();
  const auto points = dealii::QGauss<1>(n_points).get_points();
  return {n_nodes,
          n_points,
          line_table<Number>(nodes, points, 0),
          line_table<Number>(points, points, 1),
          static_cast<Number>(lame.lambda),
          static_cast<Number>(lame.mu),
          n_polynomials(space)};
}

/// A batch has as many cells as a register has numbers, and each lane computes one of them. So a product
/// reads its geometry once, in order, and no cell depends on another one of its batch until forces are added.
/// Lanes that no cell is left for have no volume: their forces vanish. The
/// writer puts cells into these lanes.
template<typename Number>
class BatchWriter
{
public:
  BatchWriter(const Discretization &space, CellBatches<Number> &batches)
      : space_(space),
        batches_(batches),
        values_(space.mapping(), space.scalar_fe(), dealii::QGauss<3>(space.n_quadrature_points()),
                dealii::update_inverse_jacobians | dealii::update_JxW_values |
                    dealii::update_quadrature_points),
        linear_(2),
        of_cell_(space.fe().n_dofs_per_cell())
  {
  }

  void add(const Discretization::Cell &cell, const unsigned int lane)
  {
    if (lane == 0)
      add_batch();
    cell->get_dof_indices(of_cell_);
    unsigned int *to = batches_.dofs.data() + batches_.dofs.size() - of_cell_.size() * lanes + lane;
    for (unsigned int component = 0; component < 3; ++component)
      for (const unsigned int node : space_.scalar_fe().get_poly_space_numbering_inverse())
      {
        *to = space_.local_dof(of_cell_[space_.fe().component_to_system_index(component, node)]);
        to += lanes;
      }
    values_.reinit(static_cast<typename dealii::Triangulation<3>::cell_iterator>(cell));
    linear_.reset(values_.get_cell(), 0);
    Lanes<Number> *geometry = batches_.geometry.data() + batches_.geometry.size() - n_geometry();
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int e = 0; e < 3; ++e)
          (geometry++)->values[lane] = static_cast<Number>(values_.inverse_jacobian(q)[d][e]);
      (geometry++)->values[lane] = static_cast<Number>(values_.JxW(q));
      if (batches_.n_polynomials > 1)
        for (const double coordinate : coordinates(q))
          (geometry++)->values[lane] = static_cast<Number>(coordinate);
    }
    if (batches_.n_polynomials > 0)
      add_inverse_mass(lane);
  }

private:
  static constexpr unsigned int lanes = Lanes<Number>::n;

  unsigned int n_geometry() const
  {
    return CellBatches<Number>::n_geometry(batches_.n_polynomials) * values_.n_quadrature_points;
  }
  unsigned int n_in_triangle() const { return CellBatches<Number>::n_in_triangle(batches_.n_polynomials); }

  /// Of a quadrature point of the cell, for the polynomials: linear in space, and of similar size in all
  /// directions, so that their mass matrix is well conditioned in flat cells, too.
  Eigen::Vector3d coordinates(const unsigned int q) const
  {
    return linear_.polynomials_at(values_.quadrature_point(q)).template tail<3>();
  }

  /// Of the polynomials in the cell.
  void add_inverse_mass(const unsigned int lane)
  {
    const auto n = static_cast<Eigen::Index>(batches_.n_polynomials);
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      Eigen::VectorXd monomials(n);
      make_monomials(coordinates(q).data(), batches_.n_polynomials, monomials.data());
      mass += (values_.JxW(q) * monomials) * monomials.transpose();
    }
    const Eigen::MatrixXd inverse = mass.llt().solve(Eigen::MatrixXd::Identity(n, n));
    Lanes<Number> *to = batches_.inverse_masses.data() + batches_.inverse_masses.size() - n_in_triangle();
    for (Eigen::Index row = 0; row < n; ++row)
      for (Eigen::Index column = 0; column <= row; ++column)
        (to++)->values[lane] = static_cast<Number>(inverse(row, column));
  }

  /// Lanes without a cell keep the values from here: no volume, and any degree of freedom.
  void add_batch()
  {
    batches_.dofs.resize(batches_.dofs.size() + of_cell_.size() * lanes, space_.n_dofs() - 1);
    batches_.geometry.resize(batches_.geometry.size() + n_geometry(), Lanes<Number>{});
    batches_.inverse_masses.resize(batches_.inverse_masses.size() + n_in_triangle(), Lanes<Number>{});
  }

  const Discretization &space_;
  CellBatches<Number> &batches_;
  dealii::FEValues<3> values_;
  ProjectedDivergence<3> linear_; ///< whose polynomials are linear
  std::vector<dealii::types::global_dof_index> of_cell_;
};
} // namespace

template<typename Number>
MatrixFreeStiffness<Number>::MatrixFreeStiffness(const Discretization &space, const MaterialOptions &material)
    : space_(space),
      material_(material),
      cells_(empty_batches<Number>(space, material)),
      hanging_(space.hanging())
{
  BatchWriter<Number> writer(space, cells_);
  unsigned int n_cells = 0;
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      writer.add(cell, n_cells++ % Lanes<Number>::n);
  if (!hanging_.empty())
    with_hanging_.resize(space.n_dofs());
}

template<typename Number>
void MatrixFreeStiffness<Number>::vmult(BodyVector<Number> &forces,
                                        const BodyVector<Number> &displacement) const
{
  Assert(std::all_of(displacement.begin() + space_.n_free(), displacement.begin() + space_.n_owned(),
                     [](const Number held) { return held == 0; }),
         dealii::ExcMessage("a held degree of freedom moves"));
  forces = 0;
  displacement.update_ghost_values();
  if (hanging_.empty())
    add_products(cells_, displacement.begin(), forces.begin());
  else
  {
    std::copy_n(displacement.begin(), space_.n_dofs(), with_hanging_.begin());
    hanging_.distribute(with_hanging_.data());
    add_products(cells_, with_hanging_.data(), forces.begin());
    hanging_.collect(forces.begin());
  }
  displacement.zero_out_ghost_values();
  forces.compress(dealii::VectorOperation::add);
  clear_held(forces);
}

template<typename Number>
BodyVector<Number> MatrixFreeStiffness<Number>::diagonal() const
{
  BodyVector<Number> diagonal = make_vector();
  add_diagonals(cells_, diagonal.begin());
  const Eigen::VectorXd beside_hanging = diagonal_beside_hanging_nodes(space_, material_);
  for (Eigen::Index i = 0; i < beside_hanging.size(); ++i)
    diagonal.local_element(i) += static_cast<Number>(beside_hanging[i]);
  diagonal.compress(dealii::VectorOperation::add);
  clear_held(diagonal);
  return diagonal;
}

template<typename Number>
void MatrixFreeStiffness<Number>::clear_held(BodyVector<Number> &vector) const
{
  std::fill(vector.begin() + space_.n_free(), vector.begin() + space_.n_owned(), Number{0});
}

template class MatrixFreeStiffness<float>;
template class MatrixFreeStiffness<double>;
} // namespace orthocone
