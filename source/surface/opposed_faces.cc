// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "opposed_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
std::vector<std::shared_ptr<const CutFace>> faces_in_plane(const ContactSurface &surface)
{
  std::vector<std::shared_ptr<const CutFace>> faces;
  for (const auto &face : surface.faces)
  {
    std::vector<Vector2d> places;
    for (const unsigned int node : face)
      places.emplace_back(surface.nodes[node].position[0], surface.nodes[node].position[1]);
    const Vector2d centre = PlaneFace(surface.degree, places).position({0.5, 0.5});
    faces.push_back(std::make_shared<CutFace>(surface.degree, face, std::move(places),
                                              Vector3d(centre[0], centre[1], 0)));
  }
  return faces;
}

/// Number in a lexicographic order of n x n nodes when both of its directions change places.
std::size_t transposed(const std::size_t i, const std::size_t n)
{
  return n * (i % n) + i / n;
}
} // namespace

OpposedFaces::OpposedFaces(const ContactSurface &surface, const ContactSurface &other, const Facing facing)
    : surface_(surface),
      other_(other)
{
  if (facing == Facing::along_z)
  {
    in_plane_ = faces_in_plane(surface);
    others_in_plane_ = faces_in_plane(other);
    return;
  }
  for (const auto &face : surface.faces)
    planes_.push_back(mean_plane(surface, face));
  for (const auto &face : other.faces)
    other_planes_.push_back(mean_plane(other, face));
}

/// The normal is that of the two diagonals.
OpposedFaces::MeanPlane OpposedFaces::mean_plane(const ContactSurface &surface,
                                                 const std::vector<unsigned int> &face)
{
  const std::size_t n = surface.degree + 1;
  const auto place = [&](const std::size_t i) { return surface.nodes[face[i]].place(); };
  const Vector3d first = place(n * n - 1) - place(0), second = place(n * (n - 1)) - place(n - 1);
  Vector3d inward = Vector3d::Zero();
  MeanPlane plane{(place(0) + place(n - 1) + place(n * (n - 1)) + place(n * n - 1)) / 4, {}, 0};
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    inward += surface.nodes[face[i]].inward;
    plane.radius = std::max(plane.radius, (place(i) - plane.centre).norm());
  }
  Vector3d normal = first.cross(second).normalized();
  if (normal.dot(inward) < 0)
    normal = -normal;
  const Vector3d along = (first - second).normalized(); // as the first direction of the face
  plane.axes << along, normal.cross(along), normal;
  return plane;
}

std::shared_ptr<CutFace> OpposedFaces::projected(const ContactSurface &surface,
                                                 const std::vector<unsigned int> &face,
                                                 const MeanPlane &plane)
{
  const std::size_t n = surface.degree + 1;
  const auto local = [&](const std::size_t i) -> Vector3d
  { return plane.axes.transpose() * (surface.nodes[face[i]].place() - plane.centre); };
  const Vector3d first = local(n * n - 1) - local(0), second = local(n * (n - 1)) - local(n - 1);
  const bool is_clockwise = first[0] * second[1] < first[1] * second[0];
  std::vector<unsigned int> nodes;
  std::vector<Vector2d> places;
  Eigen::VectorXd heights(static_cast<Eigen::Index>(face.size()));
  Vector3d centre = Vector3d::Zero();
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    const std::size_t from = is_clockwise ? transposed(i, n) : i;
    const Vector3d at = local(from);
    nodes.push_back(face[from]);
    places.emplace_back(at.head<2>());
    heights[static_cast<Eigen::Index>(i)] = at[2];
    centre += surface.nodes[face[from]].place() / static_cast<double>(face.size());
  }
  auto cut = std::make_shared<CutFace>(surface.degree, std::move(nodes), std::move(places), centre, true);
  cut->set_heights(heights);
  return cut;
}

/// The faces of the other surface that look towards a plane of the first one and may lie over its face. Those
/// that lie behind a nearer one by more than both are wide are left out.
std::vector<std::size_t> OpposedFaces::facing(const MeanPlane &plane) const
{
  constexpr double least_cosine = 0.2; // steeper ones would be cut badly
  const Vector3d normal = plane.axes.col(2);
  std::vector<std::pair<double, std::size_t>> found; // distance and face
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < other_planes_.size(); ++k)
  {
    const MeanPlane &other = other_planes_[k];
    const Vector3d way = other.centre - plane.centre;
    const double distance = std::abs(way.dot(normal)), reach = plane.radius + other.radius;
    if (-normal.dot(other.axes.col(2)) < least_cosine ||
        way.squaredNorm() > distance * distance + reach * reach)
      continue;
    found.emplace_back(std::max(0., distance - reach), k);
    nearest = std::min(nearest, distance);
  }
  std::vector<std::size_t> faces;
  for (const auto &[distance, face] : found)
    if (distance <= nearest)
      faces.push_back(face);
  return faces;
}

Opposition OpposedFaces::at(const std::size_t face) const
{
  if (!in_plane_.empty())
    return {in_plane_[face], others_in_plane_};
  Opposition opposition{projected(surface_, surface_.faces[face], planes_[face]), {}};
  for (const std::size_t other : facing(planes_[face]))
    opposition.others.push_back(projected(other_, other_.faces[other], planes_[face]));
  return opposition;
}
} // namespace orthocone
