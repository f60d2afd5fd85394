// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/lower_body.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
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
const LocalAxes &own_axes()
{
  static const LocalAxes axes(0.);
  return axes;
}

void require(const SurfaceCover &cover)
{
  constexpr double percent = 100;
  if (!cover.is_enough())
    throw InputError("Obstacle/Kind = body: the lower body is under " +
                     to_text(std::round(percent * cover.least)) +
                     " % of the face of the contact surface about " +
                     place_text(Eigen::Vector2d(cover.uncovered[0], cover.uncovered[1])) +
                     ": allowed are 90 and more of every face; the larger contact surface is that of the "
                     "lower body");
}

MortarMap checked_map(const ContactSurface &surface, const ContactSurface &own, const ModelSymmetry &symmetry)
{
  MortarMap mortar = mortar_map(surface, own, symmetry);
  require(mortar.cover);
  return mortar;
}

/// The map with three rows for each contact node, in its axes, and three columns for each node of the lower
/// body: normal forces are the same on the image, tangential ones opposite. Directions that symmetry holds
/// have no entries.
Eigen::SparseMatrix<double> with_axes(const Eigen::SparseMatrix<double> &map, const ContactSurface &surface,
                                      const LocalAxes &axes, const ContactSurface &own)
{
  static const std::array<double, 3> sign{{-1, -1, 1}}; // along x, y, z
  std::vector<Eigen::Triplet<double>> terms;
  const Eigen::Matrix3d from_own = own_axes().global_in_local(0);
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

NodeVector depths(const ContactSurface &own)
{
  NodeVector depths = NodeVector::Zero(3 * static_cast<Index>(own.nodes.size()));
  for (std::size_t i = 0; i < own.nodes.size(); ++i)
    depths[3 * static_cast<Index>(i)] = own.nodes[i].height;
  return depths;
}
} // namespace

LowerBody::LowerBody(const Parameters &parameters, const ModelSymmetry &symmetry,
                     const ContactSurface &surface, const LocalAxes &axes, PhaseSeconds &seconds)
    : body_(
          parameters.lower, symmetry, [](const ContactSurface &) { return own_axes(); },
          [&](const Body &meshed) { require_hold(parameters.lower.geometry, meshed.unknowns(), symmetry); },
          seconds),
      map_(timed(seconds.condensation,
                 [&] {
                   return with_axes(checked_map(surface, body_.surface(), symmetry).map, surface, axes,
                                    body_.surface());
                 })),
      gaps_(parted(depths(body_.surface())))
{
}

MatrixXd LowerBody::compliance() const
{
  return mapped_compliance(map_, *body_.compliance().dense());
}

void require_cover(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return;
  const Body upper(parameters, symmetry);
  const Body lower(parameters.lower, symmetry);
  require(surface_cover(as_faces(upper.unknowns().contact_surface(), symmetry),
                        as_faces(lower.unknowns().contact_surface(), symmetry)));
}
} // namespace orthocone
