// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law_errors.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector2d;

namespace
{
/// The larger one; NaN if one of them is.
double larger(const double a, const double b)
{
  return std::isnan(a) || a > b ? a : b;
}

/// Largest magnitude of a node's vector.
double largest_norm(const NodeVector &vector)
{
  double largest = 0;
  for (Index first = 0; first < vector.size(); first += 3)
    largest = std::max(largest, vector.segment<3>(first).norm());
  return largest;
}

/// Part of the change of slip `d` that the slip rule does not allow under the force (r_n, r_t): across its
/// direction, against it, or while the force lies inside the cone.
double forbidden_slip(const OrthotropicFriction &law, const double r_n, const Vector2d &r_t,
                      const Vector2d &d)
{
  const Vector2d direction = slip_direction(law, r_t[0], r_t[1]);
  if (direction.squaredNorm() == 0)
    return d.norm();
  const Vector2d unit = direction.normalized();
  const double along = unit.dot(d);
  const double across = std::abs(unit[0] * d[1] - unit[1] * d[0]);
  const double margin = std::clamp(1 - friction_norm(law, r_t[0], r_t[1]) / r_n, 0., 1.);
  return across + std::max(0., -along) + margin * std::abs(along);
}
} // namespace

double relative(const double value, const double scale)
{
  return value == 0 ? 0 : value / scale;
}

void LawErrors::merge(const LawErrors &other)
{
  penetration = larger(other.penetration, penetration);
  complementarity = larger(other.complementarity, complementarity);
  friction_cone = larger(other.friction_cone, friction_cone);
  slip_rule = larger(other.slip_rule, slip_rule);
}

LawErrors law_errors(const ContactProblem &problem, const NodeVector &force, const NodeVector &displacement)
{
  if (!force.allFinite() || !displacement.allFinite())
    return {NAN, NAN, NAN, NAN};
  const double length = std::max(largest_norm(problem.free_displacement()), largest_norm(displacement));
  const double strength = std::max(largest_norm(force), length / problem.largest_compliance());
  LawErrors errors;
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = problem.law(node);
    const Vector2d r_t = force.segment<2>(3 * node + 1);
    const double r_n = force[3 * node];
    const double gap = displacement[3 * node];
    LawErrors of_node;
    of_node.penetration = relative(std::max(0., -gap), length);
    of_node.complementarity = std::abs(std::min(relative(gap, length), relative(r_n, strength)));
    of_node.friction_cone = relative(std::max(0., friction_norm(law, r_t[0], r_t[1]) - r_n), strength);
    // The weight is what friction can carry: the direction of a force that is next to nothing is not known.
    if (const double friction = std::min(law.mu_x, law.mu_y) * r_n; friction > 0)
      of_node.slip_rule =
          friction / strength *
          relative(forbidden_slip(law, r_n, r_t, displacement.segment<2>(3 * node + 1)), length);
    errors.merge(of_node);
  }
  return errors;
}
} // namespace orthocone
