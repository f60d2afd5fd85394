// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "unheld_face.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
bool is_closed(const NodeCondition &condition)
{
  return condition.n_unknowns > 0;
}

/// Rows of the columns of the face that move the nodes along the normal: n x m.
MatrixXd normal_rows(const MatrixXd &columns)
{
  return columns(Eigen::seq(0, Eigen::last, 3), Eigen::all);
}

/// The motions of the face that leave the gaps of all closed nodes as they are, and that the body itself does
/// not resist: orthonormal columns.
MatrixXd unheld_motions(const ContactStep &step, const MatrixXd &normal,
                        const std::vector<NodeCondition> &conditions)
{
  constexpr double rounding = 1e-10;
  MatrixXd hold = MatrixXd::Zero(normal.cols(), normal.cols());
  if (step.face().has_stiffness())
    hold = step.system().softness() * step.face().stiffness();
  for (Index node = 0; node < normal.rows(); ++node)
    if (is_closed(conditions[node]))
      hold += normal.row(node).transpose() * normal.row(node);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> holds(hold);
  return holds.eigenvectors().leftCols((holds.eigenvalues().array() < rounding).count());
}

/// What the face must carry besides the forces of the closed nodes, N. Open nodes are about to carry none.
VectorXd load_without_open(const ContactStep &step, VectorXd unknowns,
                           const std::vector<NodeCondition> &conditions)
{
  for (Index node = 0; node < step.n_nodes(); ++node)
    if (!is_closed(conditions[node]))
      unknowns.segment<3>(3 * node).setZero();
  return -step.imbalance(unknowns);
}

/// A node that approaches the obstacle as the face moves.
struct Approach
{
  double touches; ///< length of the increment at which it begins to carry, mm/N
  double grows;   ///< how fast it carries the load from there on, N^3/mm
};

/// Share of the increment at which the nodes carry `load` (N^2) together, or 0 if there are none.
double length_to_carry(const double load, std::vector<Approach> approaches)
{
  std::sort(approaches.begin(), approaches.end(),
            [](const Approach &a, const Approach &b) { return a.touches < b.touches; });
  double length = 0, grows = 0, missed = 0;
  for (const Approach &node : approaches)
  {
    if (grows > 0 && length <= node.touches)
      break;
    grows += node.grows;
    missed += node.grows * node.touches;
    length = (load + missed) / grows;
  }
  return length;
}
} // namespace

bool is_unheld_without_forces(const ContactStep &step, const VectorXd &unknowns)
{
  return step.face().n() > 0 && unknowns.head(step.q().size()).isZero(0);
}

VectorXd balancing_start(const ContactStep &step)
{
  VectorXd unknowns = VectorXd::Zero(step.n_unknowns());
  unknowns.head(step.q().size()) = step.face().columns() * step.face().balance();
  return step.admissible(unknowns);
}

VectorXd increment_of_unheld_face(const ContactStep &step, const VectorXd &unknowns,
                                  const NodeVector &displacement, const ContactConditions &conditions,
                                  const double rho_factor)
{
  constexpr double worth_an_increment = 1e-4, rounding = 1e-8;
  if (step.face().n() == 0)
    return {};
  const MatrixXd normal = normal_rows(step.face().columns());
  const MatrixXd free = unheld_motions(step, normal, conditions.nodes);
  if (free.cols() == 0)
    return {};
  const MatrixXd moved = normal * free;
  const VectorXd load = free.transpose() * load_without_open(step, unknowns, conditions.nodes);
  const VectorXd increment =
      moved.transpose() * (moved * load);   // what only slides along the obstacle has no part
  const VectorXd speed = moved * increment; // of the nodes towards the obstacle
  if (speed.norm() <= worth_an_increment * step.force_scale(unknowns))
    return {};
  std::vector<Approach> approaches;
  for (Index node = 0; node < speed.size(); ++node)
  {
    const double rho = rho_factor * step.system().rho(node);
    if (!is_closed(conditions.nodes[node]) && speed[node] > rounding * speed.norm())
      approaches.push_back({(displacement[3 * node] - unknowns[3 * node] / rho) / speed[node],
                            rho * speed[node] * speed[node]});
  }
  const double length = length_to_carry(speed.squaredNorm(), std::move(approaches));
  return length > 0 ? VectorXd(-length * free * increment) : VectorXd();
}
} // namespace orthocone
