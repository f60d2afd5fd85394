// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material_law.h>

#include <orthocone/base/errors.h>
#include <orthocone/body/options.h>

#include <Eigen/Dense>

namespace orthocone
{
// Each in a file of its name, which may be compiled together with this one.
// NOLINTBEGIN(readability-redundant-declaration)
Kind<MaterialLaw> isotropic_law();
Kind<MaterialLaw> orthotropic_law();
// NOLINTEND(readability-redundant-declaration)

template<>
std::vector<Kind<MaterialLaw>> &kinds_of<MaterialLaw>()
{
  static std::vector<Kind<MaterialLaw>> kinds{isotropic_law(), orthotropic_law()};
  return kinds;
}

namespace
{
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The tangent in an orthonormal basis of strains (Kelvin's): its eigenvalues are those of the tensor, and
/// its inverse that tensor's.
Matrix6 in_basis_of_strains(const ElasticTangent &tangent)
{
  constexpr std::array<std::array<unsigned int, 2>, 6> pairs{
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};
  const auto length = [](const Eigen::Index a) { return a < 3 ? 1 : std::sqrt(2.); };
  Matrix6 matrix;
  for (Eigen::Index a = 0; a < 6; ++a)
    for (Eigen::Index b = 0; b < 6; ++b)
    {
      const auto [i, j] = pairs[static_cast<std::size_t>(a)];
      const auto [k, l] = pairs[static_cast<std::size_t>(b)];
      matrix(a, b) = length(a) * length(b) * tangent[i][j][k][l];
    }
  return matrix;
}
} // namespace

// 1/K is the sum of all S_iijj, and 15/G = 4 sum S_iiii - 4 sum_{i<j} S_iijj + 3 sum_{i<j} 4 S_ijij.
IsotropicConstants reuss_average(const double along, const double across, const double shear)
{
  const double bulk_modulus = 1 / (along + 2 * across),
               shear_modulus = 15 / (4 * along - 4 * across + 3 * shear);
  return {9 * bulk_modulus * shear_modulus / (3 * bulk_modulus + shear_modulus),
          (3 * bulk_modulus - 2 * shear_modulus) / (2 * (3 * bulk_modulus + shear_modulus))};
}

void MaterialLaw::check(const MaterialOptions &material) const
{
  const double least =
      Eigen::SelfAdjointEigenSolver<Matrix6>(in_basis_of_strains(*tangent())).eigenvalues().minCoeff();
  if (!(least > 0))
    throw InputError(material.law_entry() +
                     ": its constants do not store energy under every strain: allowed are constants whose "
                     "least stiffness, now " +
                     to_text(least) + " MPa, is > 0");
}

IsotropicConstants MaterialLaw::average() const
{
  const Matrix6 s = in_basis_of_strains(*tangent()).inverse();
  return reuss_average(s.diagonal().head<3>().sum(), s(0, 1) + s(0, 2) + s(1, 2),
                       2 * s.diagonal().tail<3>().sum());
}
} // namespace orthocone
