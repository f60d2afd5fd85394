// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/contact_step.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/stop_point.h>
#include <orthocone/contact/law/natural_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// Norm of the penetrations, which are the negative gaps of q, mm.
double penetration(const NodeVector &q)
{
  double sum = 0;
  for (Index i = 0; i < q.size(); i += 3)
    sum += q[i] < 0 ? q[i] * q[i] : 0;
  return std::sqrt(sum);
}

/// Norm of the forces (N) that would hold the nodes against the displacements `free`; open gaps cost none.
double holding_force(const ContactSystem &system, const NodeVector &free)
{
  double sum = 0;
  for (Index node = 0; node < system.n_nodes(); ++node)
  {
    const Vector3d held(std::min(free[3 * node], 0.), free[3 * node + 1], free[3 * node + 2]);
    sum += system.rho(node) * system.rho(node) * held.squaredNorm();
  }
  return std::sqrt(sum);
}
} // namespace

NodeVector step_displacement(const NodeVector &free, const NodeVector &previous)
{
  eigen_assert(previous.size() == free.size());
  NodeVector q = free;
  for (Index node = 0; node < free.size() / 3; ++node)
    q.segment<2>(3 * node + 1) -= previous.segment<2>(3 * node + 1);
  return q;
}

ContactStep::ContactStep(const ContactSystem &system, NodeVector q, FreeFace face)
    : system_(&system),
      q_(std::move(q)),
      face_(std::move(face))
{
  eigen_assert(q_.size() == 3 * n_nodes());
  // The gap that a free face leaves is not known yet, but what it must carry is. If that is nothing, as in a
  // press fit around a free body, an overlap presses alone.
  const double carried = face_.n() == 0 ? 0 : face_.balance().norm();
  least_force_ = carried > 0 ? carried : penetration(q_) / system.softness();
  rounding_force_ = 2 * std::numeric_limits<double>::epsilon() * holding_force(system, q_);
}

ContactStep ContactStep::with_laws(FrictionLaws laws) const
{
  eigen_assert(static_cast<Index>(laws.size()) == n_nodes());
  ContactStep step = *this;
  step.own_laws_ = std::make_shared<const FrictionLaws>(std::move(laws));
  return step;
}

ContactStep ContactStep::with_factors(const VectorXd &factors) const
{
  if (factors.size() == 0)
    return *this;
  FrictionLaws scaled;
  for (Index node = 0; node < n_nodes(); ++node)
    scaled.push_back(law(node).scaled(factors[node]));
  return with_laws(std::move(scaled));
}

NodeVector ContactStep::change_of_displacement(const VectorXd &change) const
{
  NodeVector d;
  if (face_.n() == 0)
  {
    system_->compliance().vmult(d, change);
    return d;
  }
  system_->compliance().vmult(d, change.head(q_.size()));
  d.noalias() += face_.columns() * change.tail(face_.n());
  return d;
}

/// Every method asks for it in each of its iterations, and may be stopped here.
NodeVector ContactStep::displacement(const VectorXd &unknowns) const
{
  stop_point();
  NodeVector d = change_of_displacement(unknowns);
  d += q_;
  return d;
}

ContactChange ContactStep::approximate(const VectorXd &unknowns) const
{
  ContactChange approximate = system_->compliance().approximate(unknowns.head(q_.size()));
  approximate.displacement += q_;
  if (face_.n() > 0)
    approximate.displacement.noalias() += face_.columns() * unknowns.tail(face_.n());
  return approximate;
}

VectorXd ContactStep::admissible(VectorXd unknowns) const
{
  for (Index node = 0; node < n_nodes(); ++node)
    unknowns.segment<3>(3 * node) = admissible_force(law(node), unknowns.segment<3>(3 * node));
  return unknowns;
}

VectorXd ContactStep::imbalance(const VectorXd &unknowns) const
{
  if (face_.n() == 0)
    return {};
  VectorXd imbalance = face_.columns().transpose() * unknowns.head(q_.size()) - face_.balance();
  if (face_.has_stiffness())
    imbalance.noalias() -= face_.stiffness() * unknowns.tail(face_.n());
  return imbalance;
}

VectorXd ContactStep::natural_map(const VectorXd &unknowns, const NodeVector &displacement) const
{
  VectorXd map(n_unknowns());
  for (Index node = 0; node < n_nodes(); ++node)
  {
    const Vector3d r = unknowns.segment<3>(3 * node);
    const Vector3d d = displacement.segment<3>(3 * node);
    map.segment<3>(3 * node) = r - TrialForce(law(node), system_->rho(node), r, d).admitted(law(node));
  }
  map.tail(face_.n()) = imbalance(unknowns);
  return map;
}

double ContactStep::force_scale(const VectorXd &unknowns) const
{
  return std::max(unknowns.head(q_.size()).norm(), least_force_);
}

double ContactStep::residual(const VectorXd &unknowns) const
{
  return residual(unknowns, displacement(unknowns));
}

double ContactStep::residual(const VectorXd &unknowns, const NodeVector &displacement) const
{
  return residual_of(natural_map(unknowns, displacement), unknowns);
}

double ContactStep::approximate_residual(const VectorXd &unknowns) const
{
  const ContactChange approximate = this->approximate(unknowns);
  VectorXd map = natural_map(unknowns, approximate.displacement);
  // All processes must ask, also one without a part of the body.
  if (const double residual = system_->compliance().norm(approximate.body.residual); !(residual == 0))
  {
    map.conservativeResize(map.size() + 1);
    map.tail<1>()[0] = residual;
  }
  return residual_of(map, unknowns);
}

double ContactStep::residual_of(const VectorXd &map, const VectorXd &unknowns) const
{
  const double error = map.norm();
  const double scale = force_scale(unknowns);
  if (!std::isfinite(error) || !std::isfinite(scale) || !unknowns.allFinite())
    return std::numeric_limits<double>::infinity();
  return error <= rounding_force_ ? 0 : relative(error, scale);
}

/// A share of the largest force that would hold a node against its free displacement; open gaps cost none.
double ContactStep::negligible_force(const VectorXd &unknowns) const
{
  constexpr double rounding = 1e-12; // of the displacements
  const NodeVector free = face_.n() == 0 ? q_ : NodeVector(q_ + face_.columns() * unknowns.tail(face_.n()));
  double largest = 0;
  for (Index node = 0; node < n_nodes(); ++node)
  {
    const double penetration = std::min(free[3 * node], 0.);
    const double slip = free.segment<2>(3 * node + 1).norm();
    largest = std::max(largest, system_->rho(node) * std::hypot(penetration, slip));
  }
  return rounding * largest;
}

std::vector<NodeStatus> ContactStep::statuses(const VectorXd &unknowns, const NodeVector &displacement) const
{
  const double negligible = negligible_force(unknowns);
  std::vector<NodeStatus> all(n_nodes(), NodeStatus::open);
  for (Index node = 0; node < n_nodes(); ++node)
    if (unknowns[3 * node] > negligible)
    {
      const TrialForce trial(law(node), system_->rho(node), unknowns.segment<3>(3 * node),
                             displacement.segment<3>(3 * node));
      all[node] = trial.is_open() ? NodeStatus::open : trial.sticks() ? NodeStatus::stick : NodeStatus::slip;
    }
  return all;
}
} // namespace orthocone
