// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/materials/lame.h>

#include <deal.II/base/symmetric_tensor.h>

namespace orthocone
{
using Strain = dealii::SymmetricTensor<2, 3>;
using Stress = dealii::SymmetricTensor<2, 3>;         ///< MPa
using ElasticTangent = dealii::SymmetricTensor<4, 3>; ///< MPa

/// Isotropic linear elasticity at small strain, the same in solids and sections.
class Material
{
public:
  explicit Material(const MaterialOptions &options)
      : lame_(options)
  {
  }

  Stress stress(const Strain &strain) const { return stress(strain, trace(strain)); }

  /// Of elements that see another change of volume than the trace of `strain`.
  Stress stress(const Strain &strain, const double volume_change) const
  {
    return lame_.lambda * volume_change * dealii::unit_symmetric_tensor<3>() + 2 * lame_.mu * strain;
  }

  /// Derivative of the stress by the strain.
  ElasticTangent tangent() const
  {
    const auto one = dealii::unit_symmetric_tensor<3>();
    return lame_.lambda * outer_product(one, one) + tangent_at_constant_volume();
  }

  /// What is left of it if the stress from the change of volume is taken care of elsewhere.
  ElasticTangent tangent_at_constant_volume() const { return 2 * lame_.mu * dealii::identity_tensor<3>(); }

  double shear_modulus() const { return lame_.mu; } ///< MPa

  /// Stress from a change of volume by 1, MPa.
  double volumetric_modulus() const { return lame_.lambda; }

private:
  LameParameters lame_;
};
} // namespace orthocone
