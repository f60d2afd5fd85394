// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "factorized_coarse.h"

#include <array>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// The equations of the forces with which contact reacts.
struct Answers
{
  std::vector<unsigned int> dofs;
  MatrixXd of_force;
  MatrixXd of_displacement;
};

std::vector<unsigned int> answering_dofs(const std::vector<ContactNode> &nodes,
                                         const std::vector<NodeRelation> &relations)
{
  std::vector<unsigned int> dofs;
  for (std::size_t i = 0; i < relations.size(); ++i)
    if (relations[i].hold != Hold::nothing)
      for (unsigned int d = 0; d < 3; ++d)
        if (nodes[i].is_free[d])
          dofs.push_back(nodes[i].dofs[d]);
  return dofs;
}

/// In held directions the displacement is zero, in units of force, so that all equations have one size. In
/// the others friction resists: f_t + coupling f_z + robin u_t = 0.
Answers answers_of(const std::vector<ContactNode> &nodes, const std::vector<NodeRelation> &relations,
                   const VectorXd &stiffness)
{
  Answers answers{answering_dofs(nodes, relations), {}, {}};
  const auto n = static_cast<Index>(answers.dofs.size());
  answers.of_force = answers.of_displacement = MatrixXd::Zero(n, n);
  Index next = 0;
  for (std::size_t i = 0; i < relations.size(); ++i)
  {
    if (relations[i].hold == Hold::nothing)
      continue;
    std::array<Index, 3> row{};
    for (unsigned int d = 0; d < 3; ++d)
      row[d] = nodes[i].is_free[d] ? next++ : -1;
    for (unsigned int d = 0; d < 3; ++d)
      if (row[d] >= 0 && relations[i].holds(d))
        answers.of_displacement(row[d], row[d]) = stiffness[row[d]];
      else if (row[d] >= 0)
      {
        answers.of_force(row[d], row[d]) = 1;
        answers.of_force(row[d], row[2]) = relations[i].coupling[d];
        for (unsigned int e = 0; e < 2; ++e)
          if (row[e] >= 0)
            answers.of_displacement(row[d], row[e]) = relations[i].robin(d, e);
      }
  }
  return answers;
}
} // namespace

FactorizedCoarse::FactorizedCoarse(const Discretization &space, const MaterialOptions &material)
    : space_(space),
      factor_(Stiffness(space, material).matrix(), space.n_interior()),
      compliance_(factor_.trailing_inverse())
{
}

void FactorizedCoarse::hold(const std::vector<NodeRelation> &relations)
{
  const auto &nodes = space_.contact_surface().nodes;
  answering_ = answering_dofs(nodes, relations);
  const auto n = static_cast<Index>(answering_.size());
  if (n == 0)
    return;
  MatrixXd compliance(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      compliance(i, j) =
          compliance_(answering_[i] - space_.n_interior(), answering_[j] - space_.n_interior());
  Answers answers = answers_of(nodes, relations, compliance.diagonal().cwiseInverse());
  of_displacement_ = std::move(answers.of_displacement);
  system_.compute(answers.of_force + of_displacement_ * compliance);
}

VectorXd FactorizedCoarse::solve(VectorXd forces) const
{
  const auto n = static_cast<Index>(answering_.size());
  if (n == 0)
    return factor_.solve(forces);
  // The displacement without the reaction of contact, then with it.
  const VectorXd free = factor_.solve(forces);
  VectorXd moved(n);
  for (Index i = 0; i < n; ++i)
    moved[i] = free[answering_[i]];
  const VectorXd answer = -system_.solve(of_displacement_ * moved);
  for (Index i = 0; i < n; ++i)
    forces[answering_[i]] += answer[i];
  return factor_.solve(forces);
}
} // namespace orthocone
