// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "named_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace orthocone
{
using Eigen::Vector3d;

namespace
{
/// A cylinder or a sphere; mm.
struct Round
{
  bool is_sphere;
  Vector3d centre; ///< or a point of the axis
  Vector3d axis;   ///< of length 1
  double radius = 0;

  /// The part of a vector that counts for the distance from the axis or the centre.
  Vector3d across(const Vector3d &vector) const
  {
    return is_sphere ? vector : Vector3d(vector - vector.dot(axis) * axis);
  }

  /// The length t, of the two that there may be the smaller one, with which `place` - t `normal` lies on it:
  /// t^2 m.m - 2 t a.m + a.a - R^2 = 0 for the parts a and m across. The product of both roots gives the
  /// smaller one without cancellation.
  std::optional<double> distance(const Vector3d &place, const Vector3d &normal) const
  {
    const Vector3d a = across(place - centre), m = across(normal);
    const double length = a.norm(), excess = (length - radius) * (length + radius), slope = a.dot(m);
    const double discriminant = slope * slope - m.squaredNorm() * excess;
    const double larger = slope + std::copysign(std::sqrt(std::max(0., discriminant)), slope);
    return discriminant < 0 || larger == 0 ? std::nullopt : std::optional(excess / larger);
  }
};

/// The radius is that of the nodes of surface `number`.
Round round_of(const CurvedSurface &given, const ContactSurface &own, const std::size_t number)
{
  Round round{given.kind == SurfaceKind::sphere, Vector3d(given.centre.data()),
              Vector3d(given.direction.data()).stableNormalized()};
  double n = 0;
  for (const ContactNode &node : own.nodes)
    if (node.surface == number)
    {
      round.radius += round.across(node.place() - round.centre).norm();
      ++n;
    }
  round.radius /= std::max(1., n);
  return round;
}

/// For each contact surface of the lower body what it is by name.
std::vector<std::optional<Round>> named_rounds(const GeometryOptions &lower, const ContactSurface &own)
{
  std::vector<CurvedSurface> named;
  if (lower.is_from_file())
    named = lower.curved_surfaces;
  else if (lower.shape == BodyShape::cylinder)
    named.push_back({"side", SurfaceKind::cylinder, {}, {{0, 0, 1}}});
  std::vector<std::optional<Round>> rounds;
  const std::vector<std::string> surfaces = lower.touching_surfaces();
  for (std::size_t number = 0; number < surfaces.size(); ++number)
  {
    const auto found =
        std::find_if(named.begin(), named.end(),
                     [&](const CurvedSurface &one)
                     { return one.surface == surfaces[number] && one.kind != SurfaceKind::plane; });
    rounds.push_back(found == named.end() ? std::nullopt : std::optional(round_of(*found, own, number)));
  }
  return rounds;
}

/// For each contact node the number of the lower surface that it sees most of.
std::vector<std::size_t> seen_surfaces(const ContactSurface &own, const Eigen::SparseMatrix<double> &map,
                                       const std::size_t n_surfaces)
{
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(map.rows(), static_cast<Eigen::Index>(n_surfaces));
  for (Eigen::Index j = 0; j < map.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(map, j); it; ++it)
      weights(it.row(), own.nodes[static_cast<std::size_t>(j)].surface) += std::abs(it.value());
  std::vector<std::size_t> surfaces;
  for (Eigen::Index i = 0; i < map.rows(); ++i)
  {
    Eigen::Index most = 0;
    weights.row(i).maxCoeff(&most);
    surfaces.push_back(static_cast<std::size_t>(most));
  }
  return surfaces;
}
} // namespace

void measure_from_named_forms(const GeometryOptions &lower, const ContactSurface &surface,
                              const ContactSurface &own, const Eigen::SparseMatrix<double> &map,
                              Eigen::VectorXd &distances)
{
  const std::vector<std::optional<Round>> rounds = named_rounds(lower, own);
  if (std::none_of(rounds.begin(), rounds.end(), [](const auto &round) { return round.has_value(); }))
    return;
  const std::vector<std::size_t> seen = seen_surfaces(own, map, rounds.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (const auto &round = rounds[seen[i]])
      if (const auto distance = round->distance(surface.nodes[i].place(), surface.nodes[i].inward))
        distances[static_cast<Eigen::Index>(i)] = *distance;
}
} // namespace orthocone
