// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/elasticity/projected_divergence.h>
#include <orthocone/simulation/vtu.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
using Stress = dealii::SymmetricTensor<2, 3>;

Stress strain_of(const std::vector<dealii::Tensor<1, 3>> &gradients)
{
  Stress strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = 0.5 * (gradients[i][j] + gradients[j][i]);
  return strain;
}

/// The points of a cell where output is written, the same in all.
dealii::Quadrature<3> output_points(const unsigned int degree)
{
  return dealii::QIterated<3>(dealii::QTrapezoid<1>(), degree);
}

/// For every cell, at its points of output, the change of volume that the reduced quadrature sees. That of
/// the displacement itself is noise where the material is nearly incompressible, and lambda times it much
/// larger than the stress.
std::vector<Eigen::VectorXd> projected_volume_changes(const Discretization &discretization,
                                                      const dealii::Vector<double> &displacement)
{
  const unsigned int degree = discretization.fe().degree;
  const dealii::QGauss<3> quadrature(discretization.n_quadrature_points());
  dealii::FEValues<3> values(discretization.mapping(), discretization.fe(), quadrature,
                             dealii::update_gradients | dealii::update_JxW_values);
  ProjectedDivergence<3> divergence(degree, quadrature);
  const Eigen::MatrixXd polynomials =
      ProjectedDivergence<3>(degree, output_points(degree)).polynomials().transpose();
  std::vector<double> divergences(quadrature.size());
  std::vector<Eigen::VectorXd> changes(discretization.n_cells());
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(cell);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_divergences(displacement, divergences);
    divergence.reset(1);
    for (const unsigned int q : values.quadrature_point_indices())
      divergence.add(q, Eigen::VectorXd::Constant(1, divergences[q]), values.JxW(q));
    changes[cell->active_cell_index()] = polynomials * divergence.coefficients();
  }
  return changes;
}

/// Stress (nine components) and von Mises stress, from one evaluation of the gradients. `volume_changes` of
/// every cell at its points replace those of the gradients; empty: none do.
class StressOutput : public dealii::DataPostprocessor<3>
{
public:
  StressOutput(const LameParameters &lame, std::vector<Eigen::VectorXd> volume_changes)
      : lame_(lame),
        volume_changes_(std::move(volume_changes))
  {
  }

  std::vector<std::string> get_names() const override
  {
    std::vector<std::string> names(n_components, "stress");
    names.emplace_back("von_mises_stress");
    return names;
  }

  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    using namespace dealii::DataComponentInterpretation;
    std::vector<DataComponentInterpretation> kinds(n_components, component_is_part_of_tensor);
    kinds.push_back(component_is_scalar);
    return kinds;
  }

  dealii::UpdateFlags get_needed_update_flags() const override { return dealii::update_gradients; }

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<3> &input,
                             std::vector<dealii::Vector<double>> &computed) const override
  {
    for (unsigned int p = 0; p < computed.size(); ++p)
    {
      const Stress strain = strain_of(input.solution_gradients[p]);
      const double volume_change = volume_changes_.empty()
                                       ? trace(strain)
                                       : volume_changes_[input.get_cell<3>()->active_cell_index()][p];
      const Stress stress =
          lame_.lambda * volume_change * dealii::unit_symmetric_tensor<3>() + 2 * lame_.mu * strain;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          computed[p][dealii::Tensor<2, 3>::component_to_unrolled_index({i, j})] = stress[i][j];
      computed[p][n_components] = std::sqrt(1.5) * deviator(stress).norm();
    }
  }

private:
  static constexpr unsigned int n_components = dealii::Tensor<2, 3>::n_independent_components;

  LameParameters lame_;
  std::vector<Eigen::VectorXd> volume_changes_;
};
} // namespace

std::string volume_vtu(const Discretization &discretization, const MaterialOptions &material,
                       const Eigen::VectorXd &displacement)
{
  const dealii::Vector<double> values(displacement.begin(), displacement.end());
  const bool is_reduced = discretization.volumetric_quadrature() == VolumetricQuadrature::reduced;
  const StressOutput stress(LameParameters(material), is_reduced
                                                          ? projected_volume_changes(discretization, values)
                                                          : std::vector<Eigen::VectorXd>());
  dealii::DataOut<3> data;
  data.attach_dof_handler(discretization.dof_handler());
  data.add_data_vector(values, std::vector<std::string>(3, "displacement"), dealii::DataOut<3>::type_dof_data,
                       {3, dealii::DataComponentInterpretation::component_is_part_of_vector});
  data.add_data_vector(values, stress);
  const unsigned int degree = discretization.fe().degree;
  data.build_patches(discretization.mapping(), degree, dealii::DataOut<3>::curved_inner_cells);
  data.set_flags(vtu_flags());
  std::ostringstream text;
  data.write_vtu(text);
  return text.str();
}
} // namespace orthocone
