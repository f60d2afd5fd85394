// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/law_errors.h>

#include <orthocone/base/numbers.h>

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
double forbidden_slip(const FrictionLaw &law, const double r_n, const Vector2d &r_t, const Vector2d &d)
{
  const Vector2d direction = law.slip_under(r_t);
  if (direction.squaredNorm() == 0)
    return d.norm();
  const Vector2d unit = direction.normalized();
  const double along = unit.dot(d);
  const double across = std::abs(unit[0] * d[1] - unit[1] * d[0]);
  const double margin = std::clamp(1 - law.load(r_t) / r_n, 0., 1.);
  return across + std::max(0., -along) + margin * std::abs(along);
}
} // namespace

void LawErrors::merge(const LawErrors &other)
{
  penetration = larger(other.penetration, penetration);
  complementarity = larger(other.complementarity, complementarity);
  friction_cone = larger(other.friction_cone, friction_cone);
  slip_rule = larger(other.slip_rule, slip_rule);
}

namespace
{
/// The scales of errors.
struct Scales
{
  double length = 0;   ///< mm
  double slip = 0;     ///< mm
  double strength = 0; ///< N
};

Scales scales_of(const ContactStep &step, const NodeVector &force, const NodeVector &displacement,
                 const NodeVector &elastic)
{
  Scales scales;
  scales.strength = largest_norm(force);
  scales.length = largest_norm(elastic);
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    scales.length = std::max(scales.length, -(displacement - elastic)[3 * node]);
    if (force[3 * node] > 0)
      scales.slip = std::max(scales.slip, displacement.segment<2>(3 * node + 1).norm());
  }
  scales.slip = std::max(scales.slip, scales.length);
  scales.strength = std::max(scales.strength, scales.length / step.system().softness());
  return scales;
}

LawErrors errors_of_node(const FrictionLaw &law, const Eigen::Vector3d &r, const Eigen::Vector3d &d,
                         const Scales &scales)
{
  const Vector2d r_t = r.tail<2>();
  LawErrors errors;
  errors.penetration = relative(std::max(0., -d[0]), scales.length);
  errors.complementarity = std::abs(std::min(relative(d[0], scales.length), relative(r[0], scales.strength)));
  errors.friction_cone = relative(std::max(0., law.load(r_t) - r[0]), scales.strength);
  // The weight is what friction can carry, because the direction of a tiny force is not known.
  if (const double friction = law.least_friction() * r[0]; friction > 0)
    errors.slip_rule =
        friction / scales.strength * relative(forbidden_slip(law, r[0], r_t, d.tail<2>()), scales.slip);
  return errors;
}
} // namespace

LawErrors law_errors(const ContactStep &step, const Eigen::VectorXd &unknowns, const NodeVector &displacement)
{
  if (!unknowns.allFinite() || !displacement.allFinite())
    return {NAN, NAN, NAN, NAN};
  const NodeVector force = unknowns.head(displacement.size());
  NodeVector elastic;
  step.system().compliance().vmult(elastic, force);
  const Scales scales = scales_of(step, force, displacement, elastic);
  LawErrors errors;
  for (Index node = 0; node < step.n_nodes(); ++node)
    errors.merge(errors_of_node(step.law(node), force.segment<3>(3 * node), displacement.segment<3>(3 * node),
                                scales));
  return errors;
}
} // namespace orthocone
