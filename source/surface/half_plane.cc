// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_plane.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

namespace
{
/// The strip of surface that a line's weight stands for, from `first` to `last` along x, mm.
struct LinePatch
{
  double first, last;

  double width() const { return last - first; }
  LinePatch mirrored() const { return {-last, -first}; }
};

/// The patches of the nodes, side by side in the order of the nodes along x.
std::vector<LinePatch> patches_of_lines(const ContactSurface &surface, const double thickness)
{
  std::vector<std::size_t> order(surface.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto x = [&](const std::size_t node) { return surface.nodes[node].position[0]; };
  std::sort(order.begin(), order.end(), [&](const auto a, const auto b) { return x(a) < x(b); });
  std::vector<LinePatch> patches(order.size());
  double end = x(order.front());
  for (const std::size_t node : order)
  {
    const double first = end;
    end += surface.nodes[node].area / thickness;
    patches[node] = {first, end};
  }
  return patches;
}

/// Mean of f over both patches, of the difference of their places, by its second integral.
template<typename Integral>
double mean_of(const LinePatch &to, const LinePatch &from, const Integral &second)
{
  return (second(to.last - from.first) + second(to.first - from.last) - second(to.last - from.last) -
          second(to.first - from.first)) /
         (to.width() * from.width());
}

/// Of the logarithm of |x| / datum, and of the sign of x.
double mean_logarithm(const LinePatch &to, const LinePatch &from, const double datum)
{
  return mean_of(to, from,
                 [datum](const double x)
                 { return x == 0 ? 0 : x * x / 2 * (std::log(std::abs(x) / datum) - 1.5); });
}
double mean_sign(const LinePatch &to, const LinePatch &from)
{
  return mean_of(to, from, [](const double x) { return x * std::abs(x) / 2; });
}

/// Mean displacements (x, y, z) of a patch under unit forces that are spread over another one. With the
/// coefficients per length, a force along z moves points along z by -2 (1 - nu^2)/(pi E) ln(|x|/d) and along
/// x by (1 - 2 nu)(1 + nu)/(2 E) sign(x), a force along x the same with the other sign of the coupling, and a
/// force along y by -2 (1 + nu)/(pi E) ln(|x|/d).
Matrix3d between_patches(const LinePatch &to, const LinePatch &from, const HalfSpace &half_space,
                         const double thickness, const double datum)
{
  const double nu = half_space.poisson_ratio, e = half_space.young_modulus * thickness;
  const double logarithm = mean_logarithm(to, from, datum), sign = mean_sign(to, from);
  const double in_plane = -2 * (1 - nu * nu) / (pi * e) * logarithm;
  const double coupling = (1 - 2 * nu) * (1 + nu) / (2 * e) * sign;
  Matrix3d block = Matrix3d::Zero();
  block(0, 0) = block(2, 2) = in_plane;
  block(1, 1) = -2 * (1 + nu) / (pi * e) * logarithm;
  block(0, 2) = coupling;
  block(2, 0) = -coupling;
  return block;
}

/// Takes the directions that symmetry holds out of a block between two nodes.
Matrix3d without_held(Matrix3d block, const ContactNode &to, const ContactNode &from)
{
  for (Index d = 0; d < 3; ++d)
  {
    if (!to.is_free[d])
      block.row(d).setZero();
    if (!from.is_free[d])
      block.col(d).setZero();
  }
  return block;
}
} // namespace

MatrixXd half_plane_compliance(const HalfSpace &half_space, const ContactSurface &surface,
                               const ModelSymmetry &symmetry, const LocalAxes &axes)
{
  if (!symmetry.is_plane_strain())
    throw std::logic_error("a half-plane is met by sections in plane strain only");
  const double thickness = symmetry.section()->thickness;
  const std::vector<LinePatch> patches = patches_of_lines(surface, thickness);
  double length = 0;
  for (const LinePatch &patch : patches)
    length += symmetry.n_copies() * patch.width();
  const Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  const auto n = static_cast<Index>(patches.size());
  MatrixXd matrix(3 * n, 3 * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
    {
      Matrix3d block = between_patches(patches[i], patches[j], half_space, thickness, length);
      if (symmetry.n_copies() == 2)
        block += between_patches(patches[i], patches[j].mirrored(), half_space, thickness, length) * mirror;
      const double own = block(2, 2);
      block = without_held(block, surface.nodes[i], surface.nodes[j]);
      for (Index d = 0; d < 3; ++d)
        if (i == j && !surface.nodes[i].is_free[d])
          block(d, d) = own;
      matrix.block<3, 3>(3 * i, 3 * j) =
          axes.global_in_local(i).transpose() * block * axes.global_in_local(j);
    }
  return (matrix + matrix.transpose()) / 2; // rounding
}
} // namespace orthocone
