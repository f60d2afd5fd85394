// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "load_limit.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
constexpr double negligible_share = 1e-9; // of a load, because of rounding

/// How far a motion of the face (size m, mm) lifts every node less what friction may do against it: where
/// this is not negative for any node, no admissible force resists the motion. Size n.
VectorXd clearances(const ContactStep &step, const VectorXd &increment)
{
  const NodeVector moved = step.face().columns() * increment;
  VectorXd clearances(step.n_nodes());
  for (Index node = 0; node < step.n_nodes(); ++node)
    clearances[node] =
        moved[3 * node] - dual_norm(*step.law(node).ellipse(), moved[3 * node + 1], moved[3 * node + 2]);
  return clearances;
}

/// Whether the load does work on a motion of the face, once this has been lifted until no force resists. What
/// the lift leaves of a motion may be rounding of the motion itself.
bool is_proof(const ContactStep &step, const VectorXd &increment, const VectorXd &lift,
              const VectorXd &lifted)
{
  const double needed = std::max(0., (-clearances(step, increment).array() / lifted.array()).maxCoeff());
  const VectorXd safe = increment + needed * lift;
  const VectorXd &load = step.face().balance();
  return load.dot(safe) < -negligible_share * load.norm() * std::max(safe.norm(), increment.norm());
}

void project_on_cones(const ContactStep &step, VectorXd &forces)
{
  for (Index node = 0; node < step.n_nodes(); ++node)
    forces.segment<3>(3 * node) = project(*step.law(node).ellipse(), forces.segment<3>(3 * node));
}
} // namespace

// The admissible forces that come closest to the balance leave a rest, and this rest is the motion. They are
// found by accelerated projected gradients (Beck and Teboulle, SIAM J. Imaging Sci. 2 (2009) 183), whose
// steps have length 1 because the columns of the face are orthonormal.
bool is_beyond_every_force(const ContactStep &step)
{
  constexpr unsigned int most_iterations = 4000, interval = 50;
  const Eigen::MatrixXd &columns = step.face().columns();
  const VectorXd &load = step.face().balance();
  const auto is_ellipse = [](const FrictionLaw &law) { return law.ellipse() != nullptr; };
  if (step.face().n() == 0 || step.face().has_stiffness() || load.isZero(0) ||
      !std::all_of(step.laws().begin(), step.laws().end(), is_ellipse)) // others may not be convex
    return false;
  VectorXd normals = VectorXd::Zero(columns.rows());
  normals(Eigen::seq(0, Eigen::last, 3)).setOnes();
  const VectorXd lift = columns.transpose() * normals, lifted = clearances(step, lift);
  if (lifted.minCoeff() <= 0)
    return false; // motions press the nodes, and friction may carry anything
  VectorXd forces = VectorXd::Zero(columns.rows()), ahead = forces;
  double momentum = 1;
  for (unsigned int i = 1; i <= most_iterations; ++i)
  {
    VectorXd next = ahead - columns * (columns.transpose() * ahead - load);
    project_on_cones(step, next);
    const double later = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
    ahead = next + (momentum - 1) / later * (next - forces);
    forces = std::move(next);
    momentum = later;
    if (i % interval != 0)
      continue;
    const VectorXd rest = columns.transpose() * forces - load;
    if (rest.norm() <= negligible_share * load.norm())
      return false; // these forces balance the load
    if (is_proof(step, rest, lift, lifted))
      return true;
  }
  return false;
}
} // namespace orthocone
