// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A cycle is a closed line over the plane of motions. Its longest chord has the direction e. With the motion
// delta = e . u and the force Q = e . f the figures are those of the loop Q(delta), whose area E_d friction
// dissipates:
//
//   slip ratio     delta_0 / delta*          delta* = half the stroke, delta_0 = half the width at Q = 0
//   energy ratio   E_d / (4 Q* delta*)       Q* = largest |Q|
//   friction       Q* / P,   E_d / (4 P delta_0),   Q_0 / P     Q_0 = half the height at delta = 0
//   stiffness      dQ / d delta of the step behind a reversal, mean of both ends
//
// E_d, E_t = 4 Q* delta* and their ratio: Fouvry, Kapsa and Vincent, Wear 185 (1995) and 200 (1996); slip
// ratio: Varenberg, Etsion and Halperin, Tribology Letters 17 (2004); friction by energy and by the middle of
// the loop: Heredia and Fouvry, Wear 269 (2010).
#include <orthocone/results/fretting_loop.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
/// A share of the stroke that rounding and the tolerance of solvers cannot tell from zero.
constexpr double unseen = 1e-6;

/// A point of the loop along its direction.
struct AlongStroke
{
  double motion, force, normal_force;
};
using Path = std::vector<AlongStroke>;
using Member = double AlongStroke::*;

const LoopPoint &farthest(const std::vector<LoopPoint> &points, const Vector2d &from)
{
  return *std::max_element(points.begin(), points.end(),
                           [&from](const LoopPoint &a, const LoopPoint &b)
                           { return (a.motion - from).norm() < (b.motion - from).norm(); });
}

/// Between ends of the path that are the farthest of each other: from one to the other until that is so,
/// which takes as many passes as the path has corners at most, and two on a straight one.
Vector2d chord(const std::vector<LoopPoint> &points)
{
  Vector2d begin = points.front().motion, end = begin;
  for (double longer = 1; longer > 0;)
  {
    const double length = (end - begin).norm();
    begin = end;
    end = farthest(points, begin).motion;
    longer = (end - begin).norm() - length;
  }
  return end - begin;
}

Path along(const std::vector<LoopPoint> &points, const Vector2d &direction)
{
  Path path;
  for (const LoopPoint &point : points)
    path.push_back({direction.dot(point.motion), direction.dot(point.force), point.normal_force});
  return path;
}

/// The last point where the path takes `level` in a member while that grows (`sense` = 1) or falls (-1).
std::optional<AlongStroke> last_pass(const Path &path, const Member of, const double level,
                                     const double sense, const double tolerance)
{
  std::optional<AlongStroke> found;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const double begin = sense * (path[i - 1].*of - level), end = sense * (path[i].*of - level);
    if (begin >= -tolerance || end < -tolerance)
      continue;
    const double share = std::min(1., begin / (begin - end));
    const auto between = [&](const Member member)
    { return (1 - share) * path[i - 1].*member + share * path[i].*member; };
    found = AlongStroke{between(&AlongStroke::motion), between(&AlongStroke::force),
                        between(&AlongStroke::normal_force)};
  }
  return found;
}

/// Width of the loop at Q = 0, mm.
std::optional<double> width(const Path &path, const double peak_force)
{
  const double tolerance = unseen * peak_force;
  const auto up = last_pass(path, &AlongStroke::force, 0, 1, tolerance);
  const auto down = last_pass(path, &AlongStroke::force, 0, -1, tolerance);
  if (!up || !down)
    return std::nullopt;
  return std::abs(up->motion - down->motion);
}

/// Mean of both coefficients in the middle of the stroke.
std::optional<double> geometric_friction(const Path &path, const double stroke)
{
  const double tolerance = unseen * stroke;
  const auto [low, high] = std::minmax_element(
      path.begin(), path.end(), [](const auto &a, const auto &b) { return a.motion < b.motion; });
  const double middle = 0.5 * (low->motion + high->motion);
  const auto up = last_pass(path, &AlongStroke::motion, middle, 1, tolerance);
  const auto down = last_pass(path, &AlongStroke::motion, middle, -1, tolerance);
  if (!up || !down || up->normal_force <= 0 || down->normal_force <= 0)
    return std::nullopt;
  return 0.5 * (up->force / up->normal_force - down->force / down->normal_force);
}

