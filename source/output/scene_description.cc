// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "drawn_body.h"

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/output/load_ranges.h>
#include <orthocone/output/model_text.h>
#include <orthocone/output/scene_description.h>
#include <orthocone/scene/lower_body.h>
#include <orthocone/scene/obstacle.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace orthocone
{
namespace
{
using Eigen::Vector2d;

constexpr unsigned int most_drawn = 5000; // faces of a body whose mesh is still to be seen in a picture

/// What stands behind the heading of a line that --check prints.
std::string content_of(const std::string &line)
{
  constexpr std::size_t width_of_heading = 15;
  return line.size() < width_of_heading ? std::string() : trimmed(line.substr(width_of_heading));
}

/// A body of the scene on a mesh that a picture can show.
struct DrawnBody
{
  BodyOptions options;
  std::string text; ///< what the body is
  std::unique_ptr<const Body> body;
  bool has_own_mesh;  ///< whether it is that of the run
  bool is_half_space; ///< whether the mesh is a box in its place
};

DrawnBody drawn_body(const BodyOptions &options, const ModelSymmetry &symmetry, const bool has_mesh)
{
  const ShapeKind &kind = kind_of(options.geometry);
  const std::string text = kind.describe(options.geometry);
  if (has_mesh && kind.is_meshed())
    if (auto body = std::make_unique<const Body>(options, symmetry); n_drawn(*body) <= most_drawn)
      return {options, text, std::move(body), true, false};
  const BodyOptions outline = with_outline_mesh(options);
  return {outline, text, std::make_unique<const Body>(outline, symmetry), false, !kind.is_meshed()};
}

OrderedJson json_of(const DrawnBody &drawn)
{
  OrderedJson json = body_json(*drawn.body, drawn.options);
  json["text"] = drawn.text;
  json["has_own_mesh"] = drawn.has_own_mesh;
  json["is_half_space"] = drawn.is_half_space;
  return json;
}

/// The places of the contact surface, (x, y, height), and the gap of the counterface below z = 0 there.
OrderedJson contact_json(const ContactSurface &surface, const Obstacle *const obstacle)
{
  OrderedJson nodes = OrderedJson::array(), gaps = OrderedJson::array();
  for (std::size_t i = 0; i < surface.n_places(); ++i)
  {
    const ContactNode &node = surface.place(i);
    nodes.push_back({node.position[0], node.position[1], node.height});
    if (obstacle != nullptr)
      gaps.push_back(obstacle->gap({node.place(), node.inward}) - node.height);
  }
  OrderedJson json{{"degree", surface.degree},
                   {"n_nodes", surface.nodes.size()},
                   {"nodes", nodes},
                   {"gaps", gaps},
                   {"faces", surface.faces}};
  if (obstacle != nullptr && !obstacle->has_normal_z())
    for (const Eigen::Vector3d &normal : obstacle->normals(points_of(surface)))
      json["normals"].push_back({normal[0], normal[1], normal[2]});
  return json;
}

/// The height of the node that is nearest to a place, mm; 0 where there is no surface.
double nearest_height(const ContactSurface *const surface, const Vector2d &place)
{
  double height = 0, least = std::numeric_limits<double>::max();
  if (surface != nullptr)
    for (const ContactNode &node : surface->nodes)
      if (const double distance = std::hypot(node.position[0] - place[0], node.position[1] - place[1]);
          distance < least)
      {
        least = distance;
        height = node.height;
      }
  return height;
}

/// Where the bodies touch first: the node with the least gap, and of equal ones the nearest to x = y = 0.
Vector2d first_touch(const Parameters &parameters, const ModelSymmetry &symmetry,
                     const ContactSurface &surface, const ContactSurface *const lower,
                     const Obstacle &obstacle)
{
  const bool is_curved = lower != nullptr && !obstacle.has_normal_z();
  const Eigen::VectorXd distances =
      is_curved ? lower_distances(parameters, symmetry, surface, *lower) : Eigen::VectorXd();
  Vector2d touch(0, 0);
  double least = std::numeric_limits<double>::max();
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
  {
    const ContactNode &node = surface.nodes[i];
    const Vector2d place(node.position[0], node.position[1]);
    const double gap = obstacle.gap({node.place(), node.inward}) +
                       (is_curved ? distances[static_cast<Eigen::Index>(i)] : nearest_height(lower, place));
    const double margin = least < std::numeric_limits<double>::max() ? rounding * (1 + std::abs(least)) : 0;
    if (gap < least - margin || (gap <= least + margin && place.norm() < touch.norm()))
    {
      least = std::min(least, gap);
      touch = place;
    }
  }
  return touch;
}

/// The gap of the counterface along an axis (0: x, 1: y) through a place, as far as the whole contact surface
/// reaches.
OrderedJson gap_line(const Obstacle &obstacle, const ContactSurface &surface, const ModelSymmetry &symmetry,
                     const Vector2d &through, const unsigned int axis)
{
  constexpr unsigned int n = 400;
  double least = std::numeric_limits<double>::max(), largest = std::numeric_limits<double>::lowest();
  for (const ContactNode &node : surface.nodes)
  {
    least = std::min(least, node.position[axis]);
    largest = std::max(largest, node.position[axis]);
  }
  const bool is_mirrored = symmetry.is_axisymmetric() ||
                           (axis == 0 ? symmetry.planes().normal_to_x : symmetry.planes().normal_to_y);
  least = is_mirrored ? -largest : least;
  OrderedJson at = OrderedJson::array(), gaps = OrderedJson::array();
  for (unsigned int i = 0; i <= n; ++i)
  {
    Vector2d place = through;
    place[axis] = least + (largest - least) * i / n;
    at.push_back(place[axis]);
    gaps.push_back(obstacle.gap({{place[0], place[1], 0}}));
  }
  return {{"axis", axis == 0 ? "x" : "y"}, {"at", at}, {"gaps", gaps}};
}

OrderedJson gap_json(const Parameters &parameters, const ModelSymmetry &symmetry,
                     const ContactSurface &surface, const ContactSurface *const lower)
{
  const auto obstacle = make_obstacle(parameters.obstacle);
  const Vector2d touch = first_touch(parameters, symmetry, surface, lower, *obstacle);
  OrderedJson lines = OrderedJson::array();
  for (const unsigned int axis : {0u, 1u})
    if (obstacle->has_normal_z() && (axis == 0 || !symmetry.is_section()))
      lines.push_back(gap_line(*obstacle, surface, symmetry, touch, axis));
  return {{"touch", {touch[0], touch[1]}},
          {"contact", contact_json(surface, obstacle.get())},
          {"lower", lower == nullptr ? OrderedJson() : contact_json(*lower, nullptr)},
          {"lines", lines}};
}

/// The friction law at a place: for slip along each of many directions (degrees from x), the force on the
/// body per unit normal force, (x, y) in the axes of the scene.
OrderedJson friction_json(const Parameters &parameters, const Vector2d &place)
{
  constexpr unsigned int n = 360;
  const FrictionOptions &given = parameters.friction;
  const FrictionOptions friction = given.at(place[0], place[1]);
  const FrictionLaw law = given.law.chosen().law(given, {place[0], place[1], 0});
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(friction.angle * radians_per_degree).toRotationMatrix();
  OrderedJson forces = OrderedJson::array();
  for (unsigned int i = 0; i < n && !law.is_frictionless(); ++i)
  {
    const Vector2d slip(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
    const Vector2d force = turn * law.force_against(turn.transpose() * slip);
    forces.push_back({force[0], force[1]});
  }
  return {{"text", content_of(describe_friction(parameters))},
          {"angle", friction.angle},
          {"varies", given.varies()},
          {"mu", law.ellipse() == nullptr ? OrderedJson() : OrderedJson(friction.mu)},
          {"p", law.ellipse() == nullptr ? OrderedJson() : OrderedJson(friction.p())},
          {"is_associated", given.is_associated()},
          {"forces_against_slip", forces}};
}

OrderedJson drive_json(const LoadOptions &load)
{
  OrderedJson all = OrderedJson::array();
  for (const LoadRange &range : load_ranges(load))
  {
    OrderedJson one{{"name", range.name},   {"unit", range.unit},       {"number", range.number},
                    {"least", range.least}, {"largest", range.largest}, {"text", range.text()}};
    if (range.number >= n_rigid_components)
    {
      const Load &declared = load.loads[range.number - n_rigid_components];
      const Eigen::Vector3d &along = declared.direction;
      one.update({{"kind", declared.kind->word()},
                  {"words", declared.text()},
                  {"surfaces", declared.surfaces},
                  {"is_on_lower", declared.is_on_lower},
                  {"is_along", declared.kind->has_direction()},
                  {"direction", {along[0], along[1], along[2]}}});
    }
    all.push_back(one);
  }
  return all;
}

OrderedJson model_json(const ModelChoice &model)
{
  const ModelSymmetry &symmetry = model.symmetry;
  return {
      {"text", content_of(describe_model(model))},
      {"is_axisymmetric", symmetry.is_axisymmetric()},
      {"is_plane_strain", symmetry.is_plane_strain()},
      {"thickness", symmetry.is_plane_strain() ? OrderedJson(symmetry.section()->thickness) : OrderedJson()},
      {"mirrored", {symmetry.planes().normal_to_x, symmetry.planes().normal_to_y}}};
}
} // namespace

std::string scene_description(const Parameters &parameters, const ModelChoice &model, const bool has_mesh)
{
  const DrawnBody upper = drawn_body(parameters, model.symmetry, has_mesh);
  std::optional<DrawnBody> lower;
  OrderedJson bodies = OrderedJson::array();
  bodies.push_back(json_of(upper));
  if (parameters.obstacle.kind.chosen().is_body())
  {
    lower.emplace(drawn_body(parameters.lower, model.symmetry, has_mesh));
    bodies.push_back(json_of(*lower));
  }
  const ContactSurface &surface = upper.body->unknowns().contact_surface();
  const ContactSurface *const below = lower ? &lower->body->unknowns().contact_surface() : nullptr;
  const OrderedJson gap = gap_json(parameters, model.symmetry, surface, below);
  const Vector2d touch(gap["touch"][0].get<double>(), gap["touch"][1].get<double>());
  const OrderedJson scene{{"model", model_json(model)},
                          {"bodies", bodies},
                          {"obstacle",
                           {{"kind", parameters.obstacle.kind.word()},
                            {"text", content_of(describe_obstacle(parameters))},
                            {"is_plane", parameters.obstacle.is_plane()}}},
                          {"materials", describe_materials(parameters)},
                          {"gap", gap},
                          {"friction", friction_json(parameters, touch)},
                          {"drive", drive_json(parameters.load)}};
  // Names that are no UTF-8 are shown with signs in the place of their bytes.
  return scene.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}
} // namespace orthocone
