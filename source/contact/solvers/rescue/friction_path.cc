// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "friction_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr double longest_step = 0.05; // of the path
constexpr double accurate = 1e-11;    // of the map, relative
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A force (N) that forces are measured by: that of a solution, or what would hold the nodes where none is
/// needed.
double force_of(const ContactStep &step, const VectorXd &unknowns)
{
  if (const double scale = step.force_scale(unknowns); scale > 0)
    return scale;
  double held = 0;
  for (Index node = 0; node < step.n_nodes(); ++node)
    held = std::max(held, step.system().rho(node) * step.q().segment<3>(3 * node).norm());
  return held > 0 ? held : 1;
}

VectorXd with_share(const VectorXd &unknowns, const double share)
{
  VectorXd values(unknowns.size() + 1);
  values << unknowns, share;
  return values;
}
} // namespace

FrictionPath::FrictionPath(const ContactStep &step, const VectorXd &unknowns, const double share)
    : pieces_(step),
      point_(pieces_.at(with_share(unknowns, share))),
      statuses_(pieces_.statuses(point_)),
      force_(force_of(step, unknowns)),
      tangent_(VectorXd::Unit(unknowns.size() + 1, unknowns.size())),
      longest_(longest_step)
{
  for (Index node = 0; node < step.n_nodes(); ++node)
    if (statuses_[node] == NodeStatus::open)
      point_.values.segment<3>(3 * node).setZero();
}

/// Forces count in units of those at the start, motions of the face by the forces that they cost.
VectorXd FrictionPath::weighted(const VectorXd &direction) const
{
  const ContactStep &step = pieces_.step();
  const double motion = step.system().softness() * force_;
  VectorXd result = direction;
  result.head(3 * step.n_nodes()) /= force_ * force_;
  result.segment(3 * step.n_nodes(), step.face().n()) /= motion * motion;
  return result;
}

double FrictionPath::norm(const VectorXd &direction) const
{
  return std::sqrt(direction.dot(weighted(direction)));
}

double FrictionPath::error(const VectorXd &map, const Equation &equation) const
{
  return std::hypot(map.norm() / force_, equation.value);
}

VectorXd FrictionPath::Bordered::solve(const VectorXd &map, const double last, const Index size) const
{
  const auto k = static_cast<Index>(places.size());
  VectorXd right(k);
  for (Index i = 0; i + 1 < k; ++i)
    right[i] = map[places[i]];
  right[k - 1] = last;
  const VectorXd solution = factor.solve(right);
  VectorXd all = VectorXd::Zero(size);
  for (Index i = 0; i < k; ++i)
    all[places[i]] = solution[i];
  return all;
}

FrictionPath::Bordered FrictionPath::factorized(const FrictionPoint &point, const VectorXd &row)
{
  std::vector<Index> places = pieces_.active(statuses_);
  const auto k = static_cast<Index>(places.size());
  MatrixXd matrix(k, k);
  matrix.topRows(k - 1) = pieces_.slopes(point, statuses_);
  for (Index i = 0; i < k; ++i)
    matrix(k - 1, i) = row[places[i]];
  ++n_factorizations_;
  operations_ += 2. / 3. * std::pow(static_cast<double>(k), 3);
  return {std::move(places), Eigen::PartialPivLU<MatrixXd>(matrix)};
}

/// The tangent at the point. Its direction is the one in which the determinant of the map's slopes above it
/// keeps its sign: that holds across borders of pieces and in folds, because the maps of two pieces agree at
/// their border.
void FrictionPath::orient()
{
  bordered_ = factorized(point_, weighted(tangent_));
  const MatrixXd &lu = bordered_->factor.matrixLU();
  int sign = static_cast<int>(bordered_->factor.permutationP().determinant());
  for (Index i = 0; i < lu.rows(); ++i)
    sign = lu(i, i) < 0 ? -sign : sign;
  if (orientation_ == 0)
    orientation_ = sign;
  const VectorXd along =
      bordered_->solve(VectorXd::Zero(pieces_.step().n_unknowns()), 1, point_.values.size());
  const double before = tangent_[tangent_.size() - 1];
  tangent_ = along * (sign * orientation_ / norm(along));
  const double now = tangent_[tangent_.size() - 1];
  if (!(now * before < 0))
    return;
  if (folds_.n++ == 0)
    folds_.first_share = std::max(share_before_, point_.share());
}

PieceBorder FrictionPath::border(const Index margin) const
{
  const Index n = pieces_.step().n_nodes();
  return {margin % n, margin < n};
}

/// To the nearest border along the tangent, to the end, or as far as steps go.
FrictionPath::Aim FrictionPath::first_aim(const VectorXd &margins) const
{
  const VectorXd rates = pieces_.rates_of_margins(point_, statuses_, tangent_);
  Aim aim{longest_};
  for (Index i = 0; i < margins.size(); ++i)
    if (rates[i] < 0 && std::max(margins[i], 0.) < -rates[i] * aim.length)
    {
      aim.length = std::max(margins[i], 0.) / -rates[i];
      aim.margin = i;
    }
  const double share_rate = tangent_[tangent_.size() - 1];
  if (share_rate > 0 && 1 - point_.share() < share_rate * aim.length)
    aim = {(1 - point_.share()) / share_rate, std::nullopt, true};
  return aim;
}

FrictionPath::Condition FrictionPath::condition_of(const Aim &aim) const
{
  const Index last = point_.values.size() - 1;
  if (aim.margin)
    return [this, at = *aim.margin](const FrictionPoint &point)
    {
      return Equation{pieces_.margins(point, statuses_)[at] / force_,
                      pieces_.slope_of_margin(point, statuses_, border(at)) / force_};
    };
  if (aim.is_end)
    return [last](const FrictionPoint &point) {
      return Equation{point.share() - 1, VectorXd::Unit(last + 1, last)};
    };
  return [this, row = weighted(tangent_), length = aim.length](const FrictionPoint &point) {
    return Equation{row.dot(point.values - point_.values) - length, row};
  };
}

