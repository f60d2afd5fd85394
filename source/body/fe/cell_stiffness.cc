// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_stiffness.h"

namespace orthocone
{
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace
{
/// Factors of the products of terms in the entry of components c and d.
template<int dim>
Matrix3d factors_of(const StrainTerms<dim> &terms, const ElasticTangent &tangent, const unsigned int c,
                    const unsigned int d)
{
  Matrix3d factors = Matrix3d::Zero();
  for (unsigned int m = 0; m < 3; ++m)
    for (unsigned int n = 0; n < 3; ++n)
    {
      const auto first = terms.place(c, m), second = terms.place(d, n);
      if (first && second)
        factors(m, n) =
            first->sign * second->sign * tangent[first->row][first->column][second->row][second->column];
    }
  return factors;
}

/// Which terms of a component are changes of volume.
template<int dim>
Vector3d divergence_factors_of(const StrainTerms<dim> &terms, const unsigned int c)
{
  Vector3d factors = Vector3d::Zero();
  for (unsigned int m = 0; m < 3; ++m)
    if (const auto place = terms.place(c, m); place && place->row == place->column)
      factors[m] = 1;
  return factors;
}
} // namespace

template<int dim>
CellStiffness<dim>::CellStiffness(const DisplacementSpace<dim> &space, const Materials &materials)
    : space_(space),
      strain_terms_(space.section()),
      values_(space.mapping(), space.scalar_fe(), dealii::QGauss<dim>(space.n_quadrature_points()),
              dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                  dealii::update_JxW_values),
      materials_(materials)
{
  if (space.volumetric_quadrature() == VolumetricQuadrature::projected)
    divergence_.emplace(space.scalar_fe().degree);
  for (unsigned int c = 0; c < space.n_components(); ++c)
    divergence_factors_[c] = divergence_factors_of(strain_terms_, c);
}

template<int dim>
void CellStiffness<dim>::take(const Material &material)
{
  if (material_ == &material)
    return;
  material_ = &material;
  const bool is_projected = divergence_.has_value();
  volumetric_modulus_ = material.volumetric_modulus();
  lambda_ = is_projected ? 0 : volumetric_modulus_;
  mu_ = material.shear_modulus();
  const ElasticTangent tangent = is_projected ? material.tangent_at_constant_volume() : material.tangent();
  for (unsigned int c = 0; c < space_.n_components(); ++c)
    for (unsigned int d = 0; d < space_.n_components(); ++d)
      factors_[most_components * c + d] = factors_of(strain_terms_, tangent, c, d);
}

// FEValues cannot be copied.
template<int dim>
CellStiffness<dim>::CellStiffness(const CellStiffness &other)
    : space_(other.space_),
      strain_terms_(other.strain_terms_),
      values_(other.values_.get_mapping(), other.values_.get_fe(), other.values_.get_quadrature(),
              other.values_.get_update_flags()),
      divergence_(other.divergence_),
      materials_(other.materials_),
      divergence_factors_(other.divergence_factors_)
{
}

/// The products of all quadrature points are one product of matrices, which takes a tenth of the time that
/// they take one after the other.
template<int dim>
void CellStiffness<dim>::integrate()
{
  const unsigned int n_nodes = values_.dofs_per_cell, n_components = space_.n_components();
  terms_.resize(n_terms * n_nodes, values_.n_quadrature_points);
  volumes_.resize(values_.n_quadrature_points);
  divergences_.resize(n_components * n_nodes);
  if (divergence_)
    divergence_->reset(values_.get_cell(), divergences_.size());
  for (const unsigned int q : values_.quadrature_point_indices())
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      terms_.template block<n_terms, 1>(n_terms * a, q) = strain_terms_.of(values_, a, q);
    volumes_[q] = strain_terms_.volume(values_, q);
    if (!divergence_)
      continue;
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int c = 0; c < n_components; ++c)
        divergences_[n_components * a + c] =
            divergence_factors_[c].dot(terms_.template block<n_terms, 1>(n_terms * a, q));
    divergence_->add(values_.quadrature_point(q), divergences_, volumes_[q]);
  }
  products_.noalias() = (terms_ * volumes_.asDiagonal()) * terms_.transpose();
}

template<int dim>
void CellStiffness<dim>::combine_by_factors()
{
  const Eigen::Index n_nodes = values_.dofs_per_cell, n = space_.n_components();
  matrix_.resize(n * n_nodes, n * n_nodes);
  for (Eigen::Index b = 0; b < n_nodes; ++b)
    for (Eigen::Index a = 0; a < n_nodes; ++a)
      for (Eigen::Index c = 0; c < n; ++c)
        for (Eigen::Index d = 0; d < n; ++d)
          matrix_(n * a + c, n * b + d) =
              factors_[most_components * c + d].cwiseProduct(products_.block<3, 3>(3 * a, 3 * b)).sum();
}

/// Hooke's law in closed form: lambda d_i N_a d_j N_b + mu (d_j N_a d_i N_b + delta_ij grad N_a . grad N_b).
template<>
void CellStiffness<3>::combine()
{
  if (!material_->is_isotropic())
    return combine_by_factors();
  matrix_.resizeLike(products_);
  for (Eigen::Index b = 0; b < products_.cols(); b += 3)
    for (Eigen::Index a = 0; a < products_.rows(); a += 3)
    {
      const Matrix3d block = products_.block<3, 3>(a, b);
      matrix_.block<3, 3>(a, b) =
          lambda_ * block + mu_ * block.transpose() + mu_ * block.trace() * Matrix3d::Identity();
    }
}

template<>
void CellStiffness<2>::combine()
{
  combine_by_factors();
}

template<int dim>
const MatrixXd &CellStiffness<dim>::of(const typename DisplacementSpace<dim>::Cell &cell)
{
  take(materials_.of(cell->material_id()));
  values_.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell));
  integrate();
  combine();
  if (divergence_)
    matrix_ += volumetric_modulus_ * divergence_->products();
  if (space_.has_axis_face(cell))
    matrix_ = (space_.axis_face_basis().transpose() * matrix_ * space_.axis_face_basis()).eval();
  return matrix_;
}

template class CellStiffness<2>;
template class CellStiffness<3>;
} // namespace orthocone
