// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>

namespace orthocone::studies
{
namespace
{
using Eigen::Index;
using Eigen::Vector3d;

struct Start
{
  std::string name;
  NodeVector force;
};

/// Forces of random size, from well inside of the cone to slipping in any direction; a fifth of the nodes is
/// open.
NodeVector random_forces(const ContactStep &problem, const double size, std::mt19937 &generator)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr double open = 0.2;
  NodeVector force = NodeVector::Zero(3 * problem.n_nodes());
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    if (uniform(generator) < open)
      continue;
    const OrthotropicFriction &law = *problem.law(node).ellipse();
    const double pressing = 2 * size * uniform(generator);
    const double friction = pressing * std::min(1., 2 * uniform(generator));
    const double angle = 2 * pi * uniform(generator);
    force.segment<3>(3 * node) =
        Vector3d(pressing, friction * law.mu_x * std::cos(angle), friction * law.mu_y * std::sin(angle));
  }
  return force;
}

/// No forces, those of the last step, those that would hold every node (brought into the cone), and random
/// ones.
std::vector<Start> all_starts(const ContactStep &problem, const NodeVector &last, const unsigned int n_random,
                              std::mt19937 &generator)
{
  NodeVector stuck = problem.system().compliance().dense()->llt().solve(-problem.q());
  for (Index node = 0; node < problem.n_nodes(); ++node)
    stuck.segment<3>(3 * node) = project(*problem.law(node).ellipse(), stuck.segment<3>(3 * node));
  const double size = stuck.norm() / std::sqrt(static_cast<double>(problem.n_nodes()));
  std::vector<Start> starts{{"none", NodeVector::Zero(stuck.size())}, {"last", last}, {"stuck", stuck}};
  for (unsigned int i = 0; i < n_random; ++i)
    starts.push_back({"random", random_forces(problem, size, generator)});
  return starts;
}

struct Solution
{
  NodeVector force;
  NodeVector displacement;
};

/// Largest difference of forces relative to the largest force, and of displacements to the largest of these.
std::pair<double, double> distance(const Solution &a, const Solution &b)
{
  return {relative((a.force - b.force).lpNorm<Eigen::Infinity>(), b.force.lpNorm<Eigen::Infinity>()),
          relative((a.displacement - b.displacement).lpNorm<Eigen::Infinity>(),
                   b.displacement.lpNorm<Eigen::Infinity>())};
}

/// Number of a solution among those known; one that is new is added.
std::size_t index_of(const Solution &solution, std::vector<Solution> &known)
{
  constexpr double same = 1e-4; // W is so ill-conditioned that a residual of 1e-10 leaves 1e-6
  for (std::size_t i = 0; i < known.size(); ++i)
    if (distance(solution, known[i]).first < same)
      return i;
  known.push_back(solution);
  return known.size() - 1;
}

/// Loads that no program makes: gaps and slips that differ from node to node, three nodes in ten apart.
NodeVector random_load(const Compliance &compliance, std::mt19937 &generator)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr double apart = 0.3;
  const DenseView &w = *compliance.dense();
  NodeVector load(w.rows());
  for (Index i = 0; i < w.rows(); ++i)
  {
    const double size = uniform(generator);
    const bool is_held = w.col(i).cwiseAbs().sum() == w(i, i);
    if (i % 3 == 0)
      load[i] = uniform(generator) < apart ? size : -size;
    else
      load[i] = is_held ? 0 : 2 * size - 1;
  }
  return load;
}

/// Solves from one start after another and prints a row for each.
class Trial
{
public:
  Trial(const ContactStep &problem, const ContactSolverOptions &options, const unsigned int load)
      : problem_(problem),
        options_(options),
        load_(load)
  {
  }

  void solve(const Start &start, const std::string &method)
  {
    options_.method = method;
    Solution solution{start.force, {}};
    const SolverReport report =
        make_contact_solver(problem_.system(), options_)->solve(problem_, solution.force);
    solution.displacement = problem_.displacement(solution.force);
    std::cout << load_ << "," << start.name << "," << method << "," << report.converged << ","
              << report.iterations << "," << report.residual << ",";
    if (report.converged)
      std::cout << index_of(solution, known_);
    print_difference(solution);
  }

private:
  void print_difference(const Solution &solution) const
  {
    std::array<unsigned int, 3> n{};
    for (const NodeStatus status : problem_.statuses(solution.force, solution.displacement))
      ++n[static_cast<int>(status)];
    const auto [forces, displacements] =
        known_.empty() ? std::pair<double, double>(0, 0) : distance(solution, known_.front());
    std::cout << "," << forces << "," << displacements << "," << n[0] << "," << n[1] << "," << n[2] << "\n";
  }

  const ContactStep &problem_;
  ContactSolverOptions options_;
  unsigned int load_;
  std::vector<Solution> known_;
};
} // namespace

void starts(const Words &words)
{
  const SceneWords scene(words);
  const Scene model(scene.parameters, choose_model(scene.parameters));
  const March march(model, static_cast<unsigned int>(scene.number("step", 1)));
  const auto n_nodes = static_cast<std::size_t>(model.system().n_nodes());
  const ContactSystem system(model.system().compliance(), FrictionLaws(n_nodes, model.system().law(0)));
  const NodeVector last = march.state.displacement;
  const auto n_loads = static_cast<unsigned int>(scene.number("loads", 0));
  const auto n_random = static_cast<unsigned int>(scene.number("starts", 10));
  std::mt19937 generator(1);
  std::cout
      << "load,start,method,converged,iterations,residual,solution,force_distance,displacement_distance,"
         "n_open,n_stick,n_slip\n";
  for (unsigned int load = 0; load < std::max(n_loads, 1u); ++load)
  {
    const ContactStep problem(
        system, n_loads == 0 ? step_displacement(model.body().moved_with(march.next.motion), last)
                             : random_load(system.compliance(), generator));
    Trial trial(problem, scene.parameters.contact_solver, load);
    for (const Start &start : all_starts(problem, march.state.force, n_random, generator))
      for (const char *const method : {"newton", "gauss-seidel", "uzawa"})
        trial.solve(start, method);
  }
}
} // namespace orthocone::studies
