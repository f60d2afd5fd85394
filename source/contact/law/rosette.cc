// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/rosette.h>

#include "rosette_table.h"

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
/// Of |r'| = G(r).
double gauge(const RosetteSector &sector, const Vector2d &force)
{
  return std::sqrt(sector.square_of_gauge(sector.forces.coordinates(force)));
}

/// (d b/da)^(-1/2) at a direction of slip, times the lengths by which the ratio p has divided: g = -M x phi
/// (e_0
/// + q e_1) for the slip -(x u_0 + y u_1).
double phi(const RosetteSector &sector, const double p)
{
  return std::sqrt(sector.slips.sine / (sector.forces.sine * sector.ratio_slope(p)));
}
} // namespace

Rosette::Rosette(std::vector<Row> rows)
    : table_(std::make_unique<const RosetteTable>(make_rosette_table(std::move(rows))))
{
  constexpr unsigned int n_directions = 720;
  double sum = 0;
  for (unsigned int i = 0; i < n_directions; ++i)
  {
    const double angle = 2 * pi * i / n_directions;
    sum -= std::log(reduced_force({std::cos(angle), std::sin(angle)}).norm());
  }
  mean_ = std::exp(sum / n_directions);
}

Rosette::~Rosette() = default;

std::vector<double> Rosette::angles() const
{
  return table_->slip_angles;
}

Rosette::Row Rosette::row(const double angle) const
{
  const Vector2d e(std::cos(angle), std::sin(angle)), to_the_left(-e[1], e[0]);
  const Vector2d reduced = -reduced_slip(-e), f = force(reduced / reduced.norm());
  return {angle, f.dot(e), f.dot(to_the_left)};
}

Vector2d Rosette::reduced_force(const Vector2d &force) const
{
  if (force.isZero(0))
    return force;
  return force * (gauge(table_->with_force(force), force) / force.norm());
}

// r' = (G/|r|) r.
Matrix2d Rosette::reduced_force_derivative(const Vector2d &force) const
{
  if (force.isZero(0))
    return Matrix2d::Identity() / mean_;
  const RosetteSector &sector = table_->with_force(force);
  const Vector2d coordinates = sector.forces.coordinates(force);
  const double size = std::sqrt(sector.square_of_gauge(coordinates));
  const Vector2d gradient = sector.forces.dual.transpose() * sector.half_gradient(coordinates) / size;
  return (size * Matrix2d::Identity() + force * (gradient - size / force.squaredNorm() * force).transpose()) /
         force.norm();
}

Vector2d Rosette::force(const Vector2d &reduced) const
{
  if (reduced.isZero(0))
    return reduced;
  return reduced * (reduced.norm() / gauge(table_->with_force(reduced), reduced));
}

Vector2d Rosette::reduced_slip(const Vector2d &slip) const
{
  if (slip.isZero(0))
    return slip;
  const RosetteSector &sector = table_->with_slip(-slip);
  const Vector2d coordinates = sector.slips.coordinates(-slip);
  const double p = coordinates[1] / coordinates[0];
  return -coordinates[0] / mean_ * phi(sector, p) *
         (sector.forces.first + sector.force_ratio(p) * sector.forces.second);
}

// By the coordinates x and y of -slip, p = y/x: with v = e_0 + q e_1 and w = d(phi v)/dp the columns of the
// derivative of -M g = x phi v are phi v - p w and w.
Matrix2d Rosette::reduced_slip_derivative(const Vector2d &slip) const
{
  if (slip.isZero(0))
    return Matrix2d::Identity() / mean_;
  const RosetteSector &sector = table_->with_slip(-slip);
  const Vector2d coordinates = sector.slips.coordinates(-slip);
  const double p = coordinates[1] / coordinates[0], factor = phi(sector, p);
  const Vector2d v = sector.forces.first + sector.force_ratio(p) * sector.forces.second;
  const Vector2d w =
      factor * (sector.ratio_slope(p) * sector.forces.second - sector.relative_curvature(p) / 2 * v);
  Matrix2d columns;
  columns << factor * v - p * w, w;
  return columns * sector.slips.dual / mean_;
}

Vector2d Rosette::slip(const Vector2d &reduced) const
{
  if (reduced.isZero(0))
    return reduced;
  const RosetteSector &sector = table_->with_force(-reduced);
  const Vector2d coordinates = sector.forces.coordinates(-reduced);
  const double p = sector.slip_ratio(coordinates[1] / coordinates[0]);
  return -mean_ * coordinates[0] / phi(sector, p) * (sector.slips.first + p * sector.slips.second);
}
} // namespace orthocone
