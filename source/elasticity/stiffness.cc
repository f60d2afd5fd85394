// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_dofs.h"

#include <orthocone/elasticity/projected_divergence.h>
#include <orthocone/elasticity/stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/work_stream.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace orthocone
{
namespace
{
constexpr unsigned int dim = 3;

/// Work space of one thread.
struct Scratch
{
  explicit Scratch(const Discretization &discretization)
      : values(discretization.mapping(), discretization.scalar_fe(),
               dealii::QGauss<dim>(discretization.n_quadrature_points()),
               dealii::update_gradients | dealii::update_JxW_values)
  {
    if (discretization.volumetric_quadrature() == VolumetricQuadrature::reduced)
      divergence.emplace(values.get_fe().degree, values.get_quadrature());
  }
  Scratch(const Scratch &other)
      : values(other.values.get_mapping(), other.values.get_fe(), other.values.get_quadrature(),
               other.values.get_update_flags()),
        divergence(other.divergence)
  {
  }

  dealii::FEValues<dim> values;
  std::optional<ProjectedDivergence<dim>> divergence; ///< with reduced volumetric quadrature
  Eigen::MatrixXd products;  ///< integral of d_i N_a d_j N_b at (dim a + i, dim b + j)
  Eigen::VectorXd gradients; ///< d_i N_a at dim a + i, its divergence in direction i
};

struct CellMatrix
{
  Eigen::MatrixXd matrix; ///< numbered as `products` of Scratch
  std::vector<dealii::types::global_dof_index> dofs;
};

void integrate_gradient_products(const dealii::Triangulation<dim>::active_cell_iterator &cell,
                                 Scratch &scratch)
{
  scratch.values.reinit(cell);
  const unsigned int n_nodes = scratch.values.dofs_per_cell;
  const Eigen::Index n = static_cast<Eigen::Index>(dim) * n_nodes;
  scratch.gradients.resize(n);
  scratch.products.setZero(n, n);
  if (scratch.divergence)
    scratch.divergence->reset(n);
  for (const unsigned int q : scratch.values.quadrature_point_indices())
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        scratch.gradients[dim * a + i] = scratch.values.shape_grad(a, q)[i];
    scratch.products.noalias() += (scratch.values.JxW(q) * scratch.gradients) * scratch.gradients.transpose();
    if (scratch.divergence)
      scratch.divergence->add(q, scratch.gradients, scratch.values.JxW(q));
  }
}

/// Blocks lambda d_i N_a d_j N_b + mu (d_j N_a d_i N_b + delta_ij grad N_a . grad N_b) of the cell matrix.
void combine(const Eigen::MatrixXd &products, const LameParameters &lame, Eigen::MatrixXd &matrix)
{
  matrix.resizeLike(products);
  for (Eigen::Index b = 0; b < products.cols(); b += dim)
    for (Eigen::Index a = 0; a < products.rows(); a += dim)
    {
      const Eigen::Matrix3d block = products.block<dim, dim>(a, b);
      matrix.block<dim, dim>(a, b) = lame.lambda * block + lame.mu * block.transpose() +
                                     lame.mu * block.trace() * Eigen::Matrix3d::Identity();
    }
}

template<int any_dim>
void make_pattern(const dealii::DoFHandler<any_dim> &dof_handler, const unsigned int n_free,
                  dealii::SparsityPattern &pattern)
{
  dealii::DynamicSparsityPattern entries(n_free);
  std::vector<dealii::types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
  std::vector<dealii::types::global_dof_index> columns;
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    cell->get_dof_indices(dofs);
    std::sort(dofs.begin(), dofs.end());
    columns.clear();
    for (const auto row : dofs)
    {
      if (row >= n_free)
        break;
      columns.push_back(row);
      entries.add_entries(row, columns.begin(), columns.end(), true);
    }
  }
  pattern.copy_from(entries);
}
} // namespace

LameParameters::LameParameters(const MaterialOptions &material)
    : lambda(material.young_modulus * material.poisson_ratio /
             ((1 + material.poisson_ratio) * (1 - 2 * material.poisson_ratio))),
      mu(material.young_modulus / (2 * (1 + material.poisson_ratio)))
{
}

Stiffness::Stiffness(const Discretization &discretization, const MaterialOptions &material)
{
  make_stiffness_pattern(discretization, pattern_);
  matrix_.reinit(pattern_);
  assemble(discretization, LameParameters(material));
}

void make_stiffness_pattern(const Discretization &discretization, dealii::SparsityPattern &pattern)
{
  make_pattern(discretization.dof_handler(), discretization.n_free(), pattern);
}

void make_stiffness_pattern(const SectionDiscretization &discretization, dealii::SparsityPattern &pattern)
{
  make_pattern(discretization.dof_handler(), discretization.n_free(), pattern);
}

void Stiffness::assemble(const Discretization &discretization, const LameParameters &lame)
{
  LameParameters combined = lame; // what combine() takes care of
  if (discretization.volumetric_quadrature() == VolumetricQuadrature::reduced)
    combined.lambda = 0;
  const auto work =
      [&](const dealii::DoFHandler<dim>::active_cell_iterator &cell, Scratch &scratch, CellMatrix &copy)
  {
    integrate_gradient_products(cell, scratch);
    combine(scratch.products, combined, copy.matrix);
    if (scratch.divergence)
      copy.matrix += lame.lambda * scratch.divergence->products();
    copy.dofs = dofs_by_node<dim>(cell);
  };
  const auto add = [&](const CellMatrix &copy) { add_cell_matrix(copy.matrix, copy.dofs, matrix_); };
  const auto &dof_handler = discretization.dof_handler();
  dealii::WorkStream::run(dof_handler.begin_active(), dof_handler.end(), work, add, Scratch(discretization),
                          CellMatrix());
}

double Stiffness::rounding(const Eigen::VectorXd &displacement) const
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(displacement.size());
  for (unsigned int row = 0; row < matrix_.m(); ++row)
    for (auto entry = matrix_.begin(row); entry != matrix_.end(row); ++entry)
    {
      const unsigned int column = entry->column();
      const double size = std::abs(entry->value());
      sums[row] += size * std::abs(displacement[column]);
      if (column != row)
        sums[column] += size * std::abs(displacement[row]);
    }
  return std::numeric_limits<double>::epsilon() * sums.norm();
}

Eigen::VectorXd Stiffness::vmult(const Eigen::VectorXd &displacement) const
{
  // Both triangles have the diagonal.
  const dealii::Vector<double> u(displacement.begin(), displacement.end());
  dealii::Vector<double> forces(u.size());
  matrix_.vmult(forces, u);
  matrix_.Tvmult_add(forces, u);
  for (unsigned int row = 0; row < matrix_.m(); ++row)
    forces[row] -= matrix_.diag_element(row) * u[row];
  return Eigen::Map<const Eigen::VectorXd>(forces.data(), displacement.size());
}
} // namespace orthocone
