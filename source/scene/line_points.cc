// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/line_points.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
constexpr double rounding_of_places = 1e-10; // of places, relative to the largest coordinate of the line

Matrix2d quarter_turn()
{
  Matrix2d turn;
  turn << 0, -1, 1, 0;
  return turn;
}

/// The maps from the model to a place: all of them, as a place on a plane of symmetry or the axis has
/// several.
std::vector<Matrix2d> maps_to(const Vector3d &place, const ModelSymmetry &symmetry)
{
  std::vector<Matrix2d> maps{symmetry.map_to(place.head<2>())};
  const auto add_images = [&maps](const Matrix2d &map)
  {
    const std::size_t n = maps.size();
    for (std::size_t i = 0; i < n; ++i)
      maps.emplace_back(maps[i] * map);
  };
  if (symmetry.is_axisymmetric())
  {
    if (place.head<2>().isZero(0))
    {
      add_images(-Matrix2d::Identity());
      add_images(quarter_turn());
    }
    return maps;
  }
  if (symmetry.planes().normal_to_x && place[0] == 0)
    add_images(Vector2d(-1, 1).asDiagonal());
  if (symmetry.planes().normal_to_y && place[1] == 0)
    add_images(Vector2d(1, -1).asDiagonal());
  return maps;
}

/// The place without the rounding that would keep it off a plane of symmetry or the contact
/// surface.
Vector3d without_rounding(const std::array<double, 3> &point, const double scale)
{
  Vector3d place;
  for (unsigned int d = 0; d < 3; ++d)
    place[d] = std::abs(point[d]) <= rounding_of_places * scale ? 0 : point[d];
  return place;
}

double largest_coordinate(const Line &line)
{
  double largest = 0;
  for (unsigned int d = 0; d < 3; ++d)
    largest = std::max({largest, std::abs(line.from[d]), std::abs(line.to[d])});
  return largest;
}

Vector3d in_model(const Vector3d &place, const Matrix2d &map, const ModelSymmetry &symmetry)
{
  const Vector2d mapped = map.transpose() * place.head<2>();
  return {symmetry.is_axisymmetric() ? place.head<2>().norm() : mapped[0],
          symmetry.is_section() ? 0 : mapped[1], place[2]};
}

std::string bodies_in_words(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  std::string text = "allowed are points of the body (" +
                     kind_of(parameters.geometry).describe(parameters.geometry) + ")" +
                     (parameters.geometry.faces_down
                          ? ", whose contact surface is at z = 0 and whose other points are above it"
                          : "");
  if (parameters.obstacle.kind == ObstacleKind::body)
    text += ", and of the lower body (" +
            kind_of(parameters.lower.geometry).describe(parameters.lower.geometry) + ")" +
            (parameters.geometry.faces_down ? " below it" : "");
  if (symmetry.is_plane_strain())
    text += "; y from " + to_text(-symmetry.section()->thickness / 2) + " to " +
            to_text(symmetry.section()->thickness / 2) + " mm";
  return text;
}

/// The mean of the images of a field under the maps.
PointFields mapped(const PointFields &fields, const std::vector<Matrix2d> &maps)
{
  PointFields mean;
  mean.stress_error = fields.stress_error;
  for (const Matrix2d &map : maps)
  {
    Matrix3d whole = Matrix3d::Identity();
    whole.topLeftCorner<2, 2>() = map;
    Matrix3d stress;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        stress(i, j) = fields.stress[i][j];
    const Matrix3d turned = whole * stress * whole.transpose();
    mean.displacement += whole * fields.displacement / static_cast<double>(maps.size());
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        mean.stress[i][j] += turned(i, j) / static_cast<double>(maps.size());
  }
  return mean;
}

/// The fields of the lower body from those of its mirror image about z = 0.
PointFields mirrored(PointFields fields)
{
  fields.displacement[2] = -fields.displacement[2];
  for (const unsigned int d : {0, 1})
    fields.stress[d][2] = -fields.stress[d][2];
  return fields;
}
} // namespace

