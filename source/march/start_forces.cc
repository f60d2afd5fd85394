// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/start_forces.h>

#include <orthocone/base/ranks.h>

#include <cmath>
#include <limits>

namespace orthocone
{
using Eigen::VectorXd;

NodeVector with_motion(const ContactState &state)
{
  NodeVector all(state.force.size() + n_rigid_components + state.loads.size());
  all << state.force, state.motion.components, state.loads;
  return all;
}

VectorXd unknowns_of(const NodeVector &all, const ContactStep &problem,
                     const std::vector<unsigned int> &components)
{
  const Eigen::Index n = 3 * problem.n_nodes();
  VectorXd motions(components.size());
  for (std::size_t j = 0; j < components.size(); ++j)
    motions[static_cast<Eigen::Index>(j)] = all[n + components[j]];
  VectorXd unknowns(problem.n_unknowns());
  unknowns << all.head(n), problem.face().unknowns(motions);
  return unknowns;
}

/// Whether a change of the unknowns of n nodes is rounding, of the normal and of the tangential force of each
/// node by itself, because a tiny friction has its own last digits.
bool is_rounding(const VectorXd &change, const VectorXd &unknowns, const Eigen::Index n)
{
  constexpr double last_digits = 8 * std::numeric_limits<double>::epsilon();
  for (Eigen::Index node = 0; node < n; ++node)
    if (std::abs(change[3 * node]) > last_digits * std::abs(unknowns[3 * node]) ||
        change.segment<2>(3 * node + 1).norm() > last_digits * unknowns.segment<2>(3 * node + 1).norm())
      return false;
  return true;
}

/// The most likely candidate comes first.
std::vector<StartForces::Candidate> StartForces::candidates_for(const ContactState &state,
                                                                const LoadStep &step) const
{
  const NodeVector present = with_motion(state);
  std::vector<Candidate> candidates;
  if (const auto last_cycle = memory_.of_phase.find(step.phase);
      step.cycle > 0 &&
      last_cycle != memory_.of_phase.end()) // in the first cycle they come from the search for a mesh
  {
    candidates.push_back({last_cycle->second, true});
    if (const auto drift = memory_.drift.find(step.phase); drift != memory_.drift.end())
      candidates.push_back({last_cycle->second + drift->second});
  }
  if (step.step_of_leg > 1 && memory_.change.size() > 0) // a coarser march may have missed the steps before
    candidates.push_back({present + memory_.change});
  candidates.push_back({present}); // full unloading
  candidates.back().all.head(state.force.size()).setZero();
  candidates.push_back({present});
  return candidates;
}

VectorXd StartForces::best(const ContactStep &problem, const std::vector<unsigned int> &components,
                           const ContactState &state, const LoadStep &step, const double tolerance) const
{
  const std::vector<Candidate> candidates = candidates_for(state, step);
  double least = std::numeric_limits<double>::infinity();
  VectorXd best;
  for (std::size_t i = 0; i < candidates.size() && least > tolerance; ++i)
  {
    VectorXd unknowns = unknowns_of(candidates[i].all, problem, components);
    const double residual =
        candidates[i].is_likely ? problem.residual(unknowns) : problem.approximate_residual(unknowns);
    if (residual < least || best.size() == 0)
    {
      least = residual;
      best = std::move(unknowns);
    }
  }
  if (least > tolerance)
    return best;
  // This is the solution then. Rounding moves a sum of forces out of the cone, which the residual does not
  // notice where friction is tiny. Forces that are inside but for their own last digits stay as they are, so
  // that a cycle that repeats itself has the same bits.
  VectorXd inside = problem.admissible(best);
  if (is_rounding(inside - best, best, problem.n_nodes()))
    return best;
  return problem.residual(inside) <= tolerance ? inside : best;
}

void StartForces::remember(const ContactState &before, const ContactState &after, const LoadStep &step)
{
  const NodeVector end = with_motion(after);
  memory_.change = end - with_motion(before);
  if (step.cycle == 0)
    return;
  const std::size_t bytes = end.size() * sizeof(double);
  if (2 * bytes * (memory_.of_phase.size() + 1) > StartMemory::most_bytes &&
      memory_.of_phase.count(step.phase) == 0)
    return;
  NodeVector &of_phase = memory_.of_phase[step.phase];
  if (of_phase.size() > 0)
    memory_.drift[step.phase] = end - of_phase;
  of_phase = end;
}

void StartForces::keep_body(const LoadStep &step, const bool is_dear)
{
  if (memory_.of_phase.count(step.phase) == 0 || memory_.bodies.empty())
    return;
  const Eigen::VectorXd &body = memory_.bodies.back();
  const double bytes = sum_over_ranks(static_cast<double>(body.size() * sizeof(double)));
  const auto most = static_cast<double>(StartMemory::most_body_bytes);
  const bool has_room = bytes * static_cast<double>(memory_.body_of_phase.size() + 1) <= most;
  if (memory_.body_of_phase.count(step.phase) > 0 || (is_dear && has_room))
    memory_.body_of_phase[step.phase] = body;
}

const VectorXd *StartForces::body_of(const LoadStep &step) const
{
  const auto found = memory_.body_of_phase.find(step.phase);
  return step.cycle > 0 && found != memory_.body_of_phase.end() ? &found->second : nullptr;
}
} // namespace orthocone
