// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_dgq.h>

#include <Eigen/Dense>

namespace orthocone
{
/// The divergence in a cell, projected (least squares) to the polynomials in the cell's own coordinates whose
/// degree is one less than the displacement's (docs/theory.md, section 2, "Nearly incompressible bodies").
///
/// In parallelepipeds this is the interpolation between the Gauss points of the rule with one point fewer per
/// direction, so that its square is what selective reduced integration takes. In other cells that rule is not
/// exact for the divergence itself, and a uniform pressure would no longer be balanced; the projection keeps
/// constants.
template<int dim>
class ProjectedDivergence
{
public:
  /// `degree` is that of the displacement, at least 1; `quadrature` is on the unit cell.
  ProjectedDivergence(const unsigned int degree, const dealii::Quadrature<dim> &quadrature)
      : polynomials_(dealii::FE_DGQ<dim>(degree - 1).n_dofs_per_cell(), quadrature.size())
  {
    const dealii::FE_DGQ<dim> fe(degree - 1);
    for (unsigned int k = 0; k < polynomials_.rows(); ++k)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        polynomials_(k, q) = fe.shape_value(k, quadrature.point(q));
  }

  /// Begins a cell with `n_dofs` degrees of freedom.
  void reset(const Eigen::Index n_dofs)
  {
    mass_.setZero(polynomials_.rows(), polynomials_.rows());
    moments_.setZero(polynomials_.rows(), n_dofs);
  }

  /// Adds a quadrature point: the degrees of freedom's divergences there (n_dofs, 1/mm), and its share of the
  /// volume (mm^3).
  void add(const unsigned int q, const Eigen::VectorXd &divergences, const double volume)
  {
    mass_.noalias() += (volume * polynomials_.col(q)) * polynomials_.col(q).transpose();
    moments_.noalias() += (volume * polynomials_.col(q)) * divergences.transpose();
  }

  /// Values of the polynomials (rows) at the quadrature points (columns).
  const Eigen::MatrixXd &polynomials() const { return polynomials_; }

  /// Column i has the polynomials' coefficients in the projected divergence of degree of freedom i, 1/mm.
  Eigen::MatrixXd coefficients() const { return mass_.llt().solve(moments_); }

  /// Integrals of the products of the projected divergences: n_dofs x n_dofs, mm.
  Eigen::MatrixXd products() const { return moments_.transpose() * coefficients(); }

private:
  Eigen::MatrixXd polynomials_;
  Eigen::MatrixXd mass_;
  Eigen::MatrixXd moments_; ///< of the divergences of the degrees of freedom
};
} // namespace orthocone