/// Newton's method with the factor of the point from which the step began: with K t = e_last known, a change
/// that obeys another condition is K^-1 (-F, 0) + x t.
std::optional<FrictionPoint> FrictionPath::by_last_factor(VectorXd values, const Condition &condition) const
{
  constexpr unsigned int most = 7;
  constexpr double slow = 0.4;
  const VectorXd along = bordered_->solve(VectorXd::Zero(values.size() - 1), 1, values.size());
  double last_error = infinite;
  for (unsigned int i = 0; i < most; ++i)
  {
    FrictionPoint point = pieces_.at(std::move(values));
    const VectorXd map = pieces_.map(point, statuses_);
    const Equation equation = condition(point);
    const double its_error = error(map, equation);
    if (its_error < accurate)
      return point;
    if (!(its_error <= slow * last_error))
      return std::nullopt;
    last_error = its_error;
    VectorXd change = bordered_->solve(-map, 0, map.size() + 1);
    const double x = (-equation.value - equation.slope.dot(change)) / equation.slope.dot(along);
    values = point.values + change + x * along;
  }
  return std::nullopt;
}

std::optional<FrictionPoint> FrictionPath::by_newton(VectorXd values, const Condition &condition)
{
  constexpr unsigned int most = 8;
  constexpr double bearable_growth = 20, near = 1e-9;
  double first_error = 0;
  for (unsigned int i = 0;; ++i)
  {
    FrictionPoint point = pieces_.at(std::move(values));
    const VectorXd map = pieces_.map(point, statuses_);
    const Equation equation = condition(point);
    const double its_error = error(map, equation);
    if (its_error < (i < most ? accurate : near))
      return point;
    first_error = i == 0 ? its_error : first_error;
    if (i == most || !(its_error <= bearable_growth * first_error))
      return std::nullopt;
    values =
        point.values + factorized(point, equation.slope).solve(-map, -equation.value, point.values.size());
  }
}

std::optional<FrictionPoint> FrictionPath::corrected(VectorXd values, const Condition &condition)
{
  if (auto point = by_last_factor(values, condition))
    return point;
  return by_newton(std::move(values), condition);
}

/// The node takes the status of the piece behind the border. An open node that closes begins to slip, because
/// there is no force yet that friction could be weighed against.
void FrictionPath::cross(const Index margin)
{
  const PieceBorder at = border(margin);
  NodeStatus &status = statuses_[at.node];
  if (status == NodeStatus::open)
    status = NodeStatus::slip;
  else if (at.is_of_normal)
    status = NodeStatus::open;
  else
    status = status == NodeStatus::stick ? NodeStatus::slip : NodeStatus::stick;
  if (status == NodeStatus::open)
    point_.values.segment<3>(3 * at.node).setZero();
  point_ = pieces_.at(std::move(point_.values));
}

/// What a step that ended at `next` should have aimed at instead: the end where it went beyond, the first
/// border that it crossed, or a place nearer by if it was not found back to the path, or far from where it
/// was meant to end. Nothing if the step is good.
std::optional<FrictionPath::Aim> FrictionPath::better_aim(const Aim &aim, const VectorXd &margins,
                                                          const std::optional<FrictionPoint> &next) const
{
  constexpr double shorter = 0.3, far = 3, rounding = 1e-9, least_share = 1e-3;
  if (!next || norm(next->values - point_.values) > far * aim.length + rounding)
    return Aim{shorter * aim.length};
  if (next->share() > 1 && !aim.is_end)
    return Aim{aim.length * (1 - point_.share()) / (next->share() - point_.share()), std::nullopt, true};
  const double outside = -rounding * force_ / std::sqrt(static_cast<double>(pieces_.step().n_nodes()));
  const VectorXd behind = pieces_.margins(*next, statuses_);
  std::optional<Aim> better;
  for (Index i = 0; i < behind.size(); ++i)
    if (behind[i] < outside && i != aim.margin)
    {
      if (margins[i] <= -outside) // the step began at this border, and goes beyond where it comes back to it
        return Aim{shorter * aim.length};
      const double share = margins[i] / (margins[i] - behind[i]);
      const double length = aim.length * std::max(share, least_share);
      if (!better || length < better->length)
        better = Aim{length, i};
    }
  return better;
}

bool FrictionPath::advance()
{
  constexpr unsigned int most_tries = 12;
  constexpr double longer = 1.5, least = 1e-9;
  orient();
  if (!tangent_.allFinite())
    return false;
  const VectorXd margins = pieces_.margins(point_, statuses_);
  Aim aim = first_aim(margins);
  for (unsigned int i = 0; i < most_tries; ++i)
  {
    auto next = corrected(point_.values + aim.length * tangent_, condition_of(aim));
    if (const auto better = better_aim(aim, margins, next))
    {
      aim = *better;
      if (!aim.margin && !aim.is_end)
        longest_ = std::max(aim.length, least);
      continue;
    }
    share_before_ = point_.share();
    point_ = *std::move(next);
    longest_ = std::min(longest_step, longer * longest_);
    is_at_end_ = aim.is_end;
    if (aim.margin)
      cross(*aim.margin);
    return true;
  }
  return false;
}

bool FrictionPath::follow(const unsigned int most_factorizations, const double most_operations)
{
  while (!is_at_end_ && n_factorizations_ < most_factorizations && operations_ < most_operations)
    if (!advance())
      break;
  return is_at_end_;
}
} // namespace orthocone
