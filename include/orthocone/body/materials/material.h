// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/materials/lame.h>
#include <orthocone/surface/model_symmetry.h>

#include <optional>
#include <string>

namespace orthocone
{
/// Linear elasticity at small strain by any law; the same in solids and sections. Nothing here throws.
class Material
{
public:
  explicit Material(const MaterialOptions &options)
      : lame_(options.isotropic()),
        anisotropic_(options.law.chosen().tangent()),
        law_(options.law_entry())
  {
  }

  bool is_isotropic() const { return !anisotropic_; }

  /// Why the material does not have the symmetry of a model; empty if it has. A file mirrors its regions.
  std::string asymmetry(const ModelSymmetry &symmetry) const;

  /// Stress (MPa) of a strain.
  Stress stress(const Strain &strain) const { return stress(strain, trace(strain)); }

  /// Stress (MPa) in elements whose change of volume is not the trace of `strain`.
  Stress stress(const Strain &strain, const double volume_change) const
  {
    const auto one = dealii::unit_symmetric_tensor<3>();
    if (anisotropic_)
      return *anisotropic_ * strain + lame_.lambda * (volume_change - trace(strain)) * one;
    return lame_.lambda * volume_change * one + 2 * lame_.mu * strain;
  }

  /// Derivative of the stress with respect to the strain, MPa.
  ElasticTangent tangent() const
  {
    return anisotropic_ ? *anisotropic_ : volumetric_tangent() + tangent_at_constant_volume();
  }

  /// The part of the tangent without the stress from the change of volume, MPa.
  ElasticTangent tangent_at_constant_volume() const
  {
    return anisotropic_ ? *anisotropic_ - volumetric_tangent() : 2 * lame_.mu * dealii::identity_tensor<3>();
  }

  double shear_modulus() const { return lame_.mu; } ///< MPa, for isotropic materials only

  /// What resists a change of volume by 1 and is no part of the tangent at constant volume, MPa: lambda, for
  /// anisotropic materials that of the isotropic average. It is less than their bulk modulus 1/(1 : S : 1),
  /// so that every strain stores energy without this part, too.
  double volumetric_modulus() const { return lame_.lambda; }

private:
  ElasticTangent volumetric_tangent() const
  {
    const auto one = dealii::unit_symmetric_tensor<3>();
    return lame_.lambda * outer_product(one, one);
  }

  LameParameters lame_; ///< of the isotropic average
  std::optional<ElasticTangent> anisotropic_;
  std::string law_; ///< "Material/Law = orthotropic"
};
} // namespace orthocone
