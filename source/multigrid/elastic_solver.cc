// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "elastic_solver.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <string>
#include <utility>

namespace orthocone
{
ElasticSolver::ElasticSolver(const MatrixFreeStiffness<double> &stiffness, VCycle &cycle)
    : stiffness_(stiffness),
      cycle_(cycle)
{
}

/// Forces of a march resemble each other, so that a good start is worth more than a good preconditioner: the
/// combination of known solutions u_i (with forces f_i) that is nearest to the solution in energy,
///   min over c of |u - sum c_i u_i|_K,   which is   (u_i . f_j) c = (u_i . f)
/// (Fischer, Comput. Methods Appl. Mech. Engrg. 163 (1998) 193-204). It needs no product with K.
/// Takes the multiple of one known solution whose forces are nearest to these in energy, then the combination
/// of all that is nearest to the rest. The combination alone would not find this one among almost equal ones.
ElasticSolver::Vector ElasticSolver::best_start(const Vector &forces) const
{
  Vector start = stiffness_.make_vector();
  if (known_.empty())
    return start;
  Eigen::VectorXd works = works_with(forces);
  const Eigen::VectorXd energies = energies_.diagonal();
  Eigen::Index one = 0;
  works.cwiseAbs2().cwiseQuotient(energies).maxCoeff(&one);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(works.size());
  shares[one] = works[one] / energies[one];
  shares += combination(works - shares[one] * energies_.col(one));
  for (std::size_t i = 0; i < known_.size(); ++i)
    start.add(shares[static_cast<Eigen::Index>(i)], known_[i].displacement);
  return start;
}

/// Works of the forces on each of the known displacements.
Eigen::VectorXd ElasticSolver::works_with(const Vector &forces) const
{
  Eigen::VectorXd works(known_.size());
  for (std::size_t i = 0; i < known_.size(); ++i)
    works[static_cast<Eigen::Index>(i)] = known_[i].displacement * forces;
  return works;
}

/// Shares of the known solutions that do these works on each of them. Directions that differ by rounding only
/// are left out.
Eigen::VectorXd ElasticSolver::combination(const Eigen::VectorXd &works) const
{
  constexpr double independent = 1e-12; // of the energies, scaled to 1
  const Eigen::VectorXd scale = energies_.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * energies_ *
                                                             scale.asDiagonal());
  Eigen::VectorXd of_modes = modes.eigenvectors().transpose() * scale.cwiseProduct(works);
  for (Eigen::Index i = 0; i < of_modes.size(); ++i)
    of_modes[i] = modes.eigenvalues()[i] > independent ? of_modes[i] / modes.eigenvalues()[i] : 0;
  return scale.cwiseProduct(modes.eigenvectors() * of_modes);
}

ApproximateSolution ElasticSolver::approximate(const Vector &forces) const
{
  ApproximateSolution approximate{best_start(forces), stiffness_.make_vector()};
  stiffness_.vmult(approximate.residual, approximate.displacement);
  approximate.residual.sadd(-1, 1, forces);
  return approximate;
}

// Conjugate gradients from the best start, on what the start leaves. The bound is relative to the forces that
// are asked for and not to that rest, so that a good start saves iterations in proportion to its digits.
ElasticSolver::Vector ElasticSolver::solve(const Vector &forces, const double accuracy)
{
  constexpr unsigned int most_iterations = 200;
  constexpr double margin = 0.9; // so that the displacement is accurate enough for the same forces next time
  const double bound = accuracy * forces.l2_norm();
  // The same forces get the same displacement, to the last bit.
  Vector difference = forces;
  for (auto known = known_.rbegin(); known != known_.rend(); ++known)
  {
    difference.equ(1, forces);
    difference.add(-1, known->forces);
    if (difference.l2_norm() <= bound)
      return known->displacement;
  }
  ApproximateSolution approximate = this->approximate(forces);
  if (approximate.residual.l2_norm() <= bound)
  {
    remember(approximate.displacement, forces);
    return std::move(approximate.displacement);
  }
  cycle_.release();
  Vector correction = stiffness_.make_vector();
  dealii::SolverControl control(most_iterations, margin * bound, false, false);
  dealii::SolverCG<Vector> cg(control);
  try
  {
    cg.solve(stiffness_, correction, approximate.residual, cycle_);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    throw SolveError("multigrid: after " + std::to_string(most_iterations) +
                     " iterations the elastic body is not in equilibrium; cells that are far from "
                     "cubes make it so, or a Poisson ratio next to 0.5");
  }
  approximate.displacement += correction;
  remember(approximate.displacement, forces);
  return std::move(approximate.displacement);
}

