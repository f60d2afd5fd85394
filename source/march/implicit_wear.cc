// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/implicit_wear.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

double unfound_wear(const ContactState &before, const ContactState &after, const VectorXd &opening)
{
  double largest = 0;
  for (Index node = 0; node < after.n_nodes(); ++node)
    if (const double force = 0.5 * (before.force[3 * node] + after.force[3 * node]); force > 0)
      largest =
          std::max(largest, (after.wear_depth[node] - after.found_depth[node]) / (force * opening[node]));
  return largest;
}

double weight_of_end(const double depth_of_flattening)
{
  constexpr double small = 1e-4; // below, the first term of the series has all digits that are left
  const double z = depth_of_flattening;
  return z < small ? 0.5 + z / 12 : -1 / std::expm1(-z) - 1 / z;
}

ContactStep with_depths(const ContactStep &step, const VectorXd &depths)
{
  NodeVector q = step.q();
  for (Index node = 0; node < step.n_nodes(); ++node)
    q[3 * node] += depths[node];
  return ContactStep(step.system(), std::move(q), step.face()).with_laws(step.laws());
}

ImplicitWear::ImplicitWear(WearLaw law, ContactSolverOptions options, VectorXd opening)
    : law_(std::move(law)),
      options_(std::move(options)),
      opening_(std::move(opening))
{
}

bool ImplicitWear::is_for(const ContactState &before, const ContactState &after) const
{
  return law_.options().wears() && law_.options().deep_steps == DeepWear::implicitly &&
         unfound_wear(before, after, opening_) > most_explicit_wear;
}

/// Depth (mm) that a unit of normal force wears at each node while it slips from `before` to `after`. A node
/// that is open may close while its neighbours are worn, so that its slip counts, too.
VectorXd ImplicitWear::depths_of_a_unit(const ContactStep &problem, const ContactState &before,
                                        const ContactState &after) const
{
  VectorXd depths = VectorXd::Zero(after.n_nodes());
  for (Index node = 0; node < after.n_nodes(); ++node)
  {
    const Vector2d slip = (after.displacement - before.displacement).segment<2>(3 * node + 1);
    if (after.status[node] == NodeStatus::stick || slip.isZero(0))
      continue;
    const FrictionLaw &friction = problem.law(node);
    const double traction = friction.is_frictionless() ? 0 : friction.force_against(slip).norm();
    depths[node] = law_.depth(node, {1, slip.norm(), traction * slip.norm()});
  }
  return depths;
}

VectorXd ImplicitWear::depths(const ContactStep &problem, const ContactState &before,
                              const ContactState &after, VectorXd &unknowns) const
{
  const DenseView *dense = problem.system().compliance().dense();
  if (dense == nullptr)
    return {};
  const VectorXd of_a_unit = depths_of_a_unit(problem, before, after);
  const double theta = weight_of_end((of_a_unit.array() / opening_.array()).maxCoeff());
  Eigen::MatrixXd worn = *dense;
  VectorXd first(of_a_unit.size());
  for (Index node = 0; node < of_a_unit.size(); ++node)
  {
    worn(3 * node, 3 * node) += theta * of_a_unit[node];
    first[node] = (1 - theta) * of_a_unit[node] * std::max(before.force[3 * node], 0.);
  }
  const DenseCompliance compliance(std::move(worn));
  const ContactSystem system(compliance, problem.laws());
  const ContactStep with_first = with_depths(problem, first);
  const ContactStep step(system, with_first.q(), problem.face());
  if (!make_contact_solver(system, options_)->solve(step, unknowns).converged)
    return {};
  VectorXd depths = first;
  for (Index node = 0; node < depths.size(); ++node)
    depths[node] += theta * of_a_unit[node] * std::max(unknowns[3 * node], 0.);
  return depths;
}
} // namespace orthocone