LinePoints::LinePoints(const Line &line, const Parameters &parameters, const ModelSymmetry &symmetry,
                       const Body &upper, const Body *const lower)
    : lower_is_mirrored_(parameters.geometry.faces_down)
{
  const double scale = largest_coordinate(line);
  for (unsigned int i = 0; i < line.n_points; ++i)
  {
    const Vector3d place = without_rounding(line.point(i), scale);
    const std::vector<Matrix2d> maps = maps_to(place, symmetry);
    points_.push_back({place, in_model(place, maps.front(), symmetry), maps, false, 0});
  }
  if (lower != nullptr)
    find_lower_points(upper);
  std::vector<Vector3d> of_upper, of_lower;
  for (Point &point : points_)
  {
    if (point.is_in_lower && lower_is_mirrored_)
      point.in_model[2] = -point.in_model[2];
    std::vector<Vector3d> &body = point.is_in_lower ? of_lower : of_upper;
    point.number = body.size();
    body.push_back(point.in_model);
  }
  upper_.emplace(upper, of_upper);
  if (!of_lower.empty())
    of_lower_.emplace_back(*lower, of_lower);
  require_inside(line, parameters, symmetry);
}

/// The lower body lies below z = 0, or, where both bodies lie in their places, outside of the upper one.
void LinePoints::find_lower_points(const Body &upper)
{
  std::vector<Vector3d> places;
  for (const Point &point : points_)
    places.push_back(point.in_model);
  std::optional<BodyPoints> in_upper;
  if (!lower_is_mirrored_)
    in_upper.emplace(upper, places);
  for (std::size_t i = 0; i < points_.size(); ++i)
    points_[i].is_in_lower = in_upper ? !in_upper->is_inside(i) : points_[i].place[2] < 0;
}

bool LinePoints::is_inside(const Point &point, const ModelSymmetry &symmetry) const
{
  if (symmetry.is_plane_strain() &&
      std::abs(point.place[1]) > symmetry.section()->thickness / 2 * (1 + rounding_of_places))
    return false;
  return point.is_in_lower ? of_lower_.front().is_inside(point.number) : upper_->is_inside(point.number);
}

void LinePoints::require_inside(const Line &line, const Parameters &parameters,
                                const ModelSymmetry &symmetry) const
{
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!is_inside(points_[i], symmetry))
    {
      const Vector3d &place = points_[i].place;
      throw InputError("Output/Lines: point " + std::to_string(i + 1) + " of " +
                       std::to_string(line.n_points) + " of '" + line.name + "' at (" + to_text(place[0]) +
                       ", " + to_text(place[1]) + ", " + to_text(place[2]) +
                       ") lies in no body: " + bodies_in_words(parameters, symmetry));
    }
}

std::optional<unsigned int> LinePoints::contact_face(const std::size_t i) const
{
  return points_[i].is_in_lower ? std::nullopt : upper_->contact_face(points_[i].number);
}

std::vector<PointFields> LinePoints::fields(const Deformation &upper, const Deformation &lower) const
{
  const std::vector<PointFields> of_upper = upper_->fields(upper);
  const std::vector<PointFields> of_lower =
      is_in_lower() ? of_lower_.front().fields(lower) : std::vector<PointFields>();
  std::vector<PointFields> all;
  for (const Point &point : points_)
  {
    const PointFields &own = (point.is_in_lower ? of_lower : of_upper)[point.number];
    all.push_back(mapped(point.is_in_lower && lower_is_mirrored_ ? mirrored(own) : own, point.maps));
    all.back().place = point.place;
  }
  return all;
}

void require_lines_inside(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.output.lines.empty())
    return;
  const Body upper(parameters, symmetry);
  std::optional<Body> lower;
  if (parameters.obstacle.kind == ObstacleKind::body)
    lower.emplace(parameters.lower, symmetry);
  for (const Line &line : parameters.output.lines)
    LinePoints(line, parameters, symmetry, upper, lower ? &*lower : nullptr);
}
} // namespace orthocone
