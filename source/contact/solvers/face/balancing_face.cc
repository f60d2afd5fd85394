// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "balancing_face.h"

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

BalancingFace::BalancingFace(const ContactStep &step, const VectorXd &unknowns)
    : columns_(step.face().columns()),
      softness_(step.system().softness()),
      motion_(unknowns.tail(step.face().n())),
      imbalance_(step.imbalance(unknowns))
{
  if (step.face().has_stiffness())
    compliance_ =
        (Eigen::MatrixXd::Identity(motion_.size(), motion_.size()) / softness_ + step.face().stiffness())
            .inverse();
}

Eigen::Vector3d BalancingFace::displacement(const Index node) const
{
  return columns_.middleRows<3>(3 * node) * motion();
}

Eigen::Matrix3d BalancingFace::compliance(const Index node) const
{
  const auto rows = columns_.middleRows<3>(3 * node);
  if (compliance_.size() > 0)
    return rows * compliance_ * rows.transpose();
  return softness_ * rows * rows.transpose();
}

void BalancingFace::add(const Index node, const Eigen::Vector3d &change)
{
  imbalance_.noalias() += columns_.middleRows<3>(3 * node).transpose() * change;
}

namespace
{
constexpr double negligible = 1e-4;

/// What the face lacks of its balance, relative to its forces.
double imbalance_share(const ContactStep &step, const VectorXd &unknowns)
{
  return step.imbalance(unknowns).norm() / step.force_scale(unknowns);
}

/// The part of what the face lacks of its balance that nothing in the body resists.
VectorXd unresisted(const ContactStep &step, const VectorXd &imbalance)
{
  constexpr double soft = 1e-10; // of the stiffest motion
  if (!step.face().has_stiffness())
    return imbalance;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(step.face().stiffness());
  const Eigen::MatrixXd free = modes.eigenvectors().leftCols(
      (modes.eigenvalues().array() < soft * modes.eigenvalues().maxCoeff()).count());
  return free * (free.transpose() * imbalance);
}

/// Whether a node sticks that the face would move by `increment` (mm a N of imbalance). One at the centre of
/// a face that turns sticks, too, but does not hold it.
bool is_held(const NodeVector &increment, const std::vector<NodeStatus> &statuses)
{
  constexpr double still = 0.1; // of the largest motion of a node
  double largest = 0, of_stuck = 0;
  for (std::size_t node = 0; node < statuses.size(); ++node)
  {
    const double moved = increment.segment<3>(3 * static_cast<Index>(node)).norm();
    largest = std::max(largest, moved);
    if (statuses[node] == NodeStatus::stick)
      of_stuck = std::max(of_stuck, moved);
  }
  return of_stuck > still * largest;
}
} // namespace

bool nothing_holds(const ContactStep &step, const VectorXd &unknowns)
{
  if (step.face().n() == 0 || imbalance_share(step, unknowns) <= negligible)
    return false;
  const VectorXd lacking = unresisted(step, step.imbalance(unknowns));
  if (lacking.norm() <= negligible * step.force_scale(unknowns))
    return false;
  const auto statuses = step.statuses(unknowns, step.displacement(unknowns));
  // How the face would follow what is out of balance. All open nodes do not hold it, but those will that it
  // approaches.
  const NodeVector increment = step.face().columns() * lacking;
  if (is_held(increment, statuses))
    return false;
  const bool some_slip = std::count(statuses.begin(), statuses.end(), NodeStatus::slip) > 0;
  return some_slip || !(increment(Eigen::seq(0, Eigen::last, 3)).array() < 0).any();
}

bool BalanceWatch::runs_away(const ContactStep &step, const VectorXd &unknowns)
{
  constexpr double standing = 0.98;
  constexpr unsigned int patience = 4;
  if (step.face().n() == 0)
    return false;
  const double lacking = imbalance_share(step, unknowns);
  const bool stands = lacking > negligible && lacking > standing * last_;
  last_ = lacking;
  n_standing_ = stands ? n_standing_ + 1 : 0;
  if (n_standing_ < patience)
    return false;
  // An iteration goes on while any node sticks: those that hold the face in the end may be others.
  const auto statuses = step.statuses(unknowns, step.displacement(unknowns));
  return std::count(statuses.begin(), statuses.end(), NodeStatus::stick) == 0 &&
         nothing_holds(step, unknowns);
}
} // namespace orthocone
