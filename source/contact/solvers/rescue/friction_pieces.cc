// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "friction_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// d r' / d r_t. Where there is no friction, the tangential force is its own measure.
Matrix2d slopes_of_reduced_force(const FrictionLaw &law, const Vector2d &force)
{
  return law.is_frictionless() ? Matrix2d(Matrix2d::Identity())
                               : Matrix2d(law.force_derivative(force).inverse());
}

Vector2d direction_of(const TrialForce &trial)
{
  return trial.length > 0 ? Vector2d(trial.reduced / trial.length) : Vector2d(0, 0);
}
} // namespace

FrictionPieces::FrictionPieces(const ContactStep &step)
    : step_(step),
      spread_(step.n_nodes())
{
  constexpr double most = 0.05;
  std::mt19937 random; // NOLINT(cert-msc51-cpp): every run is to follow the same path
  std::uniform_real_distribution<double> spread(-most, most);
  for (double &value : spread_)
    value = spread(random);
}

VectorXd FrictionPieces::factors(const double share) const
{
  VectorXd all(step_.n_nodes());
  for (Index node = 0; node < all.size(); ++node)
    all[node] = factor(node, share);
  return all;
}

FrictionPoint FrictionPieces::at(VectorXd values) const
{
  FrictionPoint point{std::move(values), {}, {}};
  point.displacement = step_.displacement(point.values.head(step_.n_unknowns()));
  point.trials.reserve(step_.n_nodes());
  for (Index node = 0; node < step_.n_nodes(); ++node)
    point.trials.emplace_back(step_.law(node), step_.system().rho(node), point.values.segment<3>(3 * node),
                              point.displacement.segment<3>(3 * node));
  return point;
}

std::vector<NodeStatus> FrictionPieces::statuses(const FrictionPoint &point) const
{
  std::vector<NodeStatus> all;
  for (Index node = 0; node < step_.n_nodes(); ++node)
  {
    const TrialForce &trial = point.trials[node];
    const bool slips = !trial.can_stick || trial.length > factor(node, point.share()) * trial.normal;
    all.push_back(trial.is_open() ? NodeStatus::open : slips ? NodeStatus::slip : NodeStatus::stick);
  }
  return all;
}

