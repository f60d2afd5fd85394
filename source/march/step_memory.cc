// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What StepSolver remembers of the steps that are accepted.
#include <orthocone/march/step_solver.h>

#include <orthocone/base/ranks.h>
#include <orthocone/march/coarser_march.h>

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

/// Forces of the last cycle are judged by the displacement that they cause: with the body of the last cycle
/// that takes no V-cycle.
void StepSolver::remember_last_cycle(const LoadStep &step)
{
  const VectorXd *const body = starts_.body_of(step);
  const ElasticBody &elastic = scene_.body();
  const auto n = static_cast<Index>(elastic.unknowns().n_free());
  if (body == nullptr || any_rank(body->size() < n)) // of another division of the body
    return;
  const ContactChange held = elastic.compliance().held_at(body->head(n)); // behind them are the held ones
  elastic.compliance().remember(held.force, held.body);
}

void StepSolver::accept(const ContactState &before, const ContactState &after, const LoadStep &step)
{
  if (step.parts.empty())
    accept_undivided(before, after, step);
}

void StepSolver::accept_undivided(const ContactState &before, const ContactState &after, const LoadStep &step)
{
  starts_.remember(before, after, step);
  if (coarser_ != nullptr)
    coarser_->accept(step);
  keep_bodies(after);
  const bool is_repeated = step.cycle > 0 && step.cycle < scene_.parameters().load.cycles;
  if (is_repeated && !after.force.isZero(0))
    starts_.keep_body(step, scene_.body().n_v_cycles() > v_cycles_before_);
}

void StepSolver::keep_bodies(const ContactState &state)
{
  std::vector<MarchMemory> coarser;
  if (coarser_ != nullptr)
    coarser.push_back(coarser_->memory());
  starts_.keep(scene_.system().compliance().forget_trials(state.force), std::move(coarser));
}

void StepSolver::remember_body(const ContactState &state)
{
  if (coarser_ != nullptr)
    coarser_->remember_body();
  keep_bodies(state);
}

void StepSolver::reject()
{
  if (before_parts_)
    restore(*before_parts_);
}

void StepSolver::restore(const StartMemory &memory)
{
  starts_.restore(memory);
  scene_.system().compliance().restore(memory.bodies);
  if (coarser_ != nullptr && !memory.coarser.empty())
    coarser_->restore(memory.coarser.front());
}
} // namespace orthocone
