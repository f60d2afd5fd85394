// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_space_fields.h>

#include <orthocone/base/numbers.h>

#include <unsupported/Eigen/AutoDiff>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// A number with its derivatives along x, y and z of the point.
using Graded = Eigen::AutoDiffScalar<Vector3d>;

/// log(root + value), but for the logarithm of `rest`, where root^2 = value^2 + rest^2.
Graded log_of_sum(const Graded &root, const Graded &value, const Graded &squared_rest)
{
  const Graded sum = root + abs(value), ratio = log(sum) - 0.5 * log(squared_rest);
  return value.value() < 0 ? Graded(-ratio) : ratio;
}

/// Displacement times 4 pi G by tractions q on the quadrant beside a corner, which lies at (-x, -y, -z) from
/// the point. Boussinesq's and Cerruti's potentials (Johnson, Contact Mechanics, 1985, 3.2) are integrals of
/// log(rho + z) = `l` and of z log(rho + z) - rho = `m` over the loaded area. Of a quadrant their derivatives
/// are closed forms; what depends on one of x and y alone vanishes in the sum over the corners of a patch.
std::array<Graded, 3> displacement_of_quadrant(const Graded &x, const Graded &y, const Graded &z,
                                               const Vector3d &q, const double nu)
{
  const Graded rest_x = x * x + z * z, rest_y = y * y + z * z, rho = sqrt(Graded(rest_x + y * y)),
               product = x * y;
  const Graded l_xx = atan2(product, Graded(rest_x + rho * z)),
               l_yy = atan2(product, Graded(rest_y + rho * z)), l_zz = -atan2(product, Graded(rho * z)),
               l_xy = log(Graded(rho + z)), l_xz = log_of_sum(rho, y, rest_x),
               l_yz = log_of_sum(rho, x, rest_y);
  const Graded l_x = y * l_xy + z * l_xz + x * l_xx, l_y = x * l_xy + z * l_yz + y * l_yy,
               l_z = x * l_xz + y * l_yz + z * l_zz;
  const Graded m_xx = z * l_xx - x * l_xz, m_xy = z * l_xy - rho, m_yy = z * l_yy - y * l_yz;
  const Graded u_x = 2 * q[0] * l_z - q[2] * l_x + 2 * nu * (q[0] * m_xx + q[1] * m_xy + q[2] * l_x) -
                     z * (q[0] * l_xx + q[1] * l_xy + q[2] * l_xz),
               u_y = 2 * q[1] * l_z - q[2] * l_y + 2 * nu * (q[0] * m_xy + q[1] * m_yy + q[2] * l_y) -
                     z * (q[0] * l_xy + q[1] * l_yy + q[2] * l_yz),
               u_z = q[2] * l_z + (1 - 2 * nu) * (q[0] * l_x + q[1] * l_y + q[2] * l_z) -
                     z * (q[0] * l_xz + q[1] * l_yz + q[2] * l_zz);
  return {{u_x, u_y, u_z}};
}

/// What a quadrant's tractions are at the corner (i, j) of the grid: the tractions of the patches around it,
/// each with the sign of its side.
Vector3d jump_at(const SurfaceGrid &grid, const std::vector<Vector3d> &tractions, const Index i,
                 const Index j)
{
  Vector3d jump = Vector3d::Zero();
  for (const Index right : {0, 1})
    for (const Index up : {0, 1})
    {
      const Index x = i - 1 + right, y = j - 1 + up;
      if (x >= 0 && y >= 0 && x < grid.n_x && y < grid.n_y)
        jump += (right == up ? 1 : -1) * tractions[static_cast<std::size_t>(y * grid.n_x + x)];
    }
  return jump;
}
} // namespace

HalfSpaceFields fields_below(const SurfaceGrid &grid, const HalfSpace &half_space,
                             const std::vector<Vector3d> &tractions, const Vector3d &point)
{
  if (grid.is_periodic)
    throw std::logic_error("the closed forms know no images");
  constexpr double nearest = 1e-6;
  const double shear_modulus = half_space.young_modulus / (2 * (1 + half_space.poisson_ratio)),
               factor = 1 / (4 * pi * shear_modulus);
  const Graded z(std::max(point[2], nearest * std::min(grid.width, grid.height)), 3, 2);
  HalfSpaceFields fields;
  for (Index j = 0; j <= grid.n_y; ++j)
    for (Index i = 0; i <= grid.n_x; ++i)
    {
      const Vector3d jump = jump_at(grid, tractions, i, j);
      if (jump.isZero(0))
        continue;
      const auto corner = [](const Index k, const Index n, const double width)
      { return (static_cast<double>(k) - static_cast<double>(n) / 2) * width; };
      const Graded x(point[0] - corner(i, grid.n_x, grid.width), 3, 0),
          y(point[1] - corner(j, grid.n_y, grid.height), 3, 1);
      const auto displacement = displacement_of_quadrant(x, y, z, jump, half_space.poisson_ratio);
      for (Index d = 0; d < 3; ++d)
      {
        fields.displacement[d] += factor * displacement[static_cast<std::size_t>(d)].value();
        fields.gradient.row(d) += factor * displacement[static_cast<std::size_t>(d)].derivatives();
      }
    }
  return fields;
}
} // namespace orthocone
