// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/lower_body.h>

#include "named_forms.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/body_shelf.h>
#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/surface_sample.h>
#include <orthocone/surface/strip.h>

#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;

namespace
{
Facing facing_of(const Parameters &parameters)
{
  return parameters.geometry.faces_down ? Facing::along_z : Facing::along_normals;
}

void require(const SurfaceCover &cover, const Facing facing)
{
  constexpr double percent = 100;
  if (cover.is_enough())
    return;
  const std::string share = to_text(std::round(percent * cover.least)) +
                            " % of the face of the contact surface about " + place_text(cover.uncovered);
  if (facing == Facing::along_z)
    throw InputError("Obstacle/Kind = body: the lower body is under " + share +
                     ": allowed are 90 and more of every face; the larger contact surface is that of the "
                     "lower body");
  throw InputError(
      "Obstacle/Normal = surface: the contact surface of the lower body lies opposite " + share +
      ", along its normal: allowed are 90 and more of every face; both bodies lie in their places, and "
      "the larger contact surface is that of the lower body");
}

Eigen::SparseMatrix<double> checked_map(const Parameters &parameters, const ContactSurface &surface,
                                        const ContactSurface &own, const ModelSymmetry &symmetry)
{
  MortarMap mortar = mortar_map(surface, own, symmetry, facing_of(parameters));
  require(mortar.cover, facing_of(parameters));
  return mortar.map;
}

/// The map with three rows for each contact node, in its axes, and three columns for each node of the lower
/// body, which moves against the upper one. The image of a mirrored one moves along z as the upper one does.
/// Directions that symmetry holds have no entries.
Eigen::SparseMatrix<double> with_axes(const Eigen::SparseMatrix<double> &map, const ContactSurface &surface,
                                      const LocalAxes &axes, const ContactSurface &own,
                                      const bool is_mirrored)
{
  const std::array<double, 3> sign{{-1, -1, is_mirrored ? 1. : -1.}}; // along x, y, z
  std::vector<Eigen::Triplet<double>> terms;
  const Eigen::Matrix3d from_own = LowerBody::own_axes().global_in_local(0);
  for (Index j = 0; j < map.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(map, j); it; ++it)
    {
      const auto i = static_cast<std::size_t>(it.row());
      Eigen::Vector3d scale;
      for (unsigned int d = 0; d < 3; ++d)
        scale[d] = surface.nodes[i].is_free[d] && own.nodes[static_cast<std::size_t>(j)].is_free[d]
                       ? sign[d] * it.value()
                       : 0;
      const Eigen::Matrix3d block = axes.global_in_local(i).transpose() * scale.asDiagonal() * from_own;
      for (Index row = 0; row < 3; ++row)
        for (Index column = 0; column < 3; ++column)
          if (block(row, column) != 0)
            terms.emplace_back(3 * it.row() + row, 3 * j + column, block(row, column));
    }
  Eigen::SparseMatrix<double> of_axes(3 * map.rows(), 3 * map.cols());
  of_axes.setFromTriplets(terms.begin(), terms.end());
  return of_axes;
}

/// What the heights of a mirrored lower surface add to the gaps of the contact nodes, or all of these gaps
/// where both bodies lie in their places: n numbers, mm.
Eigen::VectorXd distances_of(const Parameters &parameters, const ContactSurface &surface,
                             const ContactSurface &own, const Eigen::SparseMatrix<double> &map)
{
  if (facing_of(parameters) == Facing::along_normals)
  {
    Eigen::VectorXd measured = distances(surface, own, map);
    measure_from_named_forms(parameters.lower.geometry, surface, own, map, measured);
    return measured;
  }
  Eigen::VectorXd depths(static_cast<Index>(own.nodes.size()));
  for (Index j = 0; j < depths.size(); ++j)
    depths[j] = own.nodes[static_cast<std::size_t>(j)].height;
  return map * depths;
}

/// Along the normals of the nodes.
NodeVector as_gaps(const Eigen::VectorXd &distances)
{
  NodeVector gaps = NodeVector::Zero(3 * distances.size());
  for (Index i = 0; i < distances.size(); ++i)
    gaps[3 * i] = distances[i];
  return gaps;
}
} // namespace

const LocalAxes &LowerBody::own_axes()
{
  static const LocalAxes axes(0.);
  return axes;
}

LowerBody::LowerBody(const Parameters &parameters, const ModelSymmetry &symmetry,
                     const ContactSurface &surface, const LocalAxes &axes, PhaseSeconds &seconds)
    : facing_(facing_of(parameters)),
      body_(BodyShelf::of_process().body(
          parameters.lower, symmetry, [](const ContactSurface &) { return own_axes(); },
          [&](const Body &meshed) { require_hold(parameters.lower.geometry, meshed.unknowns(), symmetry); },
          seconds)),
      seen_(timed(seconds.condensation,
                  [&] { return checked_map(parameters, surface, body_->surface(), symmetry); })),
      map_(with_axes(seen_, surface, axes, body_->surface(), facing_ == Facing::along_z)),
      gaps_(as_gaps(distances_of(parameters, surface, body_->surface(), seen_)))
{
}

MatrixXd LowerBody::compliance() const
{
  return mapped_compliance(map_, *body_->compliance().dense());
}

Eigen::VectorXd lower_distances(const Parameters &parameters, const ModelSymmetry &symmetry,
                                const ContactSurface &surface, const ContactSurface &own)
{
  return distances_of(parameters, surface, own, checked_map(parameters, surface, own, symmetry));
}

void require_cover(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return;
  const Body upper(parameters, symmetry);
  const Body lower(parameters.lower, symmetry);
  require(surface_cover(as_faces(upper.unknowns().contact_surface(), symmetry),
                        as_faces(lower.unknowns().contact_surface(), symmetry), facing_of(parameters)),
          facing_of(parameters));
}
} // namespace orthocone
