// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/materials/material_law.h>

namespace orthocone
{
/// Orthotropic elasticity along x, y, z (docs/theory.md, section 2, "Materials"). nu_xy is - strain along y /
/// strain along x under a stress along x alone.
class OrthotropicLaw : public MaterialLaw
{
public:
  std::unique_ptr<MaterialLaw> clone() const override { return std::make_unique<OrthotropicLaw>(*this); }
  void declare(Section &section, const Condition &is_chosen) override;

  /// The inverse of the compliance that the nine constants define. Does not check that every strain stores
  /// energy.
  std::optional<ElasticTangent> tangent() const override;

  void check(const MaterialOptions &material) const override;
  IsotropicConstants average() const override;
  std::string poisson_ratios_entry() const override { return "Poisson ratios"; }

  std::array<double, 3> young_moduli{{210000, 210000, 210000}}; ///< E_x, E_y, E_z, MPa
  std::array<double, 3> poisson_ratios{{0.3, 0.3, 0.3}};        ///< nu_xy, nu_xz, nu_yz
  std::array<double, 3> shear_moduli{{80000, 80000, 80000}};    ///< G_xy, G_xz, G_yz, MPa
};
} // namespace orthocone
