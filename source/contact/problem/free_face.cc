// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/free_face.h>

#include <stdexcept>

namespace orthocone
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

FreeFace::FreeFace(const MatrixXd &motions, const VectorXd &balance, const MatrixXd &stiffness)
{
  constexpr double dependent = 1e-10; // a column's own part, relative to the column
  const Eigen::HouseholderQR<MatrixXd> factorization(motions);
  columns_ = factorization.householderQ() * MatrixXd::Identity(motions.rows(), motions.cols());
  triangle_ = factorization.matrixQR().topRows(motions.cols()).triangularView<Eigen::Upper>();
  for (Eigen::Index i = 0; i < motions.cols(); ++i)
    if (!(std::abs(triangle_(i, i)) > dependent * motions.col(i).norm()))
      throw std::invalid_argument(
          "motions of a face that forces drive do not move the contact surface independently");
  balance_ = triangle_.transpose().triangularView<Eigen::Lower>().solve(balance);
  if (stiffness.isZero(0))
    return;
  const MatrixXd half = triangle_.transpose().triangularView<Eigen::Lower>().solve(stiffness);
  stiffness_ = triangle_.transpose().triangularView<Eigen::Lower>().solve(MatrixXd(half.transpose()));
}

VectorXd FreeFace::motions(const VectorXd &unknowns) const
{
  return n() == 0 ? VectorXd() : VectorXd(triangle_.triangularView<Eigen::Upper>().solve(unknowns));
}

VectorXd FreeFace::unknowns(const VectorXd &motions) const
{
  return n() == 0 ? VectorXd() : VectorXd(triangle_ * motions);
}
} // namespace orthocone
