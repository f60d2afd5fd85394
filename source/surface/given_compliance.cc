// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/given_compliance.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr double entry_error = 1e-8; // of the diagonal: what files and other programs leave of W

/// Throws std::invalid_argument with the words of all parts.
template<typename... Parts>
[[noreturn]] void refuse(const Parts &...parts)
{
  std::ostringstream message;
  message.precision(3);
  (message << ... << parts);
  throw std::invalid_argument(message.str());
}

std::string name_of(const Index direction)
{
  const char *const names[] = {"its normal", "x", "y"};
  return names[direction % 3];
}

/// What rounding leaves of an entry of the diagonal that is zero.
double nothing_of(const DenseView &w)
{
  return std::numeric_limits<double>::epsilon() * w.diagonal().maxCoeff();
}

/// 1 / sqrt(w_ii), and 0 where the diagonal is.
VectorXd scale_of(const DenseView &w)
{
  const double nothing = nothing_of(w);
  return w.diagonal().unaryExpr([nothing](const double entry)
                                { return entry > nothing ? 1 / std::sqrt(entry) : 0; });
}

void check_entries(const DenseView &w)
{
  if (!w.allFinite())
    refuse("W has entries that are no numbers");
  Index row = 0;
  const double least = w.diagonal().minCoeff(&row);
  if (least < -nothing_of(w) || !(w.diagonal().maxCoeff() > 0))
    refuse("W has the entry ", least, " on its diagonal; allowed are numbers >= 0, and one that is > 0");
}

/// Every entry against its mirror image, and against the diagonal.
void check_pairs(const DenseView &w, const VectorXd &scale)
{
  const double largest = w.diagonal().maxCoeff();
  for (Index j = 0; j < w.cols(); ++j)
    for (Index i = 0; i < j; ++i)
    {
      const double both = scale[i] * scale[j];
      const double difference = std::abs(w(i, j) - w(j, i));
      if (difference * both > entry_error)
        refuse("W is not symmetric: entries of nodes ", i / 3, " and ", j / 3, " differ by ",
               difference * both, " of those on the diagonal");
      const double allowed = both > 0 ? (1 + 2 * entry_error) / both : entry_error * largest;
      if (std::abs(w(i, j)) > allowed || (both == 0 && std::abs(w(j, i)) > allowed))
        refuse("W is indefinite: an entry of nodes ", i / 3, " and ", j / 3,
               " is larger than those on the diagonal allow");
    }
}

/// Whether forces r with r . W r < 0 are known, with W in the scale in which its diagonal is 1. Errors of the
/// entries shift eigenvalues by no more than `shift`.
bool is_indefinite(const DenseView &w, const VectorXd &scale)
{
  constexpr Index most_rows = 600; // beyond, a factorization takes longer than a solution
  const double shift = entry_error * static_cast<double>(w.rows());
  const auto is_positive = [shift](MatrixXd block)
  {
    block.diagonal().array() += shift;
    return Eigen::LLT<Eigen::Ref<MatrixXd>>(block).info() == Eigen::Success;
  };
  if (w.rows() <= most_rows)
    return !is_positive(scale.asDiagonal() * w * scale.asDiagonal());
  for (Index i = 0; i < w.rows(); i += 3)
  {
    const auto part = scale.segment<3>(i);
    if (!is_positive(part.asDiagonal() * w.block<3, 3>(i, i) * part.asDiagonal()))
      return true;
  }
  constexpr double settled = 1e-3;
  const auto product = [&](const NodeVector &v) -> NodeVector
  { return scale.cwiseProduct(w.selfadjointView<Eigen::Lower>() * scale.cwiseProduct(v)); };
  const double largest = largest_eigenvalue(w.rows() / 3, settled, product);
  const double turned = largest_eigenvalue(
      w.rows() / 3, settled, [&](const NodeVector &v) -> NodeVector { return largest * v - product(v); });
  return largest - turned < -std::max(shift, entry_error * largest);
}

/// A direction in which a node cannot move needs no force where its displacement obeys the law without.
void check_immobile(const std::vector<Index> &directions, const NodeVector &q)
{
  for (const Index i : directions)
    if (i % 3 == 0 ? q[i] < 0 : q[i] != 0)
      refuse("W is zero along ", name_of(i), " of node ", i / 3, ", which cannot move there, but ",
             i % 3 == 0 ? "penetrates" : "slips", " by ", std::abs(q[i]),
             i % 3 == 0 ? ": no forces help" : ": such motions are not known here");
}
} // namespace

std::vector<Index> immobile_directions(const DenseView &w)
{
  std::vector<Index> directions;
  for (Index i = 0; i < w.rows(); ++i)
    if (w(i, i) <= nothing_of(w))
      directions.push_back(i);
  return directions;
}

void check_compliance(const DenseView &w)
{
  check_entries(w);
  const VectorXd scale = scale_of(w);
  check_pairs(w, scale);
  if (is_indefinite(w, scale))
    refuse("W is indefinite: there are forces r with r . W r < 0, which no bodies allow");
}

DenseCompliance given_compliance(const DenseView &w, const NodeVector &q)
{
  check_compliance(w);
  const std::vector<Index> directions = immobile_directions(w);
  if (directions.empty())
    return DenseCompliance(w);
  check_immobile(directions, q);
  MatrixXd own = w;
  for (const Index i : directions)
  {
    own.row(i).setZero();
    own.col(i).setZero();
    const double of_node = w.diagonal().segment<3>(i - i % 3).maxCoeff();
    own(i, i) = of_node > nothing_of(w) ? of_node : w.diagonal().maxCoeff();
  }
  return DenseCompliance(std::move(own));
}
} // namespace orthocone
