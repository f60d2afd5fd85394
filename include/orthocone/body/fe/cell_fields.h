// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/fe/projected_divergence.h>
#include <orthocone/body/materials/materials.h>

#include <deal.II/fe/fe_values.h>

#include <optional>
#include <vector>

namespace orthocone
{
/// Fields at a point of the body. A section lies in the plane y = 0: its r is x, its hoop direction is y.
struct PointFields
{
  Eigen::Vector3d place = Eigen::Vector3d::Zero();        ///< mm
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero(); ///< mm
  Stress stress{};                                        ///< MPa
  double volume_change = 0; ///< relative, of the elastic strain, as it is in the stress
  double stress_error = 0;  ///< estimated, as a von Mises stress, MPa; where it is known
  unsigned int volume = 0;  ///< number of the physical volume of a mesh file; 0 otherwise
};

/// Fields of a displacement, at the same points in one cell after the other.
///
/// With projected volumetric quadrature the stress has the projected change of volume (ProjectedDivergence).
/// The pointwise change of volume would be noise where the material is nearly incompressible, and lambda
/// times this noise would be much larger than the stress (docs/theory.md, section 2).
template<int dim>
class CellFields
{
public:
  /// `points` are in the unit cell; `displacement` (mm) is of all degrees of freedom, size n_dofs(). `space`
  /// and `displacement` must outlive this object. `free_strain` causes no stress.
  CellFields(const DisplacementSpace<dim> &space, const Materials &materials,
             const dealii::Quadrature<dim> &points, const Eigen::VectorXd &displacement,
             const Strain &free_strain = {});

  /// The fields at the points of a cell, in the order of the points.
  std::vector<PointFields> in(const typename DisplacementSpace<dim>::Cell &cell);

private:
  Eigen::VectorXd nodal_values(const typename DisplacementSpace<dim>::Cell &cell) const;
  Eigen::VectorXd projected_volume_changes(const typename DisplacementSpace<dim>::Cell &cell,
                                           const Eigen::VectorXd &nodal);

  const DisplacementSpace<dim> &space_;
  const Eigen::VectorXd &displacement_;
  const Strain free_strain_;
  Materials materials_;
  dealii::FEValues<dim> values_;
  dealii::FEValues<dim> quadrature_values_; ///< with projected volumetric quadrature only, as the next one
  ProjectedDivergence<dim> divergence_;
};
} // namespace orthocone
