// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "strain_terms.h"

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/fe/projected_divergence.h>
#include <orthocone/body/materials/materials.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <optional>

namespace orthocone
{
/// Computes the stiffness of one cell after the other; in a section, that of its rings or its thickness.
template<int dim>
class CellStiffness
{
public:
  CellStiffness(const DisplacementSpace<dim> &space, const Materials &materials);
  CellStiffness(const CellStiffness &other);

  /// Numbered n_components a + c by scalar node a and component c; N/mm.
  const Eigen::MatrixXd &of(const typename DisplacementSpace<dim>::Cell &cell);

private:
  void take(const Material &material);
  void integrate();
  void combine();
  void combine_by_factors();

  static constexpr unsigned int n_terms = 3, most_components = 3;
  const DisplacementSpace<dim> &space_;
  StrainTerms<dim> strain_terms_;
  dealii::FEValues<dim> values_;
  std::optional<ProjectedDivergence<dim>> divergence_; ///< with projected volumetric quadrature
  Materials materials_;
  const Material *material_ = nullptr; ///< the next numbers are its own
  double volumetric_modulus_ = 0;
  double lambda_ = 0; ///< the part in combine(): 0 with projected volumetric quadrature
  double mu_ = 0;
  /// For each pair of components (most_components c + d) the factors by which the products of terms of two
  /// nodes contribute to their entry (c, d).
  std::array<Eigen::Matrix3d, static_cast<std::size_t>(most_components *most_components)> factors_;
  std::array<Eigen::Vector3d, most_components> divergence_factors_; ///< of the terms, by components
  Eigen::MatrixXd terms_;       ///< n_terms a node, a column for each quadrature point
  Eigen::VectorXd volumes_;     ///< of the quadrature points
  Eigen::VectorXd divergences_; ///< at a quadrature point
  Eigen::MatrixXd products_;    ///< integrals of the products of terms
  Eigen::MatrixXd matrix_;
};
} // namespace orthocone
