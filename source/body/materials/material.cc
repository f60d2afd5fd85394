// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material.h>

namespace orthocone
{
namespace
{
/// Whether a mirror normal to an axis leaves the tangent as it is: no component has the axis an odd number of
/// times.
bool is_mirrored(const ElasticTangent &tangent, const unsigned int axis)
{
  constexpr double rounding = 1e-12;
  double odd = 0;
  for (unsigned int i = 0; i < 81; ++i)
  {
    const std::array<unsigned int, 4> index{{i / 27, i / 9 % 3, i / 3 % 3, i % 3}};
    if (std::count(index.begin(), index.end(), axis) % 2 == 1)
      odd = std::max(odd, std::abs(tangent[index[0]][index[1]][index[2]][index[3]]));
  }
  return odd <= rounding * tangent.norm();
}
} // namespace

std::string Material::asymmetry(const ModelSymmetry &symmetry) const
{
  if (is_isotropic())
    return "";
  if (symmetry.is_axisymmetric())
    return law_ + " has axes along x and y";
  const SymmetryPlanes &planes = symmetry.planes();
  if ((planes.normal_to_x && !is_mirrored(*anisotropic_, 0)) ||
      (planes.normal_to_y && !is_mirrored(*anisotropic_, 1)))
    return law_ + " has other axes than x, y and z";
  return "";
}
} // namespace orthocone
