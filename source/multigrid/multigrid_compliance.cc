// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "multigrid_compliance.h"

#include "node_values.h"

#include <orthocone/base/ranks.h>

#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

MultigridCompliance::MultigridCompliance(const ContactFrame &frame,
                                         const MatrixFreeStiffness<double> &stiffness, VCycle &cycle,
                                         VectorXd of_nodes, const double accuracy)
    : frame_(frame),
      stiffness_(stiffness),
      cycle_(cycle),
      of_nodes_(std::move(of_nodes)),
      accuracy_(accuracy),
      memory_(std::make_unique<Memory>(*this))
{
}

MultigridCompliance::Memory::Memory(const MultigridCompliance &compliance)
    : elastic(compliance.stiffness_, compliance.cycle_),
      compliance_(compliance)
{
}

void MultigridCompliance::Memory::remember(const NodeVector &force, const BodyPart &body)
{
  const ContactFrame &frame = compliance_.frame_;
  BodyVector<double> displacement = compliance_.stiffness_.make_vector(),
                     forces = compliance_.stiffness_.make_vector();
  entries(displacement, body.displacement.size()) = body.displacement;
  entries(forces, frame.n_free()) = frame.on_free_unknowns(force) - body.residual;
  elastic.remember(displacement, forces);
  last = {force, {}, compliance_.contact_displacement(displacement, force), body};
}

std::vector<VectorXd> MultigridCompliance::Memory::forget_trials(const NodeVector &force)
{
  last = {};
  return elastic.forget_trials(compliance_.on_body(force), compliance_.accuracy_);
}

void MultigridCompliance::Memory::restore(const std::vector<VectorXd> &accepted)
{
  last = {};
  elastic.restore(accepted);
}

BodyVector<double> MultigridCompliance::on_body(const NodeVector &force) const
{
  BodyVector<double> forces = stiffness_.make_vector();
  entries(forces, frame_.n_free()) = frame_.on_free_unknowns(force);
  return forces;
}

VectorXd MultigridCompliance::displacement(const VectorXd &forces) const
{
  BodyVector<double> on_body = stiffness_.make_vector();
  entries(on_body, forces.size()) = forces;
  const BodyVector<double> displacement = memory_->elastic.solve(on_body, accuracy_);
  return entries(displacement, forces.size());
}

VectorXd MultigridCompliance::body_displacement(const NodeVector &force) const
{
  const BodyVector<double> displacement = solution(force);
  return entries(displacement, frame_.n_free());
}

// A line search asks for displacements of forces that no one will ask for again. What known solutions make of
// them, with what the body lacks then, is enough to judge a step, and costs one product with K.
ContactChange MultigridCompliance::approximate(const NodeVector &force) const
{
  if (const ContactChange &last = memory_->last; force.size() == last.force.size() && force == last.force)
    return last;
  const ApproximateSolution approximate = memory_->elastic.approximate(on_body(force));
  ContactChange answer;
  answer.force = force;
  answer.displacement = contact_displacement(approximate.displacement, force);
  answer.body = {entries(approximate.displacement, frame_.n_free()),
                 entries(approximate.residual, frame_.n_free())};
  return answer;
}

// K u, and no solution: the contact forces are what the given displacement asks of its contact nodes, and
// what K u has elsewhere is what the body lacks of its equilibrium.
ContactChange MultigridCompliance::held_at(const VectorXd &displacement) const
{
  BodyVector<double> all = stiffness_.make_vector(), forces = stiffness_.make_vector();
  entries(all, displacement.size()) = displacement;
  stiffness_.vmult(forces, all);
  return contact_change(frame_, all, forces, {});
}

NodeVector MultigridCompliance::contact_displacement(const BodyVector<double> &body,
                                                     const NodeVector &force) const
{
  NodeVector displacement = NodeVector::Zero(force.size());
  for (std::size_t i = 0; i < frame_.nodes().size(); ++i)
  {
    if (!frame_.nodes()[i].is_here())
      continue;
    const auto place = 3 * static_cast<Index>(i);
    const Vector3d pushed = frame_.global_in_local(i) * force.segment<3>(place);
    Vector3d moved;
    for (unsigned int d = 0; d < 3; ++d)
      moved[d] = frame_.nodes()[i].is_free[d] ? body.local_element(frame_.nodes()[i].dofs[d])
                                              : of_nodes_[static_cast<Index>(i)] * pushed[d];
    displacement.segment<3>(place) = frame_.global_in_local(i).transpose() * moved;
  }
  sum_over_ranks(displacement.data(), static_cast<std::size_t>(displacement.size()));
  return displacement;
}

// A product with W is a solution of the body: one sparse system, to the accuracy that the compliance has.
void MultigridCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = contact_displacement(solution(force), force);
}

Eigen::Matrix3d MultigridCompliance::diagonal_block(const Index node) const
{
  return of_nodes_[node] * Eigen::Matrix3d::Identity();
}

std::unique_ptr<ConditionSolver> MultigridCompliance::condition_solver(double) const
{
  return std::make_unique<WholeBodyConditions>(frame_, stiffness_, cycle_);
}

double MultigridCompliance::norm(const VectorXd &residual) const
{
  return std::sqrt(sum_over_ranks(residual.squaredNorm()));
}

/// The largest eigenvalue of W by Lanczos' method, with a V-cycle in place of each solution.
/// This is a scale that need not be accurate, and solutions are expensive: one V-cycle is close to a
/// solution.
double MultigridCompliance::softness() const
{
  constexpr double settled = 1e-2;
  cycle_.release();
  BodyVector<double> forces = stiffness_.make_vector(), displacement = stiffness_.make_vector();
  return largest_eigenvalue(n_nodes(), settled,
                            [&](const NodeVector &force)
                            {
                              entries(forces, frame_.n_free()) = frame_.on_free_unknowns(force);
                              cycle_.vmult(displacement, forces);
                              return contact_displacement(displacement, force);
                            });
}
} // namespace orthocone
