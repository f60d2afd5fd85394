// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/line_fields.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
/// A part of a contact face between neighbouring nodes, and a place in it: weights of its corners, and how
/// far it is outside (in sizes of the part).
struct PlaceInPart
{
  std::vector<HangingNode::Term> terms;
  double outside = std::numeric_limits<double>::infinity();
};

double outside_of_unit(const double x)
{
  return std::max({0., -x, x - 1});
}

/// The two coordinates in which a face of the contact surface is largest; of a line in a section the first
/// counts.
using Axes = std::array<unsigned int, 2>;

Axes axes_of_face(const ContactSurface &surface, const std::vector<unsigned int> &face, const bool is_section)
{
  const auto at = [&](const std::size_t i) { return surface.place(face[i]).place(); };
  const std::size_t last = face.size() - 1, side = surface.degree;
  if (is_section)
    return std::abs((at(last) - at(0))[0]) >= std::abs((at(last) - at(0))[2]) ? Axes{{0, 1}} : Axes{{2, 1}};
  const Eigen::Vector3d normal = (at(last) - at(0)).cross(at(last - side) - at(side)).cwiseAbs();
  return normal[2] >= std::max(normal[0], normal[1]) ? Axes{{0, 1}}
         : normal[0] >= normal[1]                    ? Axes{{1, 2}}
                                                     : Axes{{0, 2}};
}

Vector2d in_axes(const Eigen::Vector3d &place, const Axes &axes)
{
  return {place[axes[0]], place[axes[1]]};
}

Vector2d place_of(const ContactSurface &surface, const unsigned int place, const Axes &axes)
{
  return in_axes(surface.place(place).place(), axes);
}

PlaceInPart place_on_line(const ContactSurface &surface, const std::array<unsigned int, 2> &ends,
                          const double x, const Axes &axes)
{
  const double from = place_of(surface, ends[0], axes)[0], to = place_of(surface, ends[1], axes)[0];
  const double share = (x - from) / (to - from), inside = std::clamp(share, 0., 1.);
  return {{{ends[0], 1 - inside}, {ends[1], inside}}, outside_of_unit(share)};
}

/// Newton's method for the place (a, b) in a quadrilateral, whose corners are in the order (0, 0), (1, 0),
/// (0, 1), (1, 1).
Vector2d unit_place(const std::array<Vector2d, 4> &corners, const Vector2d &place)
{
  constexpr unsigned int most_iterations = 20;
  const Vector2d along = corners[1] - corners[0], up = corners[2] - corners[0],
                 twist = corners[3] - corners[2] - along;
  Vector2d unit(0.5, 0.5);
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    Matrix2d slope;
    slope << along + unit[1] * twist, up + unit[0] * twist;
    const Vector2d error = place - corners[0] - unit[0] * along - unit[1] * up - unit[0] * unit[1] * twist;
    const Vector2d change = slope.fullPivLu().solve(error);
    unit += change;
    if (change.norm() < 1e-14)
      break;
  }
  return unit;
}

PlaceInPart place_in_quadrilateral(const ContactSurface &surface, const std::array<unsigned int, 4> &corners,
                                   const Vector2d &place, const Axes &axes)
{
  const Vector2d unit =
      unit_place({{place_of(surface, corners[0], axes), place_of(surface, corners[1], axes),
                   place_of(surface, corners[2], axes), place_of(surface, corners[3], axes)}},
                 place);
  const double a = std::clamp(unit[0], 0., 1.), b = std::clamp(unit[1], 0., 1.);
  return {{{corners[0], (1 - a) * (1 - b)},
           {corners[1], a * (1 - b)},
           {corners[2], (1 - a) * b},
           {corners[3], a * b}},
          outside_of_unit(unit[0]) + outside_of_unit(unit[1])};
}

/// What the fields at a place of a face are made of: the part between its nodes in which the place lies, or
/// next to which it lies at a curved rim.
HangingNode surface_place(const ContactSurface &surface, const unsigned int face,
                          const Eigen::Vector3d &point, const bool is_section)
{
  const std::vector<unsigned int> &places = surface.faces[face];
  const Axes axes = axes_of_face(surface, places, is_section);
  const Vector2d place = in_axes(point, axes);
  const unsigned int degree = surface.degree, n_side = degree + 1;
  PlaceInPart best;
  const auto take = [&best](const PlaceInPart &part)
  {
    if (part.outside < best.outside)
      best = part;
  };
  for (unsigned int i = 0; i < degree; ++i)
    if (is_section)
      take(place_on_line(surface, {{places[i], places[i + 1]}}, place[0], axes));
    else
      for (unsigned int j = 0; j < degree; ++j)
      {
        const unsigned int first = j * n_side + i;
        take(place_in_quadrilateral(
            surface, {{places[first], places[first + 1], places[first + n_side], places[first + n_side + 1]}},
            place, axes));
      }
  return {{}, best.terms};
}

const Body *lower_body(const Scene &scene)
{
  return scene.lower() == nullptr ? nullptr : &scene.lower()->body().mesh();
}
} // namespace

LineFields::LineFields(const Line &line, const ContactFieldEvaluator &evaluator)
    : line_(line),
      points_(line, evaluator.scene().parameters(), evaluator.symmetry(), evaluator.scene().body().mesh(),
              lower_body(evaluator.scene())),
      surface_places_(points_.size())
{
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (const auto face = points_.contact_face(i))
      surface_places_[i] = surface_place(evaluator.surface(), *face, points_.model_place(i),
                                         evaluator.symmetry().is_section());
}

std::vector<LinePoint> LineFields::at(const std::vector<ContactFields> &contact, const Deformation &upper,
                                      const Deformation &lower) const
{
  const std::vector<PointFields> fields = points_.fields(upper, lower);
  std::vector<LinePoint> points;
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    points.push_back({line_.length() * static_cast<double>(i) / (line_.n_points - 1), fields[i], {}});
    if (const auto &place = surface_places_[i])
      points.back().contact = mapped(between(*place, contact), points_.map(i));
  }
  return points;
}
} // namespace orthocone
