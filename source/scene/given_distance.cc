// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "given_distance.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone
{
using Eigen::Vector3d;

/// Central differences of sixth order: f' = sum_k c_k (f(x + k h) - f(x - k h)) / h with c = 3/4, -3/20, 1/60
/// and the error h^6 f'''''''/140 (B. Fornberg, Math. Comp. 51, 1988, table 1).
Vector3d GivenDistance::differences(const Vector3d &place, const double step) const
{
  constexpr std::array<double, 3> weights{{3. / 4, -3. / 20, 1. / 60}};
  Vector3d gradient = Vector3d::Zero();
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int k = 0; k < weights.size(); ++k)
    {
      const Vector3d way = (k + 1) * step * Vector3d::Unit(d);
      gradient[d] += weights[k] * (at(place + way) - at(place - way)) / step;
    }
  return gradient;
}

/// Whether the slope along x, y or z jumps at a place. There (f(x + h) - 2 f(x) + f(x - h)) / h does not go
/// to 0 with h.
bool GivenDistance::has_edge(const Vector3d &place, const double reach) const
{
  constexpr double step = 1e-6, least_jump = 1e-3; // the step is relative to the reach
  const double middle = at(place);
  for (unsigned int d = 0; d < 3; ++d)
  {
    const Vector3d way = step * reach * Vector3d::Unit(d);
    if (std::abs(at(place + way) - 2 * middle + at(place - way)) > least_jump * step * reach)
      return true;
  }
  return false;
}

/// A step of 2e-3 of the surface's reach errs by less than rounding does (1e-13) on spheres and cylinders
/// down to a tenth of the reach. Near an edge, such as that of min(a, b), a smaller step stays on one side of
/// it. Where no step does, the point lies on the edge, and the differences are the mean of both sides.
GivenDistance::Gradient GivenDistance::gradient(const Vector3d &place, const double reach) const
{
  constexpr double first_step = 2e-3, settled = 1e-9, rounding = 1e-14; // the first one relative to the reach
  constexpr unsigned int most_halvings = 18;
  double step = first_step * reach;
  Vector3d coarse = differences(place, step);
  for (unsigned int i = 0; i < most_halvings; ++i, step /= 2)
  {
    const Vector3d fine = differences(place, step / 2);
    if ((fine - coarse).norm() <= settled + rounding * reach / step)
      return {fine, has_edge(place, reach)};
    coarse = fine;
  }
  return {coarse, true};
}

std::vector<GivenDistance::Gradient> GivenDistance::gradients(const std::vector<SurfacePoint> &points) const
{
  Eigen::AlignedBox3d box;
  for (const SurfacePoint &point : points)
    box.extend(point.place);
  const double size = box.isEmpty() ? 0 : box.diagonal().norm();
  const double reach = size > 0 ? size / 2 : 1; // a single point
  std::vector<Gradient> all;
  for (const SurfacePoint &point : points)
    all.push_back(gradient(point.place, reach));
  return all;
}

std::vector<Vector3d> GivenDistance::normals(const std::vector<SurfacePoint> &points) const
{
  constexpr double least = 1e-6;
  std::vector<Vector3d> normals;
  for (const Gradient &gradient : gradients(points))
  {
    const double length = gradient.value.norm();
    if (!(length > least) || !std::isfinite(length))
      throw InputError(entry() + " = " + distance_.text() + " has the gradient " +
                       (std::isfinite(length) ? "0" : "not a number") + " at " +
                       place_text(points[normals.size()].place) +
                       " of the contact surface, so that there is no normal: allowed is a distance whose "
                       "gradient has the length 1 there, such as z");
    normals.push_back(gradient.value / length);
  }
  return normals;
}

void GivenDistance::check(const std::vector<SurfacePoint> &points) const
{
  for (const SurfacePoint &point : points)
    if (const double value = at(point.place); !std::isfinite(value))
      throw InputError(entry() + " = " + distance_.text() + " is " + value_text(value) + " at " +
                       place_text(point.place) + " of the contact surface: allowed is a finite number (mm)");
  const auto nearest = std::min_element(points.begin(), points.end(),
                                        [&](const SurfacePoint &a, const SurfacePoint &b)
                                        { return at(a.place) < at(b.place); });
  if (nearest == points.end())
    return;
  const std::vector<Vector3d> normals = this->normals(points);
  if (!(normals[static_cast<std::size_t>(nearest - points.begin())].dot(nearest->inward) > 0))
    throw InputError(
        entry() + " = " + distance_.text() + " is least at " + place_text(nearest->place) +
        " of the contact surface, and grows out of the body there: allowed is a distance that grows "
        "into the body, positive outside of the counterface");
}

std::vector<std::string> GivenDistance::warnings(const std::vector<SurfacePoint> &points) const
{
  constexpr double tolerance = 0.01;
  std::vector<std::string> warnings;
  const std::vector<Gradient> all = gradients(points);
  double worst = tolerance;
  std::size_t place_of_worst = 0, edge = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (all[i].is_at_edge)
      edge = std::min(edge, i);
    else if (const double off = std::abs(all[i].value.norm() - 1); off > worst)
    {
      worst = off;
      place_of_worst = i;
    }
  if (worst > tolerance)
    warnings.push_back(entry() + ": its gradient has the length " +
                       to_text(std::round(100 * all[place_of_worst].value.norm()) / 100) + " at " +
                       place_text(points[place_of_worst].place) +
                       ", so that it is no distance there and the gap is wrong by that factor; divide the "
                       "expression by the length of its gradient");
  if (edge < points.size())
    warnings.push_back(entry() + ": the counterface has an edge at " + place_text(points[edge].place) +
                       ", where the normal of the contact node is the mean of both sides; a body that is to "
                       "touch both sides there needs a rounded corner, or a mesh without a node there");
  return warnings;
}
} // namespace orthocone
