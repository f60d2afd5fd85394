// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/first_contact.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/body.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/load_path.h>
#include <orthocone/surface/rigid_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
constexpr unsigned int normal_component = 2;

/// Whether a force other than 0 takes over from a motion along z in this leg.
bool leaves_motion(const PathLeg &leg)
{
  const Drive &before = leg.before[normal_component], &after = leg.after[normal_component];
  return after.by_force && after.value != 0 && !before.by_force;
}

/// The motion of the held face before a leg, as far as motions alone determine where it is.
RigidMotion motion_before(const PathLeg &leg)
{
  constexpr unsigned int first_rotation = 3;
  RigidMotion motion;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    motion[i] =
        leg.before[i].by_force ? 0 : leg.before[i].value * (i < first_rotation ? 1 : radians_per_degree);
  return motion;
}

double least_gap(const Obstacle &obstacle, const SurfaceSample &sample, const RigidMotion &held)
{
  double least = std::numeric_limits<double>::infinity();
  const std::vector<Eigen::Vector3d> normals = obstacle.normals(sample.points);
  for (std::size_t i = 0; i < sample.points.size(); ++i)
  {
    const SurfacePoint &point = sample.points[i];
    const Eigen::Vector3d moved = held.at(point.place - sample.held_centre);
    least = std::min(least, obstacle.gap(point) + normals[i].dot(moved));
  }
  return least;
}
} // namespace

void require_driven_overlap(const Parameters &parameters, const Obstacle &obstacle,
                            const std::vector<SurfacePoint> &points)
{
  if (!obstacle.has_normal_z() && parameters.obstacle.kind == ObstacleKind::body)
    return; // the overlap is known when both are meshed
  const std::vector<Load> &loads = parameters.load.loads;
  const auto load =
      std::find_if(loads.begin(), loads.end(), [](const Load &one) { return one.kind->drives_overlap(); });
  const bool is_driven = load != loads.end();
  const auto deepest = std::min_element(points.begin(), points.end(),
                                        [&](const SurfacePoint &a, const SurfacePoint &b)
                                        { return obstacle.gap(a) < obstacle.gap(b); });
  const double overlap = deepest == points.end() ? 0 : -obstacle.gap(*deepest);
  if (is_driven && !(overlap > 0))
    throw InputError("Load program/Loads: '" + load->text() + "' drives nothing, because " +
                     obstacle.entry() +
                     " is negative at no place of the contact surface: allowed is a negative gap there, "
                     "such as -0.01, or no such load");
  if (!is_driven && parameters.obstacle.normal == ObstacleNormal::surface && overlap > 0)
    throw InputError(obstacle.entry() + " = " + parameters.obstacle.gap + " is " + to_text(-overlap) +
                     " mm at " + place_text(deepest->place) +
                     " of the contact surface, so that body and counterface overlap there: allowed is a "
                     "gap >= 0, or Load program/Loads = fit: interference, which legs drive from 0 to 1");
}

void require_shallow_overlap(const Obstacle &obstacle, const ContactSurface &surface)
{
  if (obstacle.has_normal_z())
    return;
  const Eigen::VectorXd sizes = cell_sizes(surface);
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
  {
    const ContactNode &node = surface.nodes[i];
    if (const double depth = -obstacle.gap({node.place(), node.inward});
        depth > sizes[static_cast<Eigen::Index>(i)])
      throw InputError(obstacle.entry() + " is " + to_text(-depth) + " mm at " + place_text(node.place()) +
                       " of the contact surface, which is inside of the counterface by more than a cell: "
                       "allowed are overlaps smaller than that, and a distance that is positive outside of "
                       "the counterface");
  }
}

/// Multigrid eliminates u_z at nodes that touch, which a normal across z does not allow.
static void require_upright_normals(const Obstacle &obstacle, const ContactSurface &surface)
{
  constexpr double least = 0.3; // cosine of the angle to z
  const std::vector<SurfacePoint> points = points_of(surface);
  const std::vector<Eigen::Vector3d> normals = obstacle.normals(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(normals[i][2] > least))
      throw InputError("Mesh/Backend = multigrid with a normal of the counterface that is more than 70 "
                       "degrees off z, at " +
                       place_text(points[i].place) + ": allowed is auto or condensed");
}

void require_fitting_surface(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.obstacle.has_normal_z())
    return;
  const auto obstacle = make_obstacle(parameters.obstacle);
  const Body body(parameters, symmetry);
  require_shallow_overlap(*obstacle, body.unknowns().contact_surface());
  if (parameters.mesh.backend == BodyBackend::multigrid)
    require_upright_normals(*obstacle, body.unknowns().contact_surface());
}

void require_contact_before_force(const Parameters &parameters, const Obstacle &obstacle,
                                  const SurfaceSample &sample)
{
  constexpr double rounding = 1e-12;
  const std::vector<Support> &supports = parameters.geometry.supports;
  if (std::any_of(supports.begin(), supports.end(),
                  [](const Support &support) { return support.directions[normal_component]; }))
    return; // they carry the force until the body touches
  if (!kind_of(parameters.geometry).is_meshed())
    return; // no node need lie where the gap is least, and a half-space finds contact from any gap
  const double height = sample.held_centre[2];
  for (const PathLeg &leg : load_path(parameters.load))
    if (leaves_motion(leg))
      if (const double gap = least_gap(obstacle, sample, motion_before(leg)); gap > rounding * height)
        throw InputError(leg.entry + ": Fz presses from " + leg.place + " on, where a gap of " +
                         to_text(gap) +
                         " mm is open: allowed is a leg before it that closes the gap by a motion of uz");
}
} // namespace orthocone