VectorXd FrictionPieces::map(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const
{
  VectorXd map(step_.n_unknowns());
  for (Index node = 0; node < step_.n_nodes(); ++node)
  {
    const TrialForce &trial = point.trials[node];
    const double rho = step_.system().rho(node);
    const Vector3d force = point.values.segment<3>(3 * node), d = point.displacement.segment<3>(3 * node);
    if (statuses[node] == NodeStatus::open)
      map.segment<3>(3 * node) = force;
    else if (!trial.can_stick)
      map.segment<3>(3 * node) << rho * d[0], force.tail<2>();
    else if (statuses[node] == NodeStatus::stick)
      map.segment<3>(3 * node) << rho * d[0], rho * step_.law(node).reduced_slip(d.tail<2>());
    else
      map.segment<3>(3 * node) << rho * d[0],
          step_.law(node).reduced_force(force.tail<2>()) -
              factor(node, point.share()) * trial.normal * direction_of(trial);
  }
  map.tail(step_.face().n()) = step_.imbalance(point.values.head(step_.n_unknowns()));
  return map;
}

std::vector<Index> FrictionPieces::active(const std::vector<NodeStatus> &statuses) const
{
  std::vector<Index> places;
  for (Index node = 0; node < step_.n_nodes(); ++node)
    if (statuses[node] != NodeStatus::open)
      places.insert(places.end(), {3 * node, 3 * node + 1, 3 * node + 2});
  for (Index i = 3 * step_.n_nodes(); i <= step_.n_unknowns(); ++i)
    places.push_back(i);
  return places;
}

/// r' - m N y/|y| with N = r_n - rho d_n and y = r' - rho g: its derivative has the radius drawn to the
/// circle along e = y/|y|, and T = (m N/|y|)(I - e e^T) across it.
FrictionPieces::MapSlopes FrictionPieces::slipping(const FrictionPoint &point, const Index node) const
{
  const TrialForce &trial = point.trials[node];
  const FrictionLaw &law = step_.law(node);
  const double rho = step_.system().rho(node), m = factor(node, point.share());
  const Vector2d e = direction_of(trial);
  const Matrix2d across = (m * trial.normal / trial.length) * (Matrix2d::Identity() - e * e.transpose());
  const Matrix2d reduced = slopes_of_reduced_force(law, point.values.segment<2>(3 * node + 1));
  MapSlopes slopes;
  slopes.of_displacement(0, 0) = rho;
  slopes.of_force.bottomLeftCorner<2, 1>() = -m * e;
  slopes.of_displacement.bottomLeftCorner<2, 1>() = rho * m * e;
  slopes.of_force.bottomRightCorner<2, 2>() = (Matrix2d::Identity() - across) * reduced;
  slopes.of_displacement.bottomRightCorner<2, 2>() =
      rho * across * law.reduced_slip_derivative(point.displacement.segment<2>(3 * node + 1));
  slopes.of_share.tail<2>() = -slope_of_factor(node, point.share()) * trial.normal * e;
  return slopes;
}

FrictionPieces::MapSlopes FrictionPieces::slopes_of(const FrictionPoint &point, const Index node,
                                                    const NodeStatus status) const
{
  const FrictionLaw &law = step_.law(node);
  if (status == NodeStatus::slip && !law.is_frictionless())
    return slipping(point, node);
  MapSlopes slopes;
  slopes.of_displacement(0, 0) = step_.system().rho(node);
  if (law.is_frictionless())
    slopes.of_force.bottomRightCorner<2, 2>().setIdentity();
  else
    slopes.of_displacement.bottomRightCorner<2, 2>() =
        step_.system().rho(node) * law.reduced_slip_derivative(point.displacement.segment<2>(3 * node + 1));
  return slopes;
}

MatrixXd FrictionPieces::slopes(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const
{
  const std::vector<Index> places = active(statuses);
  const FreeFace &face = step_.face();
  const DenseView &w = *step_.system().compliance().dense();
  const auto k = static_cast<Index>(places.size()) - 1;
  const Index n_forces = k - face.n();
  MatrixXd slopes = MatrixXd::Zero(k, k + 1);
  MatrixXd moved(3, k); // derivative of a node's displacement
  for (Index row = 0; row < n_forces; row += 3)
  {
    const Index node = places[row] / 3;
    const MapSlopes of_node = slopes_of(point, node, statuses[node]);
    for (Index column = 0; column < n_forces; column += 3)
      moved.middleCols<3>(column) = w.block<3, 3>(3 * node, places[column]);
    if (face.n() > 0)
    {
      moved.rightCols(face.n()) = face.columns().middleRows<3>(3 * node);
      slopes.block(n_forces, row, face.n(), 3) = face.columns().middleRows<3>(3 * node).transpose();
    }
    slopes.block(row, 0, 3, k).noalias() = of_node.of_displacement * moved;
    slopes.block<3, 3>(row, row) += of_node.of_force;
    slopes.block<3, 1>(row, k) = of_node.of_share;
  }
  if (face.has_stiffness())
    slopes.block(n_forces, n_forces, face.n(), face.n()) = -face.stiffness();
  return slopes;
}

VectorXd FrictionPieces::margins(const FrictionPoint &point, const std::vector<NodeStatus> &statuses) const
{
  const Index n = step_.n_nodes();
  VectorXd margins = VectorXd::Constant(2 * n, std::numeric_limits<double>::infinity());
  for (Index node = 0; node < n; ++node)
  {
    const TrialForce &trial = point.trials[node];
    const bool is_open = statuses[node] == NodeStatus::open;
    margins[node] = is_open ? -trial.normal : trial.normal;
    if (is_open || !trial.can_stick)
      continue;
    const double left = factor(node, point.share()) * trial.normal - trial.length;
    margins[n + node] = statuses[node] == NodeStatus::stick ? left : -left;
  }
  return margins;
}

FrictionPieces::RowSlopes FrictionPieces::margin_slopes(const FrictionPoint &point, const NodeStatus status,
                                                        const PieceBorder &border) const
{
  const Index node = border.node;
  const TrialForce &trial = point.trials[node];
  const FrictionLaw &law = step_.law(node);
  const double rho = step_.system().rho(node);
  RowSlopes slopes;
  if (border.is_of_normal)
  {
    const double sign = status == NodeStatus::open ? -1 : 1;
    slopes.of_force[0] = sign;
    slopes.of_displacement[0] = -sign * rho;
    return slopes;
  }
  const double sign = status == NodeStatus::stick ? 1 : -1;
  const double m = factor(node, point.share());
  const RowVector2d e = direction_of(trial).transpose();
  slopes.of_force[0] = sign * m;
  slopes.of_displacement[0] = -sign * m * rho;
  slopes.of_force.tail<2>() = -sign * e * slopes_of_reduced_force(law, point.values.segment<2>(3 * node + 1));
  slopes.of_displacement.tail<2>() =
      sign * rho * e * law.reduced_slip_derivative(point.displacement.segment<2>(3 * node + 1));
  slopes.of_share[0] = sign * slope_of_factor(node, point.share()) * trial.normal;
  return slopes;
}

VectorXd FrictionPieces::slope_of_margin(const FrictionPoint &point, const std::vector<NodeStatus> &statuses,
                                         const PieceBorder &border) const
{
  const RowSlopes local = margin_slopes(point, statuses[border.node], border);
  const DenseView &w = *step_.system().compliance().dense();
  const Index first = 3 * border.node;
  VectorXd slope(step_.n_unknowns() + 1);
  slope.head(w.cols()) = (local.of_displacement * w.middleRows<3>(first)).transpose();
  if (step_.face().n() > 0)
    slope.segment(w.cols(), step_.face().n()) =
        (local.of_displacement * step_.face().columns().middleRows<3>(first)).transpose();
  slope.segment<3>(first) += local.of_force.transpose();
  slope[slope.size() - 1] = local.of_share[0];
  return slope;
}

VectorXd FrictionPieces::rates_of_margins(const FrictionPoint &point, const std::vector<NodeStatus> &statuses,
                                          const VectorXd &direction) const
{
  const Index n = step_.n_nodes();
  const NodeVector moved = step_.change_of_displacement(direction.head(step_.n_unknowns()));
  VectorXd rates = VectorXd::Zero(2 * n);
  for (Index node = 0; node < n; ++node)
    for (const bool is_of_normal : {true, false})
    {
      const bool is_open = statuses[node] == NodeStatus::open;
      if (!is_of_normal && (is_open || !point.trials[node].can_stick))
        continue;
      const RowSlopes local = margin_slopes(point, statuses[node], {node, is_of_normal});
      rates[is_of_normal ? node : n + node] = local.of_force.dot(direction.segment<3>(3 * node)) +
                                              local.of_displacement.dot(moved.segment<3>(3 * node)) +
                                              local.of_share[0] * direction[direction.size() - 1];
    }
  return rates;
}
} // namespace orthocone
