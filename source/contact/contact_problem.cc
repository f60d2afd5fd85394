// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/contact_problem.h>
#include <orthocone/contact/law_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

ContactProblem::ContactProblem(const Compliance &compliance, std::vector<OrthotropicFriction> laws)
    : compliance_(compliance),
      given_laws_(std::move(laws)),
      free_(NodeVector::Zero(3 * compliance.n_nodes()))
{
  eigen_assert(static_cast<Index>(given_laws_.size()) == n_nodes());
  for (Index node = 0; node < n_nodes(); ++node)
  {
    laws_.push_back(normalized(given_laws_[node]));
    rho_.push_back(1 / compliance_.diagonal_block(node).diagonal().maxCoeff());
  }
  largest_compliance_ = estimate_largest_compliance();
}

double ContactProblem::estimate_largest_compliance() const
{
  constexpr unsigned int n_iterations = 15;
  // A push on the whole surface is close to the softest mode; the tilt keeps other modes in reach.
  NodeVector vector = NodeVector::LinSpaced(3 * n_nodes(), 1, 1.1);
  NodeVector image;
  double eigenvalue = 0;
  for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
  {
    vector.normalize();
    compliance_.vmult(image, vector);
    eigenvalue = image.norm();
    vector.swap(image);
  }
  return eigenvalue;
}

double ContactProblem::rounding() const
{
  return std::numeric_limits<double>::epsilon() * largest_compliance_ *
         *std::max_element(rho_.begin(), rho_.end());
}

void ContactProblem::set_step(const NodeVector &free, const NodeVector &previous)
{
  eigen_assert(free.size() == 3 * n_nodes() && previous.size() == free.size());
  constexpr double rounding = 1e-12;
  negligible_force_ = 0;
  free_ = free;
  for (Index node = 0; node < n_nodes(); ++node)
  {
    free_.segment<2>(3 * node + 1) -= previous.segment<2>(3 * node + 1);
    const double force_to_hold = rho_[node] * free_.segment<3>(3 * node).norm();
    negligible_force_ = std::max(negligible_force_, rounding * force_to_hold);
  }
}

NodeVector ContactProblem::displacement(const NodeVector &force) const
{
  NodeVector d;
  compliance_.vmult(d, force);
  d += free_;
  return d;
}

NodeVector ContactProblem::admissible(NodeVector force) const
{
  for (Index node = 0; node < n_nodes(); ++node)
    force.segment<3>(3 * node) = project(laws_[node], force.segment<3>(3 * node));
  return force;
}

NodeVector ContactProblem::natural_map(const NodeVector &force, const NodeVector &displacement) const
{
  NodeVector map(force.size());
  for (Index node = 0; node < n_nodes(); ++node)
  {
    const Vector3d r = force.segment<3>(3 * node);
    const Vector3d g = modified_displacement(laws_[node], displacement.segment<3>(3 * node));
    map.segment<3>(3 * node) = r - project(laws_[node], r - rho_[node] * g);
  }
  return map;
}

double ContactProblem::force_scale(const NodeVector &force) const
{
  return std::max(force.norm(), free_.norm() / largest_compliance_);
}

double ContactProblem::residual(const NodeVector &force) const
{
  return residual(force, displacement(force));
}

double ContactProblem::residual(const NodeVector &force, const NodeVector &displacement) const
{
  return residual_of(natural_map(force, displacement), force);
}

double ContactProblem::residual_of(const NodeVector &map, const NodeVector &force) const
{
  const double error = map.norm();
  const double scale = force_scale(force);
  if (!std::isfinite(error) || !std::isfinite(scale))
    return std::numeric_limits<double>::infinity();
  return relative(error, scale);
}

NodeStatus ContactProblem::status(const Index node, const NodeVector &force,
                                  const NodeVector &displacement) const
{
  const Vector3d r = force.segment<3>(3 * node);
  if (r[0] <= negligible_force_)
    return NodeStatus::open;
  const Vector3d g = modified_displacement(laws_[node], displacement.segment<3>(3 * node));
  switch (cone_zone(laws_[node], r - rho_[node] * g))
  {
  case ConeZone::polar:
    return NodeStatus::open;
  case ConeZone::inside:
    return NodeStatus::stick;
  case ConeZone::outside:
    break;
  }
  return NodeStatus::slip;
}
} // namespace orthocone
