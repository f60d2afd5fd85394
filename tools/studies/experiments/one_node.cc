// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "experiments.h"

#include <orthocone/base/numbers.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <iostream>
#include <map>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct NodeSolution
{
  char state; ///< o open, k stuck, s slipping
  Vector3d force;
};

/// All solutions of a node with isotropic friction that moves in the plane of n and x: each state in turn is
/// assumed and kept if it turns out to be right.
std::vector<NodeSolution> all_solutions(const Matrix3d &w, const double mu, const Vector3d &q)
{
  std::vector<NodeSolution> solutions;
  if (q[0] >= 0)
    solutions.push_back({'o', Vector3d::Zero()});
  const Vector3d stuck = -w.inverse() * q;
  if (stuck[0] > 0 && std::abs(stuck[1]) <= mu * stuck[0])
    solutions.push_back({'k', stuck});
  for (const double forward : {1., -1.}) // the sense of slip
  {
    const Vector3d direction(1, -forward * mu, 0);
    const Vector3d force = -q[0] / (w.row(0) * direction) * direction;
    if (force[0] > 0 && forward * (q + w * force)[1] > 0)
      solutions.push_back({'s', force});
  }
  return solutions;
}

std::map<std::string, double> numbers(const Words &words)
{
  std::map<std::string, double> values{{"--coupling", 0.4}, {"--friction", 1}, {"--loads", 360}};
  for (std::size_t i = 0; i < words.size(); i += 2)
    if (values.count(words[i]) == 0 || i + 1 == words.size())
      throw std::runtime_error("'" + words[i] + "' is not an option, or lacks its value");
    else
      values[words[i]] = std::stod(words[i + 1]);
  return values;
}

/// State of the solution that the method finds from no force, or '-'.
char found_by(const std::string &method, const ContactStep &problem,
              const std::vector<NodeSolution> &solutions)
{
  constexpr double same = 1e-6;
  ContactSolverOptions options;
  options.method = method;
  NodeVector force = Vector3d::Zero();
  if (make_contact_solver(problem.system(), options)->solve(problem, force).converged)
    for (const NodeSolution &solution : solutions)
      if ((force - solution.force).norm() <= same * (1 + solution.force.norm()))
        return solution.state;
  return '-';
}
} // namespace

void one_node(const Words &words)
{
  auto values = numbers(words);
  const double coupling = values["--coupling"];
  const double mu = values["--friction"] / std::abs(coupling);
  Matrix3d w = Matrix3d::Identity();
  w(0, 1) = w(1, 0) = coupling;
  const DenseCompliance compliance(w);
  const ContactSystem system(compliance, {OrthotropicFriction{mu, mu, mu, mu}});
  std::cout << "angle,states,n_solutions,largest_residual,newton,gauss_seidel\n";
  for (double load = 0.5; load < values["--loads"]; ++load) // none on an axis
  {
    const double angle = 2 * pi * load / values["--loads"];
    const Vector3d q(std::cos(angle), std::sin(angle), 0);
    const ContactStep problem(system, step_displacement(q, Vector3d::Zero()));
    const std::vector<NodeSolution> solutions = all_solutions(w, mu, q);
    double residual = 0;
    std::string states;
    for (const NodeSolution &solution : solutions)
    {
      residual = std::max(residual, problem.residual(solution.force));
      states += solution.state;
    }
    std::cout << angle * 180 / pi << "," << states << "," << solutions.size() << "," << residual << ","
              << found_by("newton", problem, solutions) << "," << found_by("gauss-seidel", problem, solutions)
              << "\n";
  }
}
} // namespace orthocone::studies
