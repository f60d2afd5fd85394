// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "hardest_nodes.h"

#include "few_nodes.h"

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

/// A block of W, from its lower half.
Matrix3d block(const DenseView &w, const Index i, const Index j)
{
  if (i >= j)
    return w.block<3, 3>(3 * i, 3 * j);
  return w.block<3, 3>(3 * j, 3 * i).transpose();
}

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

MatrixXd compliance_of(const Nodes &nodes, const DenseView &w)
{
  const auto n = static_cast<Index>(nodes.size());
  MatrixXd result(3 * n, 3 * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      result.block<3, 3>(3 * i, 3 * j) = block(w, nodes[i], nodes[j]);
  return result;
}

} // namespace

HardestNodes::HardestNodes(const ContactSolverOptions &options, Make *const make)
    : options_(options),
      make_(make)
{
  constexpr unsigned int most_iterations = 200;
  options_.maximum_iterations = std::min(options.maximum_iterations, most_iterations);
}

HardestNodes::Result HardestNodes::solve(const ContactStep &step, const VectorXd &unknowns,
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
  const DenseCompliance compliance(compliance_of(nodes, *w));
  FrictionLaws laws;
  for (const Index node : nodes)
    laws.push_back(step.law(node));
  const ContactSystem system(compliance, std::move(laws));
  VectorXd forces = values_at(nodes, unknowns);
  const ContactStep problem(system, values_at(nodes, displacement) - *compliance.dense() * forces);
  const SolverReport report = make_(system, options_)->solve(problem, forces);
  Result result;
  const double share = static_cast<double>(nodes.size()) / static_cast<double>(step.n_nodes());
  result.iterations = static_cast<unsigned int>(std::ceil(share * report.iterations));
  if (!report.converged)
    return result;
  result.unknowns = unknowns;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result.unknowns->segment<3>(3 * nodes[i]) = forces.segment<3>(3 * static_cast<Index>(i));
  return result;
}
} // namespace orthocone
