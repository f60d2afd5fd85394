// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/first_contact.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/load_path.h>
#include <orthocone/surface/rigid_motion.h>

#include <algorithm>
#include <limits>

namespace orthocone
{
using Eigen::Vector2d;

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
  for (std::size_t i = 0; i < sample.places.size(); ++i)
  {
    const Vector2d &place = sample.places[i];
    const double height = sample.heights.empty() ? 0 : sample.heights[i];
    const Eigen::Vector3d arm = Eigen::Vector3d(place[0], place[1], height) - sample.held_centre;
    least = std::min(least, obstacle.gap(place) + height + held.at(arm)[normal_component]);
  }
  return least;
}
} // namespace

void require_contact_before_force(const Parameters &parameters, const Obstacle &obstacle,
                                  const SurfaceSample &sample)
{
  constexpr double rounding = 1e-12;
  const std::vector<Support> &supports = parameters.geometry.supports;
  if (std::any_of(supports.begin(), supports.end(),
                  [](const Support &support) { return support.directions[normal_component]; }))
    return; // they carry the force until the body touches
  const double height = sample.held_centre[2];
  for (const PathLeg &leg : load_path(parameters.load))
    if (leaves_motion(leg))
      if (const double gap = least_gap(obstacle, sample, motion_before(leg)); gap > rounding * height)
        throw InputError(leg.entry + ": Fz presses from " + leg.place + " on, where a gap of " +
                         to_text(gap) +
                         " mm is open: allowed is a leg before it that closes the gap by a motion of uz");
}
} // namespace orthocone
