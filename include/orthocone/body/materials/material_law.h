// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/choice.h>

#include <deal.II/base/symmetric_tensor.h>

#include <optional>

namespace orthocone
{
using Strain = dealii::SymmetricTensor<2, 3>;
using Stress = dealii::SymmetricTensor<2, 3>;         ///< MPa
using ElasticTangent = dealii::SymmetricTensor<4, 3>; ///< MPa

struct MaterialOptions;

struct IsotropicConstants
{
  double young_modulus; ///< MPa
  double poisson_ratio;
};

/// Reuss's average over all directions (Hill, Proc. Phys. Soc. A 65 (1952) 349-354) of a compliance S in
/// 1/MPa: `along` is the sum of all S_iiii, `across` that of S_iijj for i < j, `shear` that of 4 S_ijij for
/// i < j.
IsotropicConstants reuss_average(double along, double across, double shear);

/// A law of linear elasticity at small strain: its constants, which are entries of section Material. Axes are
/// x, y and z of the scene.
class MaterialLaw
{
public:
  virtual ~MaterialLaw() = default;
  virtual std::unique_ptr<MaterialLaw> clone() const = 0;

  /// Adds the entries of this law.
  virtual void declare(Section &, const Condition & /*is_chosen*/) {}

  /// Derivative of the stress with respect to the strain, MPa; nothing for the isotropic law, whose constants
  /// are MaterialOptions::young_modulus and poisson_ratio.
  virtual std::optional<ElasticTangent> tangent() const = 0;

  /// Throws InputError unless every strain stores energy. `material` is what chose this law.
  virtual void check(const MaterialOptions &material) const;

  /// The isotropic average, which only laws with a tangent need: Reuss's one of that tangent.
  virtual IsotropicConstants average() const;

  /// What warnings call its Poisson's ratios, behind "Material/".
  virtual std::string poisson_ratios_entry() const { return "Law: Poisson's ratios"; }
};

template<>
std::vector<Kind<MaterialLaw>> &kinds_of<MaterialLaw>();
} // namespace orthocone
