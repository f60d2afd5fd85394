// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/given_compliance.h>

#include <orthocone/surface/sparse_compliance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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
constexpr double single_error = std::numeric_limits<float>::epsilon(); // of programs in single precision

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

/// 1 / sqrt(w_ii), where it is more than rounding.
VectorXd own_scale(const DenseView &w)
{
  const double nothing = nothing_of(w);
  return w.diagonal().unaryExpr([nothing](const double entry)
                                { return 1 / std::sqrt(std::max(nothing, entry)); });
}

void check_entries(const DenseView &w)
{
  if (!w.allFinite())
    refuse("W has entries that are no numbers");
  const double least = w.diagonal().minCoeff(), largest = w.diagonal().maxCoeff();
  if (least < -single_error * largest || !(largest > 0))
    refuse("W has the entry ", least, " on its diagonal; allowed are numbers >= 0, and one that is > 0");
}

/// Two rows whose entry is larger than those on the diagonal allow, if these may be larger by `error` in this
/// scale.
std::optional<std::pair<Index, Index>> impossible_pair(const DenseView &w, const VectorXd &scale,
                                                       const double error)
{
  const VectorXd allowed =
      (w.diagonal().cwiseProduct(scale.cwiseAbs2()).array() + error).max(0.).sqrt().matrix();
  for (Index j = 0; j < w.cols(); ++j)
    for (Index i = 0; i < j; ++i)
      if (std::abs(w(i, j)) * scale[i] * scale[j] > allowed[i] * allowed[j])
        return std::pair(i, j);
  return std::nullopt;
}

constexpr Index most_rows_to_factorize = 600; // beyond, a factorization takes longer than a solution

/// W in this scale, as far as the least eigenvalue is known by products: by Lanczos' method.
double least_by_products(const DenseView &w, const VectorXd &scale)
{
  constexpr double settled = 1e-3;
  const auto product = [&](const NodeVector &v) -> NodeVector
  { return scale.cwiseProduct(w.selfadjointView<Eigen::Lower>() * scale.cwiseProduct(v)); };
  const double largest = largest_eigenvalue(w.rows() / 3, settled, product);
  const double turned = largest_eigenvalue(
      w.rows() / 3, settled, [&](const NodeVector &v) -> NodeVector { return largest * v - product(v); });
  const double least = largest - turned;
  return least < -entry_error * largest ? least : std::max(0., least); // products round
}

/// Whether forces r with r . W r < 0 are known, with W in the scale in which its diagonal is 1. Errors of the
/// entries shift eigenvalues by no more than `shift`.
bool is_indefinite(const DenseView &w, const VectorXd &scale)
{
  const double shift = entry_error * static_cast<double>(w.rows());
  const auto is_positive = [shift](MatrixXd block)
  {
    block.diagonal().array() += shift;
    return Eigen::LLT<Eigen::Ref<MatrixXd>>(block).info() == Eigen::Success;
  };
  if (w.rows() <= most_rows_to_factorize)
    return !is_positive(scale.asDiagonal() * w * scale.asDiagonal());
  for (Index i = 0; i < w.rows(); i += 3)
  {
    const auto part = scale.segment<3>(i);
    if (!is_positive(part.asDiagonal() * w.block<3, 3>(i, i) * part.asDiagonal()))
      return true;
  }
  return least_by_products(w, scale) < -shift;
}

/// The least eigenvalue that is known of W in this scale.
double least_eigenvalue(const DenseView &w, const VectorXd &scale)
{
  if (w.rows() <= most_rows_to_factorize)
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(scale.asDiagonal() * w * scale.asDiagonal(),
                                                   Eigen::EigenvaluesOnly)
        .eigenvalues()[0];
  double least = least_by_products(w, scale);
  for (Index i = 0; i < w.rows(); i += 3)
    least = std::min(least, std::pow(scale[i], 2) * Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                                        w.block<3, 3>(i, i), Eigen::EigenvaluesOnly)
                                                        .eigenvalues()[0]);
  return least;
}

/// A direction in which a node cannot move needs no force where its displacement obeys the law without.
void check_immobile(const std::vector<Index> &directions, const NodeVector &q)
{
  for (const Index i : directions)
    if (i % 3 == 0 ? q[i] < 0 : q[i] != 0)
      refuse("W is zero along ", name_of(i), " of node ", i / 3, ", which cannot move there, but ",
             i % 3 == 0 ? "penetrates" : "slips", " by ", std::abs(q[i]),
             i % 3 == 0 ? ": no forces help" : ": such motions are not supported");
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

double check_compliance(const DenseView &w, const MirrorDifference &mirrored)
{
  check_entries(w);
  const VectorXd own = own_scale(w);
  if (!impossible_pair(w, own, 2 * entry_error) && !is_indefinite(w, own))
    return 0;
  // In its own scale rounding of a stiff direction looks large beside the node's other directions.
  constexpr double most = 1e-3;
  const auto n_rows = static_cast<double>(w.rows());
  const double bearable = std::max(n_rows * single_error, std::min(mirrored.norm, most));
  const VectorXd scale = block_scale(w);
  if (const auto pair = impossible_pair(w, scale, 2 * std::max(single_error, mirrored.largest)))
    refuse("W is indefinite: an entry of nodes ", pair->first / 3, " and ", pair->second / 3,
           " is larger than those on the diagonal allow");
  const double least = least_eigenvalue(w, scale);
  if (least < -bearable)
    refuse("W is indefinite: there are forces r with r . W r < 0, which no bodies allow. Its least "
           "eigenvalue is ",
           least, " relative to the largest entries of the nodes; rounding explains ", -bearable,
           ". Compute W in double precision");
  return least < -n_rows * entry_error ? -least : 0;
}

std::vector<std::string> GivenCompliance::notes() const
{
  std::vector<std::string> notes;
  const auto say = [&](const char *const what, const double value, const char *const consequence)
  {
    std::ostringstream note;
    note.precision(2);
    note << what << value << consequence;
    notes.push_back(note.str());
  };
  if (asymmetry > 0)
    say("W is not symmetric: mirror images differ by up to ", asymmetry,
        " of the largest entries of their nodes, so its symmetric part is taken.");
  if (indefiniteness > 0)
    say("W is indefinite: its least eigenvalue is ", -indefiniteness,
        " relative to the largest entries of the nodes, which rounding explains, so it is taken as it is.");
  return notes;
}

GivenCompliance given_compliance(const DenseView &w, const NodeVector &q, const MirrorDifference &mirrored)
{
  if (!w.allFinite())
    check_entries(w);
  const MirrorDifference here = mirror_difference(w);
  if (here.largest > 0)
  {
    auto own = compliance_of_matrix(symmetric_part(w));
    GivenCompliance given = given_compliance(*own->dense(), q, here);
    if (given.compliance->dense()->data() == own->dense()->data())
      given.compliance = std::move(own);
    return given;
  }
  GivenCompliance given{nullptr, mirrored.largest, check_compliance(w, mirrored)};
  const std::vector<Index> directions = immobile_directions(w);
  if (directions.empty())
  {
    given.compliance = compliance_of_matrix(w);
    return given;
  }
  check_immobile(directions, q);
  MatrixXd own = w;
  for (const Index i : directions)
  {
    own.row(i).setZero();
    own.col(i).setZero();
    const double of_node = w.diagonal().segment<3>(i - i % 3).maxCoeff();
    own(i, i) = of_node > nothing_of(w) ? of_node : w.diagonal().maxCoeff();
  }
  given.compliance = compliance_of_matrix(std::move(own));
  return given;
}
} // namespace orthocone
