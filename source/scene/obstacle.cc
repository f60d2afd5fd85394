// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "given_distance.h"

#include <orthocone/scene/obstacle.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/expression.h>
#include <orthocone/scene/gap_file.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
class Plane : public Obstacle
{
public:
  bool is_plane() const override { return true; }
  double gap(const SurfacePoint &point) const override { return point.place[2]; }
  void check(const std::vector<SurfacePoint> &) const override {}
};

/// The sum of an expression and a measured surface, along z or along the normals of the body that it fits.
class GivenGap : public Obstacle
{
public:
  explicit GivenGap(const ObstacleOptions &options)
      : expression_(options.gap),
        file_name_(options.gap_file),
        fits_(options.normal == ObstacleNormal::surface)
  {
    if (!file_name_.empty())
      grid_ = read_gap_file(file_name_);
  }

  double gap(const SurfacePoint &point) const override
  {
    const Vector3d &at = point.place;
    const double of_plane = expression_at(at) + (grid_ ? grid_->value(at[0], at[1]) : 0);
    return fits_ ? of_plane : of_plane + at[2];
  }
  bool has_normal_z() const override { return !fits_; }
  std::vector<Vector3d> normals(const std::vector<SurfacePoint> &points) const override;
  void check(const std::vector<SurfacePoint> &points) const override;

private:
  double expression_at(const Vector3d &place) const
  {
    return expression_.value(place[0], place[1], place[2]);
  }

  Expression expression_;
  std::string file_name_;
  std::optional<GapGrid> grid_;
  bool fits_; ///< whether it fits the body
};

std::vector<Vector3d> GivenGap::normals(const std::vector<SurfacePoint> &points) const
{
  if (!fits_)
    return Obstacle::normals(points);
  std::vector<Vector3d> normals;
  for (const SurfacePoint &point : points)
    normals.push_back(point.inward);
  return normals;
}

void GivenGap::check(const std::vector<SurfacePoint> &points) const
{
  for (const SurfacePoint &point : points)
  {
    const Vector3d &place = point.place;
    if (const double gap = expression_at(place); !std::isfinite(gap))
      throw InputError("Obstacle/Gap = " + expression_.text() + " is " + value_text(gap) + " at " +
                       place_text(place) + " of the contact surface: allowed is a finite number (mm)");
    if (grid_ && !grid_->contains(place[0], place[1]))
      throw InputError(
          "Obstacle/Gap file = " + shown_path(file_name_) + ": allowed is a grid that covers the " +
          "whole contact surface, also " + place_text(place) + "; this one reaches from " +
          place_text(Vector2d(grid_->first_x, grid_->first_y)) + " to " +
          place_text(Vector2d(grid_->first_x + grid_->spacing_x * static_cast<double>(grid_->n_x - 1),
                              grid_->first_y + grid_->spacing_y * static_cast<double>(grid_->n_y - 1))));
  }
}
} // namespace

Eigen::MatrixXd Obstacle::compliance(const ContactSurface &, const ModelSymmetry &, const LocalAxes &) const
{
  return {};
}

std::unique_ptr<const Compliance>
Obstacle::compliance_by_products(const ContactSurface &, const ModelSymmetry &, const LocalAxes &) const
{
  return nullptr;
}

std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options)
{
  std::unique_ptr<const Obstacle> surface;
  if (!options.distance.empty())
    surface = std::make_unique<GivenDistance>(options.distance);
  else if (options.is_plane())
    surface = std::make_unique<Plane>();
  else
    surface = std::make_unique<GivenGap>(options);
  return options.kind.chosen().make(options, std::move(surface));
}

NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface)
{
  NodeVector gaps = NodeVector::Zero(3 * static_cast<Eigen::Index>(surface.nodes.size()));
  const std::vector<SurfacePoint> points = points_of(surface);
  for (std::size_t i = 0; i < points.size(); ++i)
    gaps[3 * static_cast<Eigen::Index>(i)] = obstacle.gap(points[i]);
  return gaps;
}

namespace
{
std::string difference_text(const Obstacle &obstacle, const SurfacePoint &point, const SurfacePoint &image)
{
  std::ostringstream text;
  text << std::setprecision(4) << obstacle.entry() << " is " << obstacle.gap(point) << " mm at "
       << place_text(point.place) << " and " << obstacle.gap(image) << " mm at " << place_text(image.place);
  return text.str();
}

/// The first point whose image has another normal than the map of its own; nothing if there is none.
std::optional<std::size_t> other_normal(const Obstacle &obstacle, const std::vector<SurfacePoint> &points,
                                        const Eigen::Affine2d &map)
{
  constexpr double rounding = 1e-6; // of differences beside edges
  if (obstacle.has_normal_z())
    return std::nullopt;
  std::vector<SurfacePoint> images;
  for (const SurfacePoint &point : points)
    images.push_back(point.mapped(map));
  const std::vector<Vector3d> own = obstacle.normals(points), of_images = obstacle.normals(images);
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((SurfacePoint{points[i].place, own[i]}.mapped(map).inward - of_images[i]).norm() > rounding)
      return i;
  return std::nullopt;
}
} // namespace

std::string Obstacle::asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const
{
  constexpr double rounding = 1e-9;
  if (symmetry.is_axisymmetric() && material())
    return "Obstacle/Kind = half-space has no section (r, z)";
  if (is_plane())
    return {};
  const std::vector<SurfacePoint> &points = sample.of(symmetry);
  double largest = 0;
  for (const SurfacePoint &point : points)
    largest = std::max(largest, std::abs(gap(point)));
  for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
  {
    for (const SurfacePoint &point : points)
      if (const SurfacePoint image = point.mapped(map);
          !(std::abs(gap(image) - gap(point)) <= rounding * largest))
        return difference_text(*this, point, image);
    if (const auto other = other_normal(*this, points, map))
      return entry() + " has no mirrored normal at the image of " + place_text(points[*other].place);
  }
  return {};
}
} // namespace orthocone
