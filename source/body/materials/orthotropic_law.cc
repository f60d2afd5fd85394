// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/orthotropic_law.h>

#include <orthocone/base/errors.h>
#include <orthocone/body/options.h>

#include <Eigen/Dense>

#include <cmath>

namespace orthocone
{
Kind<MaterialLaw> orthotropic_law()
{
  return {"orthotropic", "with the nine constants below, along x, y and z",
          [] { return std::make_unique<OrthotropicLaw>(); }};
}

// They are not said to be ignored with another law: files have both kinds of constants, and choose.
void OrthotropicLaw::declare(Section &section, const Condition &)
{
  const Codec<std::array<double, 3>> moduli = three_numbers_codec(positive);
  section
      .add("Young moduli", young_moduli, moduli,
           "Young's moduli E_x, E_y, E_z of an orthotropic body in MPa.")
      .unit("MPa");
  section.add("Poisson ratios", poisson_ratios, three_numbers_codec(any_number),
              "Poisson's ratios nu_xy, nu_xz, nu_yz of an orthotropic body: nu_xy = -strain along y / strain "
              "along x under a stress along x alone.");
  section
      .add("Shear moduli", shear_moduli, moduli,
           "Shear moduli G_xy, G_xz, G_yz of an orthotropic body in MPa.")
      .unit("MPa");
}

std::optional<ElasticTangent> OrthotropicLaw::tangent() const
{
  constexpr std::array<std::array<unsigned int, 2>, 3> planes{{{{0, 1}}, {{0, 2}}, {{1, 2}}}}; // xy, xz, yz
  Eigen::Matrix3d compliance;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto [a, b] = planes[i];
    compliance(i, i) = 1 / young_moduli[i];
    compliance(a, b) = compliance(b, a) = -poisson_ratios[i] / young_moduli[a];
  }
  const Eigen::Matrix3d normal = compliance.inverse();
  ElasticTangent tangent;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto [a, b] = planes[i];
    tangent[a][b][a][b] = shear_moduli[i]; // stress = 2 G strain, half of it for each of xy and yx
    for (unsigned int j = 0; j < 3; ++j)
      tangent[i][i][j][j] = (normal(i, j) + normal(j, i)) / 2;
  }
  return tangent;
}

/// Requires the leading minors of the compliance, each times the moduli of its axes, to be positive
/// (docs/theory.md, section 2, "Materials").
void OrthotropicLaw::check(const MaterialOptions &material) const
{
  const auto &[e_x, e_y, e_z] = young_moduli;
  const auto &[nu_xy, nu_xz, nu_yz] = poisson_ratios;
  const double xy = nu_xy * nu_xy * e_y / e_x, xz = nu_xz * nu_xz * e_z / e_x, yz = nu_yz * nu_yz * e_z / e_y;
  const double all = 1 - xy - xz - yz - 2 * nu_xy * nu_yz * nu_xz * e_z / e_x;
  if (xy < 1 && xz < 1 && yz < 1 && all > 0)
    return;
  const std::string ratios = to_text(nu_xy) + ", " + to_text(nu_xz) + ", " + to_text(nu_yz);
  throw InputError(material.section + "/Poisson ratios = " + ratios +
                   " with these Young moduli do not store energy under every strain: allowed are |nu_xy| < "
                   "sqrt(E_x/E_y) = " +
                   to_text(std::sqrt(e_x / e_y)) +
                   ", |nu_xz| < sqrt(E_x/E_z) = " + to_text(std::sqrt(e_x / e_z)) +
                   ", |nu_yz| < sqrt(E_y/E_z) = " + to_text(std::sqrt(e_y / e_z)) +
                   " and 1 - nu_xy^2 E_y/E_x - nu_xz^2 E_z/E_x - nu_yz^2 E_z/E_y - 2 nu_xy nu_yz nu_xz "
                   "E_z/E_x > 0");
}

IsotropicConstants OrthotropicLaw::average() const
{
  double along = 0, shear = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    along += 1 / young_moduli[i];
    shear += 1 / shear_moduli[i];
  }
  const auto &[nu_xy, nu_xz, nu_yz] = poisson_ratios;
  const double across = -(nu_xy + nu_xz) / young_moduli[0] - nu_yz / young_moduli[1];
  return reuss_average(along, across, shear);
}
} // namespace orthocone
