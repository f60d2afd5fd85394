// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/body_overlap.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/body.h>
#include <orthocone/scene/lower_body.h>
#include <orthocone/scene/obstacle.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
/// Whether both bodies lie in their places.
bool has_curved_bodies(const Parameters &parameters)
{
  return parameters.obstacle.kind == ObstacleKind::body && !parameters.geometry.faces_down;
}

const Load *interference(const Parameters &parameters)
{
  const std::vector<Load> &loads = parameters.load.loads;
  const auto found =
      std::find_if(loads.begin(), loads.end(), [](const Load &load) { return load.kind->drives_overlap(); });
  return found == loads.end() ? nullptr : &*found;
}

struct Overlap
{
  double depth = 0, of_cell = 0; ///< the largest one (mm), and the largest part of a cell's size
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

Overlap overlap_of(const Eigen::VectorXd &gaps, const ContactSurface &surface)
{
  const Eigen::VectorXd sizes = cell_sizes(surface);
  Overlap largest;
  for (Eigen::Index i = 0; i < gaps.size(); ++i)
  {
    constexpr double rounding = 1e-9;
    const double depth = -gaps[i];
    if (depth > (1 + rounding) * largest.depth)
    {
      largest.depth = depth;
      largest.place = surface.nodes[static_cast<std::size_t>(i)].place();
    }
    largest.of_cell = std::max(largest.of_cell, depth / sizes[i]);
  }
  return largest;
}

std::string overlap_text(const Overlap &overlap)
{
  std::ostringstream depth;
  depth << std::setprecision(4) << overlap.depth;
  return "Obstacle/Normal = surface: both bodies overlap by up to " + depth.str() + " mm, at " +
         place_text(overlap.place);
}

/// The direction of a line, or the normal of a face, of length 1.
Eigen::Vector3d direction_of(const ContactSurface &surface, const std::vector<unsigned int> &face)
{
  const auto at = [&](const std::size_t i) { return surface.place(face[i]).place(); };
  const std::size_t last = face.size() - 1, side = surface.degree;
  const Eigen::Vector3d diagonal = at(last) - at(0);
  return (last == side ? diagonal : Eigen::Vector3d(diagonal.cross(at(last - side) - at(side)))).normalized();
}

/// By how much facets of degree 1 miss the curved surface that they stand for, mm: h tan(t/4)/2 for facets of
/// width h that meet at an angle t. 45 degrees and more are an edge of the body.
double missed_by_facets(const ContactSurface &surface)
{
  constexpr double straight = 1 - 1e-9, edge = 0.7; // cosines
  if (surface.degree > 1)
    return 0;
  const Eigen::VectorXd sizes = cell_sizes(surface);
  std::vector<Eigen::Vector3d> first(surface.n_places(), Eigen::Vector3d::Zero());
  double missed = 0;
  for (const auto &face : surface.faces)
    for (const unsigned int node : face)
    {
      const Eigen::Vector3d direction = direction_of(surface, face);
      const double cosine = std::abs(first[node].dot(direction));
      if (first[node].isZero(0))
        first[node] = direction;
      else if (cosine < straight && cosine > edge && node < surface.nodes.size())
        missed = std::max(missed, sizes[node] * std::tan(std::acos(cosine) / 4) / 2);
    }
  return missed;
}

/// A warning where nodes are measured from facets, or none.
std::vector<std::string> facet_warning(const GeometryOptions &lower, const double missed)
{
  const bool is_named = !lower.curved_surfaces.empty() || lower.shape == BodyShape::cylinder;
  if (missed == 0 || is_named)
    return {};
  std::ostringstream length;
  length << std::setprecision(2) << missed;
  return {
      "Obstacle/Normal = surface: elements of degree 1 make facets of a curved contact surface, which miss "
      "it by "
      "up to " +
      length.str() +
      " mm, so that pressures differ from node to node where the cells of both bodies do not match; name the "
      "surface in " +
      lower.section + "/Curved surfaces, or take a Degree of 2 on curved cells"};
}

/// The gaps of the contact nodes of the meshed scene, mm.
Eigen::VectorXd gaps_of_meshes(const Parameters &parameters, const ModelSymmetry &symmetry,
                               const ContactSurface &surface)
{
  const Body lower(parameters.lower, symmetry);
  Eigen::VectorXd gaps = lower_distances(parameters, symmetry, surface, lower.unknowns().contact_surface());
  const NodeVector given = gaps_of(*make_obstacle(parameters.obstacle), surface);
  for (Eigen::Index i = 0; i < gaps.size(); ++i)
    gaps[i] += given[3 * i];
  return gaps;
}
} // namespace

Eigen::VectorXd cell_sizes(const ContactSurface &surface)
{
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(surface.nodes.size()));
  for (const auto &face : surface.faces)
  {
    const bool is_line = face.size() == surface.degree + 1;
    const double diagonal = (surface.place(face.back()).place() - surface.place(face.front()).place()).norm();
    for (const unsigned int node : face)
      if (node < surface.nodes.size())
        sizes[node] = std::max(sizes[node], is_line ? diagonal : diagonal / std::sqrt(2));
  }
  return sizes;
}

void require_driven_overlap(const Parameters &parameters, const Eigen::VectorXd &gaps,
                            const ContactSurface &surface)
{
  constexpr double most_of_cell = 0.05; // facets of 23 degrees miss their circle by as much
  if (!has_curved_bodies(parameters))
    return;
  const Overlap overlap = overlap_of(gaps, surface);
  const Load *const load = interference(parameters);
  if (load != nullptr && overlap.depth == 0)
    throw InputError("Load program/Loads: '" + load->text() +
                     "' drives nothing, because the bodies overlap nowhere: allowed are meshes that overlap, "
                     "a negative Obstacle/Gap, such as -0.01, or no such load");
  if (overlap.of_cell > 1)
    throw InputError(overlap_text(overlap) + ", which is more than a cell: allowed are bodies that lie in "
                                             "their places, side by side, in the axes of the same scene");
  if (load == nullptr && overlap.of_cell > most_of_cell)
    throw InputError(overlap_text(overlap) + ": allowed is Load program/Loads = fit: interference, which "
                                             "legs drive from 0 to 1, or bodies that do not overlap");
}

void require_bodies_side_by_side(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (!has_curved_bodies(parameters))
    return;
  const Body upper(parameters, symmetry);
  const ContactSurface &surface = upper.unknowns().contact_surface();
  require_driven_overlap(parameters, gaps_of_meshes(parameters, symmetry, surface), surface);
}

std::vector<std::string> overlap_warnings(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  constexpr double rounding = 1e-9;
  if (!has_curved_bodies(parameters))
    return {};
  const Body upper(parameters, symmetry), lower(parameters.lower, symmetry);
  const ContactSurface &surface = upper.unknowns().contact_surface();
  std::vector<std::string> warnings = facet_warning(
      parameters.lower.geometry,
      std::max(missed_by_facets(surface), missed_by_facets(lower.unknowns().contact_surface())));
  const Overlap overlap = overlap_of(gaps_of_meshes(parameters, symmetry, surface), surface);
  if (interference(parameters) == nullptr && overlap.of_cell > rounding)
    warnings.push_back(
        overlap_text(overlap) +
        ", as meshes with other nodes on one curved surface do, and the first step presses them apart; "
        "finer cells or a higher Degree on curved surfaces make it smaller, and a small positive "
        "Obstacle/Gap takes it away");
  return warnings;
}
} // namespace orthocone