const std::vector<Eigen::VectorXd> &ElasticSolver::forget_trials(const Vector &forces, const double accuracy)
{
  constexpr std::size_t most_accepted = 2; // the next one is extrapolated from these
  if (forces.l2_norm() > 0)
  {
    const Vector displacement = solve(forces, accuracy);
    if (accepted_.size() == most_accepted)
      accepted_.erase(accepted_.begin());
    accepted_.emplace_back(Eigen::Map<const Eigen::VectorXd>(
        displacement.begin(), static_cast<Eigen::Index>(displacement.locally_owned_size())));
  }
  restore(std::vector<Eigen::VectorXd>(accepted_));
  return accepted_;
}

void ElasticSolver::restore(const std::vector<Eigen::VectorXd> &accepted)
{
  // Displacements of another division of the body are of no use.
  Vector displacement = stiffness_.make_vector(), forces = stiffness_.make_vector();
  const auto fits = [n = displacement.locally_owned_size()](const Eigen::VectorXd &state)
  { return static_cast<std::size_t>(state.size()) == n; };
  const bool is_known = !any_rank(!std::all_of(accepted.begin(), accepted.end(), fits));
  accepted_ = is_known ? accepted : std::vector<Eigen::VectorXd>();
  known_.clear();
  energies_.resize(0, 0);
  for (const Eigen::VectorXd &state : accepted_)
  {
    std::copy(state.begin(), state.end(), displacement.begin());
    stiffness_.vmult(forces, displacement);
    remember(displacement, forces);
  }
}

// Keeps the matrix of works u_i . f_j beside the solutions: a row a time, since no other entry changes. A
// solution that is nearly a multiple of a known one takes its place, because both would make the matrix
// singular; else the oldest one goes.
void ElasticSolver::remember(const Vector &displacement, const Vector &forces)
{
  constexpr double same = 1e-10;
  const double energy = displacement * forces;
  if (!(energy > 0))
    return;
  Eigen::VectorXd with_known = works_with(forces);
  std::size_t goes = known_.size() < most_known ? known_.size() : 0;
  for (Eigen::Index i = 0; i < with_known.size(); ++i)
    if (with_known[i] * with_known[i] > (1 - same) * energy * energies_(i, i))
      goes = static_cast<std::size_t>(i); // a multiple
  forget(goes, with_known);
  const auto n = static_cast<Eigen::Index>(known_.size());
  energies_.conservativeResize(n + 1, n + 1);
  energies_.col(n).head(n) = with_known;
  energies_.row(n).head(n) = with_known;
  energies_(n, n) = energy;
  known_.push_back({displacement, forces});
}

/// Drops one of the known solutions, if `which` is one.
void ElasticSolver::forget(const std::size_t which, Eigen::VectorXd &with_known)
{
  if (which >= known_.size())
    return;
  known_.erase(known_.begin() + static_cast<std::ptrdiff_t>(which));
  std::vector<Eigen::Index> left;
  for (Eigen::Index i = 0; i < with_known.size(); ++i)
    if (i != static_cast<Eigen::Index>(which))
      left.push_back(i);
  energies_ = energies_(left, left).eval();
  with_known = with_known(left).eval();
}
} // namespace orthocone
