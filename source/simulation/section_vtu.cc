// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/elasticity/projected_divergence.h>
#include <orthocone/simulation/vtu.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
using Stress = dealii::SymmetricTensor<2, 3>;
using Patch = dealii::DataOutBase::Patch<2, 3>;
using Gradient = dealii::Tensor<1, 2>;
constexpr unsigned int n_rows = 3 + 9 + 1; // displacement, stress, von Mises stress

/// Displacement (u_r, u_z) and its gradients at a point of the section.
struct PointValues
{
  double radius = 0;
  std::array<double, 2> displacement{{0, 0}};
  std::array<Gradient, 2> gradients{};
};

/// In the plane y = 0, where r is x and the hoop direction y.
Stress strain_of(const PointValues &point)
{
  Stress strain;
  strain[0][0] = point.gradients[0][0];
  // On the axis u_r / r is the derivative.
  strain[1][1] = point.radius > 0 ? point.displacement[0] / point.radius : point.gradients[0][0];
  strain[2][2] = point.gradients[1][1];
  strain[0][2] = 0.5 * (point.gradients[0][1] + point.gradients[1][0]);
  return strain;
}

void fill_column(const PointValues &point, const double height, const Stress &stress,
                 const unsigned int column, dealii::Table<2, float> &data)
{
  const std::array<double, 3> displacement{{point.displacement[0], 0, point.displacement[1]}};
  const std::array<double, 3> place{{point.radius, 0, height}};
  for (unsigned int i = 0; i < 3; ++i)
  {
    data(i, column) = static_cast<float>(displacement[i]);
    data(n_rows + i, column) = static_cast<float>(place[i]);
    for (unsigned int j = 0; j < 3; ++j)
      data(3 + 3 * i + j, column) = static_cast<float>(stress[i][j]);
  }
  data(n_rows - 1, column) = static_cast<float>(std::sqrt(1.5) * deviator(stress).norm());
}

/// Values of the nodes of FE_Q in a cell at (2 a + c), scalar node a and component c.
Eigen::VectorXd nodal_values(const SectionDiscretization &discretization,
                             const SectionDiscretization::Cell &cell, const Eigen::VectorXd &displacement)
{
  std::vector<dealii::types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  Eigen::VectorXd values(dofs.size());
  for (unsigned int i = 0; i < dofs.size(); ++i)
  {
    const auto [component, node] = discretization.fe().system_to_component_index(i);
    values[2 * node + component] = displacement[static_cast<Eigen::Index>(dofs[i])];
  }
  return discretization.has_axis_face(cell) ? Eigen::VectorXd(discretization.axis_face_basis() * values)
                                            : values;
}

PointValues values_at(const dealii::FEValues<2> &values, const unsigned int q, const Eigen::VectorXd &nodal)
{
  PointValues point;
  point.radius = values.quadrature_point(q)[0];
  for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
    for (unsigned int c = 0; c < 2; ++c)
    {
      point.displacement[c] += nodal[2 * a + c] * values.shape_value(a, q);
      point.gradients[c] += nodal[2 * a + c] * values.shape_grad(a, q);
    }
  return point;
}

/// The change of volume that the reduced quadrature sees, at the points of output of a cell.
class ProjectedVolumeChange
{
public:
  ProjectedVolumeChange(const SectionDiscretization &discretization, const dealii::Quadrature<2> &points)
      : values_(discretization.mapping(), discretization.scalar_fe(),
                dealii::QGauss<2>(discretization.n_quadrature_points()),
                dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                    dealii::update_JxW_values),
        divergence_(discretization.scalar_fe().degree, values_.get_quadrature()),
        polynomials_(
            ProjectedDivergence<2>(discretization.scalar_fe().degree, points).polynomials().transpose())
  {
  }

  Eigen::VectorXd in(const SectionDiscretization::Cell &cell, const Eigen::VectorXd &nodal)
  {
    values_.reinit(dealii::Triangulation<2>::active_cell_iterator(cell));
    divergence_.reset(1);
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      const PointValues point = values_at(values_, q, nodal);
      divergence_.add(q, Eigen::VectorXd::Constant(1, trace(strain_of(point))),
                      point.radius * values_.JxW(q));
    }
    return polynomials_ * divergence_.coefficients();
  }

private:
  dealii::FEValues<2> values_;
  ProjectedDivergence<2> divergence_;
  Eigen::MatrixXd polynomials_;
};

/// `volume_changes` at the points replace those of the displacement; empty: they do not.
void fill(const dealii::FEValues<2> &values, const Eigen::VectorXd &nodal,
          const Eigen::VectorXd &volume_changes, const LameParameters &lame, Patch &patch)
{
  patch.data.reinit(n_rows + 3, values.n_quadrature_points);
  for (const unsigned int q : values.quadrature_point_indices())
  {
    const PointValues point = values_at(values, q, nodal);
    const Stress strain = strain_of(point);
    const double volume_change = volume_changes.size() == 0 ? trace(strain) : volume_changes[q];
    fill_column(point, values.quadrature_point(q)[1],
                lame.lambda * volume_change * dealii::unit_symmetric_tensor<3>() + 2 * lame.mu * strain, q,
                patch.data);
  }
}
} // namespace

std::string volume_vtu(const SectionDiscretization &discretization, const MaterialOptions &material,
                       const Eigen::VectorXd &displacement)
{
  const LameParameters lame(material);
  const unsigned int degree = discretization.fe().degree;
  const dealii::QIterated<2> points(dealii::QTrapezoid<1>(), degree);
  dealii::FEValues<2> values(discretization.mapping(), discretization.scalar_fe(), points,
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points);
  const bool is_reduced = discretization.volumetric_quadrature() == VolumetricQuadrature::reduced;
  ProjectedVolumeChange volume_change(discretization, points);
  std::vector<Patch> patches;
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(dealii::Triangulation<2>::active_cell_iterator(cell));
    const Eigen::VectorXd nodal = nodal_values(discretization, cell, displacement);
    patches.emplace_back();
    Patch &patch = patches.back();
    patch.patch_index = patches.size() - 1;
    patch.reference_cell = dealii::ReferenceCells::Quadrilateral; // its constructor leaves it invalid
    patch.n_subdivisions = degree;
    patch.points_are_available = true;
    fill(values, nodal, is_reduced ? volume_change.in(cell, nodal) : Eigen::VectorXd(), lame, patch);
  }
  std::vector<std::string> names(3, "displacement");
  names.insert(names.end(), 9, "stress");
  names.emplace_back("von_mises_stress");
  using namespace dealii::DataComponentInterpretation;
  std::ostringstream text;
  dealii::DataOutBase::write_vtu(
      patches, names,
      {{0, 2, "displacement", component_is_part_of_vector}, {3, 11, "stress", component_is_part_of_tensor}},
      lagrange_vtu_flags(degree), text);
  return text.str();
}
} // namespace orthocone
