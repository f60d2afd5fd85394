// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/first_contact.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/surface/rigid_motion.h>

#include <algorithm>
#include <limits>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
constexpr unsigned int normal_component = 2;

/// The held face on its way through the program, as long as motions alone determine where it is.
class Way
{
public:
  void pass(const Leg &leg)
  {
    constexpr unsigned int first_rotation = 3;
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      if (leg.targets[i])
      {
        by_force_[i] = leg.targets[i]->by_force;
        motion_[i] = leg.motion(i).value_or(0) * (i < first_rotation ? 1 : radians_per_degree);
      }
  }

  /// Whether a force other than 0 takes over from a motion along z in this leg.
  bool is_left_by(const Leg &leg) const
  {
    const auto &target = leg.targets[normal_component];
    return target && target->by_force && target->value != 0 && !by_force_[normal_component];
  }

  const RigidMotion &motion() const { return motion_; }

private:
  RigidMotion motion_{};
  std::array<bool, n_rigid_components> by_force_{};
};

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
  const double height = sample.held_centre[2];
  const LoadOptions &load = parameters.load;
  Way way;
  const auto pass = [&](const std::vector<Leg> &legs, const std::string &entry)
  {
    for (std::size_t i = 0; i < legs.size(); ++i)
    {
      if (way.is_left_by(legs[i]))
        if (const double gap = least_gap(obstacle, sample, way.motion()); gap > rounding * height)
          throw InputError("Load program/" + entry + ": Fz presses from leg " + std::to_string(i + 1) +
                           " on, where a gap of " + to_text(gap) +
                           " mm is open: allowed is a leg before it that closes the gap by a motion of uz");
      way.pass(legs[i]);
    }
  };
  pass(load.preload, "Preload");
  for (unsigned int cycle = 0; cycle < std::min(load.cycles, 2u); ++cycle)
    pass(load.legs, "Legs");
}
} // namespace orthocone
