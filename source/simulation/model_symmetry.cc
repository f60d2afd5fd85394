// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/model_symmetry.h>

#include <cmath>

namespace orthocone
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr unsigned int n_sectors = 32; // of a revolved surface, as many as the paper's mesh has

Matrix2d turn(const double cosine, const double sine)
{
  Matrix2d map;
  map << cosine, -sine, sine, cosine;
  return map;
}

/// A turn by i of n parts of the circle; quarter turns without rounding.
Matrix2d turn_by_part(const unsigned int i, const unsigned int n)
{
  const double angle = 2 * M_PI * i / n;
  const bool is_quarter = 4 * i % n == 0;
  return is_quarter ? turn(std::round(std::cos(angle)), std::round(std::sin(angle)))
                    : turn(std::cos(angle), std::sin(angle));
}

/// The disc that a line of contact nodes along the x axis sweeps. Its cells at the axis are degenerate: one
/// of their edges is the node there.
WholeSurface revolved(const ContactSurface &surface)
{
  const unsigned int n_places = n_sectors * surface.degree;
  WholeSurface whole;
  for (unsigned int i = 0; i < n_places; ++i)
    whole.images.push_back(turn_by_part(i, n_places));
  for (unsigned int sector = 0; sector < n_sectors; ++sector)
    for (const auto &line : surface.faces)
    {
      whole.faces.emplace_back();
      for (unsigned int j = 0; j <= surface.degree; ++j)
        for (const unsigned int node : line)
          whole.faces.back().push_back({node, (sector * surface.degree + j) % n_places});
    }
  return whole;
}
} // namespace

ModelSymmetry ModelSymmetry::of_revolution()
{
  ModelSymmetry symmetry;
  symmetry.is_axisymmetric_ = true;
  return symmetry;
}

unsigned int ModelSymmetry::n_images(const ContactSurface &surface, const ContactNode &node) const
{
  if (is_axisymmetric_)
    return node.position[0] == 0 ? 1 : n_sectors * surface.degree;
  return (planes_.normal_to_x && node.is_free[0] ? 2 : 1) * (planes_.normal_to_y && node.is_free[1] ? 2 : 1);
}

Eigen::VectorXd ModelSymmetry::force_shares(const ContactSurface &surface) const
{
  Eigen::VectorXd shares(surface.nodes.size());
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    shares[static_cast<Eigen::Index>(i)] =
        static_cast<double>(n_images(surface, surface.nodes[i])) / n_copies();
  return shares;
}

Matrix2d ModelSymmetry::map_to(const Vector2d &position) const
{
  if (is_axisymmetric_)
  {
    const double radius = std::hypot(position[0], position[1]);
    return radius == 0 ? Matrix2d::Identity() : turn(position[0] / radius, position[1] / radius);
  }
  return Vector2d(planes_.normal_to_x && position[0] < 0 ? -1 : 1,
                  planes_.normal_to_y && position[1] < 0 ? -1 : 1)
      .asDiagonal();
}

WholeSurface ModelSymmetry::mirrored(const ContactSurface &surface) const
{
  WholeSurface whole;
  const unsigned int n_side = surface.degree + 1;
  for (const double x : {1., -1.})
    for (const double y : {1., -1.})
    {
      if ((x < 0 && !planes_.normal_to_x) || (y < 0 && !planes_.normal_to_y))
        continue;
      const unsigned int image = whole.images.size();
      whole.images.emplace_back(Vector2d(x, y).asDiagonal());
      // A reflection turns a face over; running through its first direction backwards turns it back.
      const bool is_turned = x * y < 0;
      for (const auto &face : surface.faces)
      {
        whole.faces.emplace_back();
        for (unsigned int i = 0; i < face.size(); ++i)
          whole.faces.back().push_back(
              {face[is_turned ? i - i % n_side + (n_side - 1 - i % n_side) : i], image});
      }
    }
  return whole;
}

WholeSurface ModelSymmetry::whole(const ContactSurface &surface) const
{
  return is_axisymmetric_ ? revolved(surface) : mirrored(surface);
}
} // namespace orthocone
