// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/parallelepiped.h>

#include <deal.II/fe/fe_dgp.h>

#include <Eigen/Dense>

namespace orthocone
{
/// The divergence in a cell, projected (least squares) to the polynomials in x, y, z (in a section: r, z)
/// whose total degree is one less than the displacement's (docs/theory.md, section 2, "Projected
/// divergence").
///
/// These are complete polynomials: 1, x, y, z for a displacement of degree 2. Together with the displacement
/// they form the pairs Q_k/P_(k-1) of mixed methods, whose pressures are stable for every k >= 2 (Boffi,
/// Brezzi, Fortin, Mixed Finite Element Methods, section 8.6). Tensor products of the same degree are twice
/// as many, and are not stable. They are polynomials in space and not in the coordinates of the unit cell,
/// because the latter hold no linear function where a cell is no parallelepiped, which costs an order (Boffi
/// and Gastaldi, Computing 69 (2002) 131-147).
template<int dim>
class ProjectedDivergence
{
public:
  /// `degree` is that of the displacement, at least 1.
  explicit ProjectedDivergence(const unsigned int degree)
      : fe_(degree - 1)
  {
  }

  /// Begins a cell with `n_dofs` degrees of freedom.
  void reset(const typename dealii::Triangulation<dim>::cell_iterator &cell, const Eigen::Index n_dofs)
  {
    cell_ = Parallelepiped<dim>(cell);
    mass_.setZero(n_polynomials(), n_polynomials());
    moments_.setZero(n_polynomials(), n_dofs);
  }

  /// Adds a quadrature point at `place` (mm): the degrees of freedom's divergences there (n_dofs, 1/mm), and
  /// its share of the volume (mm^3).
  void add(const dealii::Point<dim> &place, const Eigen::VectorXd &divergences, const double volume)
  {
    const Eigen::VectorXd values = polynomials_at(place);
    mass_.noalias() += (volume * values) * values.transpose();
    moments_.noalias() += (volume * values) * divergences.transpose();
  }

  /// Values of the polynomials of this cell at a place, mm.
  Eigen::VectorXd polynomials_at(const dealii::Point<dim> &place) const
  {
    // Products of Legendre's polynomials in the coordinates of the parallelepiped that is nearest to the
    // cell: any basis will do, but this one keeps the mass matrix well conditioned in flat cells at any
    // angle.
    const dealii::Point<dim> unit = cell_.coordinates(place);
    Eigen::VectorXd values(n_polynomials());
    for (unsigned int k = 0; k < fe_.n_dofs_per_cell(); ++k)
      values[k] = fe_.shape_value(k, unit);
    return values;
  }

  /// Column i has the polynomials' coefficients in the projected divergence of degree of freedom i, 1/mm.
  Eigen::MatrixXd coefficients() const { return mass_.llt().solve(moments_); }

  /// Integrals of the products of the projected divergences: n_dofs x n_dofs, mm.
  Eigen::MatrixXd products() const { return moments_.transpose() * coefficients(); }

private:
  Eigen::Index n_polynomials() const { return fe_.n_dofs_per_cell(); }

  dealii::FE_DGP<dim> fe_;
  Parallelepiped<dim> cell_;
  Eigen::MatrixXd mass_;
  Eigen::MatrixXd moments_; ///< of the divergences of the degrees of freedom
};
} // namespace orthocone
