// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "nonlinear_elimination.h"

#include "worst_nodes.h"

#include <orthocone/surface/nearest_nodes.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
using Nodes = std::vector<Index>;

// Of the small problem: fewer neighbours would leave more for the whole surface to mend.
constexpr std::size_t most_worst = 24;
constexpr Index neighbours = 32, size_of_problem = 100;

/// The node and its nearest ones, nearest first.
Nodes neighbourhood(const DenseView &w, const Index node)
{
  Nodes nodes = nearest_nodes(w, node, neighbours);
  const auto is_nearer = [&](const Index a, const Index b)
  { return w(3 * a, 3 * node) > w(3 * b, 3 * node); };
  std::sort(nodes.begin(), nodes.end(), is_nearer);
  return nodes;
}

/// `nodes`, and their nearest ones in turn, until there are enough.
Nodes with_neighbours(Nodes nodes, const DenseView &w)
{
  std::vector<bool> is_chosen(w.rows() / 3, false);
  std::vector<Nodes> near;
  for (const Index node : nodes)
  {
    is_chosen[node] = true;
    near.push_back(neighbourhood(w, node));
  }
  for (Index k = 0; k < neighbours; ++k)
    for (const Nodes &candidates : near)
      if (const Index node = candidates[k];
          !is_chosen[node] && static_cast<Index>(nodes.size()) < size_of_problem)
      {
        is_chosen[node] = true;
        nodes.push_back(node);
      }
  return nodes;
}
} // namespace

NonlinearElimination::NonlinearElimination(const ContactSolverOptions &options, Make *const make)
    : options_(options),
      make_(make)
{
  constexpr unsigned int most_iterations = 200;
  options_.maximum_iterations = std::min(options.maximum_iterations, most_iterations);
}

/// With the nodes e that are eliminated, and the forces of all others as they are, d_e = q_e + W_ee r_e with
/// q_e = d_e - W_ee r_e of the present state: a contact problem on a block of W.
NonlinearElimination::Result NonlinearElimination::solve(const ContactStep &step, const VectorXd &unknowns,
                                                         const NodeVector &displacement) const
{
  constexpr Index least_surface = 3; // of the small problem's nodes: else it is no small one
  const DenseView *const w = step.system().compliance().dense();
  if (w == nullptr || step.n_nodes() < least_surface * size_of_problem)
    return {};
  Nodes nodes = worst_nodes(step, unknowns, displacement, most_worst + 1);
  if (nodes.size() > most_worst)
    return {};
  nodes = with_neighbours(std::move(nodes), *w);
  const Nodes entries = entries_of(nodes);
  const DenseCompliance compliance(MatrixXd((*w)(entries, entries)));
  FrictionLaws laws;
  for (const Index node : nodes)
    laws.push_back(step.law(node));
  const ContactSystem system(compliance, std::move(laws));
  VectorXd forces = unknowns(entries);
  const ContactStep problem(system, displacement(entries) - *compliance.dense() * forces);
  const SolverReport report = make_(system, options_)->solve(problem, forces);
  Result result;
  const double share = static_cast<double>(nodes.size()) / static_cast<double>(step.n_nodes());
  result.iterations = static_cast<unsigned int>(std::ceil(share * report.iterations));
  if (!report.converged)
    return result;
  result.unknowns = unknowns;
  (*result.unknowns)(entries) = forces;
  return result;
}
} // namespace orthocone
