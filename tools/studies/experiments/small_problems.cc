// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <orthocone/base/text.h>
#include <orthocone/contact/problem/critical_friction.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/scene/options.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;

/// Problems without a body: nodes that feel each other as strongly as themselves, in all directions alike,
/// with friction and slip ellipses that differ by factors of some units, pressed and pushed sideways.
class RandomProblems
{
public:
  explicit RandomProblems(const Index n_nodes)
      : n_(n_nodes)
  {
  }

  MatrixXd compliance()
  {
    constexpr double own = 0.9; // added to the diagonal, for each node
    const MatrixXd root = MatrixXd::NullaryExpr(3 * n_, 3 * n_, [this] { return normal_(random_); });
    return root * root.transpose() + own * static_cast<double>(n_) * MatrixXd::Identity(3 * n_, 3 * n_);
  }

  OrthotropicFriction law()
  {
    constexpr double mu = 0.2, spread = 0.7;
    const double size = mu * std::exp(spread * normal_(random_));
    const double ratio = std::exp(spread * normal_(random_));
    const double slip_ratio = std::exp(normal_(random_));
    return {size * ratio, size / ratio, slip_ratio, 1 / slip_ratio};
  }

  NodeVector free_displacement()
  {
    constexpr double sideways = 0.7;
    NodeVector free(3 * n_);
    for (Index node = 0; node < n_; ++node)
    {
      free[3 * node] = -uniform_(random_);
      free[3 * node + 1] = sideways * normal_(random_);
      free[3 * node + 2] = sideways * normal_(random_);
    }
    return free;
  }

private:
  Index n_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};
} // namespace

void small_problems(const Words &words)
{
  if (words.size() != 4)
    throw std::runtime_error("the words are METHOD NODES PROBLEMS MAXIMUM_ITERATIONS");
  const Index n_nodes = std::stoi(words[1]);
  ContactSolverOptions options;
  options.method = words[0];
  options.maximum_iterations = static_cast<unsigned int>(std::stoul(words[3]));
  RandomProblems problems(n_nodes);
  std::map<std::pair<bool, Verdict>, unsigned int>
      counts; // apart for friction above and below the critical one
  for (int i = 0; i < std::stoi(words[2]); ++i)
  {
    const DenseCompliance compliance(problems.compliance());
    const OrthotropicFriction law = problems.law();
    const ContactSystem system(compliance, FrictionLaws(n_nodes, law));
    const ContactStep problem(system,
                              step_displacement(problems.free_displacement(), NodeVector::Zero(3 * n_nodes)));
    NodeVector force = NodeVector::Zero(3 * n_nodes);
    const Verdict verdict = make_contact_solver(system, options)->solve(problem, force).verdict;
    ++counts[{critical_friction(system).factor > 1, verdict}];
  }
  std::cout << "friction,verdict,problems\n";
  for (const auto &[kind, count] : counts)
    std::cout << (kind.first ? "below" : "above") << "," << to_word(kind.second) << "," << count << "\n";
}
} // namespace orthocone::studies