/// Slope of the first step behind the reversal that is farthest out at the end `sense` (1 or -1) of the
/// stroke. A path that ends where it began goes round: its first step may be the one behind a reversal.
std::optional<double> slope_behind(const Path &path, const double sense, const double stroke)
{
  const std::size_t n = path.size() - 1;
  const bool is_closed = std::abs(path.back().motion - path.front().motion) <= 1e-3 * stroke;
  const auto way = [&](const std::size_t i) { return sense * (path[i].motion - path[i - 1].motion); };
  double before = 0, outmost = 0;
  std::optional<double> slope;
  for (std::size_t step = 1; step <= (is_closed ? 2 * n : n); ++step)
  {
    const std::size_t i = (step - 1) % n + 1;
    if (std::abs(way(i)) <= unseen * stroke)
      continue;
    const double place = sense * path[i - 1].motion;
    if (before > 0 && way(i) < 0 && (!slope || place > outmost))
    {
      outmost = place;
      slope = (path[i].force - path[i - 1].force) / (path[i].motion - path[i - 1].motion);
    }
    before = way(i);
  }
  return slope;
}

std::optional<double> side_stiffness(const Path &path, const double stroke)
{
  const auto at_end = slope_behind(path, 1, stroke), at_begin = slope_behind(path, -1, stroke);
  if (at_end && at_begin)
    return 0.5 * (*at_end + *at_begin);
  return at_end ? at_end : at_begin;
}

/// Mean of the normal force over the way of the loop, N.
double mean_normal_force(const Path &path)
{
  double way = 0, sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const double part = std::abs(path[i].motion - path[i - 1].motion);
    way += part;
    sum += 0.5 * part * (path[i].normal_force + path[i - 1].normal_force);
  }
  return relative(sum, way);
}

/// E_d, N mm: work of Q on the way of the face, back to the start in a straight line.
double area(const Path &path)
{
  double sum = 0;
  const AlongStroke *before = &path.back();
  for (const AlongStroke &point : path)
  {
    sum += 0.5 * (before->force + point.force) * (point.motion - before->motion);
    before = &point;
  }
  return sum;
}

/// The closed part of a path that begins elsewhere than it ends, as that of the first cycle of a run does:
/// from the first point on that is as good as the end, if it still goes through all of the stroke.
Path without_run_in(const Path &path, const double stroke, const double peak_force)
{
  constexpr double alike = 1e-3;
  const AlongStroke &end = path.back();
  const auto begin = std::find_if(path.begin(), path.end(),
                                  [&](const AlongStroke &point)
                                  {
                                    return std::abs(point.motion - end.motion) <= alike * stroke &&
                                           std::abs(point.force - end.force) <= alike * peak_force;
                                  });
  const auto [low, high] = std::minmax_element(
      begin, path.end(), [](const auto &a, const auto &b) { return a.motion < b.motion; });
  return high->motion - low->motion >= (1 - alike) * stroke ? Path(begin, path.end()) : path;
}

/// Whether the motion is more than the tolerance leaves of one that forces or symmetry hold at zero.
bool is_loop(const std::vector<LoopPoint> &points, const double stroke)
{
  double largest = 0;
  for (const LoopPoint &point : points)
    largest = std::max({largest, std::abs(point.approach), point.motion.norm()});
  return stroke > unseen * largest;
}
} // namespace

LoopFigures loop_figures(const std::vector<LoopPoint> &points)
{
  LoopFigures figures;
  const Vector2d longest = points.empty() ? Vector2d(0, 0) : chord(points);
  const double stroke = longest.norm();
  if (!is_loop(points, stroke))
    return figures;
  Path path = along(points, longest / stroke);
  const AlongStroke peak =
      *std::max_element(path.begin(), path.end(),
                        [](const auto &a, const auto &b) { return std::abs(a.force) < std::abs(b.force); });
  figures.stroke = stroke;
  figures.peak_force = std::abs(peak.force);
  if (figures.peak_force == 0)
    return figures;
  path = without_run_in(path, stroke, figures.peak_force);
  const double dissipation = area(path);
  figures.energy_ratio = dissipation / (2 * figures.peak_force * stroke);
  if (peak.normal_force > 0)
    figures.friction_largest = figures.peak_force / peak.normal_force;
  figures.friction_geometric = geometric_friction(path, stroke);
  figures.stiffness = side_stiffness(path, stroke);
  const std::optional<double> opening = width(path, figures.peak_force);
  if (!opening)
    return figures;
  figures.slip_ratio = *opening / stroke;
  if (const double pressed = mean_normal_force(path); pressed > 0 && *opening > unseen * stroke)
    figures.friction_energy = dissipation / (2 * pressed * *opening);
  return figures;
}
} // namespace orthocone
