// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/simulation/vtu.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
using Stress = dealii::SymmetricTensor<2, 3>;

/// Stress of a displacement gradient: lambda tr(eps) 1 + 2 mu eps.
Stress stress_of(const std::vector<dealii::Tensor<1, 3>> &gradients, const LameParameters &lame)
{
  Stress strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = 0.5 * (gradients[i][j] + gradients[j][i]);
  return lame.lambda * trace(strain) * dealii::unit_symmetric_tensor<3>() + 2 * lame.mu * strain;
}

/// Stress (nine components) and von Mises stress, from one evaluation of the gradients.
class StressOutput : public dealii::DataPostprocessor<3>
{
public:
  explicit StressOutput(const LameParameters &lame)
      : lame_(lame)
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
      const Stress stress = stress_of(input.solution_gradients[p], lame_);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          computed[p][dealii::Tensor<2, 3>::component_to_unrolled_index({i, j})] = stress[i][j];
      computed[p][n_components] = std::sqrt(1.5) * deviator(stress).norm();
    }
  }

private:
  static constexpr unsigned int n_components = dealii::Tensor<2, 3>::n_independent_components;

  LameParameters lame_;
};
} // namespace

std::string volume_vtu(const Discretization &discretization, const MaterialOptions &material,
                       const Eigen::VectorXd &displacement)
{
  const dealii::Vector<double> values(displacement.begin(), displacement.end());
  const LameParameters lame(material);
  const StressOutput stress(lame);
  dealii::DataOut<3> data;
  data.attach_dof_handler(discretization.dof_handler());
  data.add_data_vector(values, std::vector<std::string>(3, "displacement"), dealii::DataOut<3>::type_dof_data,
                       {3, dealii::DataComponentInterpretation::component_is_part_of_vector});
  data.add_data_vector(values, stress);
  const unsigned int degree = discretization.fe().degree;
  data.build_patches(discretization.mapping(), degree, dealii::DataOut<3>::curved_inner_cells);
  data.set_flags(vtu_flags(degree));
  std::ostringstream text;
  data.write_vtu(text);
  return text.str();
}
} // namespace orthocone
