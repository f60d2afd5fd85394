// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/step_solver.h>

#include "release.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/node_compliance.h>
#include <orthocone/march/coarser_march.h>
#include <orthocone/march/driven_work.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// The target at a share of the way from a state.
FaceTarget on_the_way(const FaceState &from, const FaceTarget &target, const double share)
{
  FaceTarget middle = target;
  middle.motion.components = (1 - share) * from.motion.components + share * target.motion.components;
  middle.force.components = (1 - share) * from.wrench.components + share * target.force.components;
  if (target.loads.size() > 0)
    middle.loads = (1 - share) * from.loads + share * target.loads;
  return middle;
}

/// Adds the report on an earlier part of the step to the report on the part behind it.
void add_earlier(SolverReport &report, const SolverReport &earlier)
{
  report.iterations += earlier.iterations;
  report.n_parts += earlier.n_parts;
  report.law.merge(earlier.law);
  report.residual = std::max(report.residual, earlier.residual);
  report.penetration = std::max(report.penetration, earlier.penetration);
}

std::shared_ptr<const SolvedProblem> solved(const ContactStep &problem, const VectorXd &unknowns)
{
  return std::make_shared<const SolvedProblem>(SolvedProblem{problem, unknowns});
}
} // namespace

StepSolver::StepSolver(const Scene &scene)
    : StepSolver(scene, scene.parameters().contact_solver)
{
}

StepSolver::StepSolver(const Scene &scene, const ContactSolverOptions &options)
    : scene_(scene),
      opening_(node_compliance(scene.surface(), scene.symmetry(), scene.contact_material())),
      wear_(scene.parameters().wear, scene.pressed_areas()),
      implicit_wear_(wear_, options, opening_),
      friction_(scene),
      tolerance_(options.tolerance),
      solver_(make_contact_solver(scene.system(), options)),
      coarser_(CoarserMarch::of(scene))
{
}

StepSolver::StepSolver(StepSolver &&other) noexcept = default;
StepSolver::~StepSolver() = default;

/// Scene::free_displacement() plus the room that wear has made before the step.
NodeVector StepSolver::free_displacement_with_wear(const ContactState &state, const FaceTarget &target) const
{
  NodeVector displacement = scene_.free_displacement(target);
  for (Index node = 0; node < state.n_nodes(); ++node)
    displacement[3 * node] += state.wear_depth[node];
  return displacement;
}

StepSolver::Attempt StepSolver::attempt(const ContactState &state, const FaceTarget &target) const
{
  ContactStep problem(scene_.system(),
                      step_displacement(free_displacement_with_wear(state, target), state.displacement),
                      scene_.free_face(target));
  if (friction_.is_there())
    problem = problem.with_factors(state.friction_factor);
  return {target, std::move(problem), scene_.free_components(target), {}};
}

SolverReport StepSolver::solve(ContactState &state, const LoadStep &step)
{
  before_parts_.reset();
  v_cycles_before_ = scene_.body().n_v_cycles();
  if (step.parts.empty())
    return solve_in_one(state, step);
  const ContactState before = state;
  before_parts_ = memory();
  SolverReport report;
  for (const LoadStep &part : step.parts)
  {
    const ContactState here = state;
    SolverReport of_part = solve_in_one(state, part);
    if (&part != &step.parts.front())
      add_earlier(of_part, report);
    report = std::move(of_part);
    if (!report.converged)
    {
      state = before;
      reject();
      break;
    }
    accept_undivided(here, state, part);
  }
  return report;
}

SolverReport StepSolver::solve_in_one(ContactState &state, const LoadStep &step)
{
  constexpr unsigned int most_halvings = 3;
  const ContactState before = state;
  state.leg_begin = leg_begin(state, step);
  state.friction_factor = friction_.factors(state, step.cycle);
  const ContactState begin = state;
  const Attempt whole = attempt(state, step.target(state.leg_begin));
  const bool is_release = presses_nothing(whole.problem.face(), whole.components) && opens_along_z(scene_);
  SolverReport report = is_release ? release(state, whole)
                                   : solve_to(state, whole, start_of(whole, before, step), most_halvings);
  if (!report.converged && report.verdict != Verdict::unbalanced && !is_release)
  {
    state = begin;
    report = solve_from_no_force(state, whole, report);
  }
  if (report.converged)
    state.step = step.number;
  else
    state = before;
  if (report.converged)
    state.slip_speed = friction_.speeds(before, state, step.seconds);
  unsolved_ = report.converged ? std::nullopt : std::optional<ContactStep>(whole.problem);
  return report;
}

/// Where friction lets a step have several solutions, none may be near the state before.
SolverReport StepSolver::solve_from_no_force(ContactState &state, const Attempt &attempt,
                                             const SolverReport &failure) const
{
  VectorXd unknowns = VectorXd::Zero(attempt.problem.n_unknowns());
  SolverReport report = solve_to(state, attempt, unknowns, 0);
  report.iterations += failure.iterations;
  if (report.converged)
    return report;
  auto rescued = solver_->rescue(attempt.problem, unknowns);
  if (!rescued)
    return failure;
  rescued->iterations += report.iterations;
  if (!rescued->converged)
    return *std::move(rescued);
  return accepted(state, attempt, unknowns, *std::move(rescued));
}

/// The best start from the past, or the change of the step on a coarser mesh where that start is far off.
VectorXd StepSolver::start_of(const Attempt &attempt, const ContactState &state, const LoadStep &step)
{
  constexpr double good = 1e-3; // what a coarser mesh finds is hardly better
  remember_last_cycle(step);
  VectorXd start = starts_.best(attempt.problem, attempt.components, state, step, tolerance_);
  if (coarser_ == nullptr)
    return start;
  const auto change = coarser_->solve(step);
  if (!change || attempt.problem.approximate_residual(start) <= good)
    return start;
  const ElasticBody &body = scene_.body();
  ContactState moved = state;
  if (body.mesh().has_mesh())
  {
    const ContactChange held = scene_.compliance().held_at(body.elastic_displacement(state.force) +
                                                           body.prolonged(change->displacement));
    body.compliance().memory().remember(held.force, held.body);
    moved.force = held.force;
  }
  else
    moved.force += body.prolonged_forces(change->force);
  moved.motion.components += change->motion.components;
  moved.loads += change->loads;
  return attempt.unknowns_of(moved);
}

FaceState StepSolver::leg_begin(const ContactState &before, const LoadStep &step) const
{
  return step.step_of_leg == 1 ? scene_.face_state(before.force, before.motion, before.loads)
                               : before.leg_begin;
}

double StepSolver::carried_share(const ContactState &before, const LoadStep &step) const
{
  // Bisected by hand: Boost's bisection would solve both ends again, whose outcomes are known.
  constexpr double fine = 0.01; // of the leg
  const FaceState now = scene_.face_state(before.force, before.motion, before.loads);
  const FaceTarget end = step.target(leg_begin(before, step));
  const double first = step.share * (step.step_of_leg - 1) / step.step_of_leg;
  double carried = first, lost = step.share;
  while (lost - carried > fine)
  {
    const double share = 0.5 * (carried + lost);
    ContactState state = before;
    state.friction_factor = friction_.factors(before, step.cycle);
    const Attempt attempt =
        this->attempt(state, on_the_way(now, end, (share - first) / (step.share - first)));
    (solve_to(state, attempt, attempt.unknowns_of(state), 0).converged ? carried : lost) = share;
  }
  return carried;
}

void StepSolver::accept_unknowns(ContactState &state, const Attempt &attempt, const VectorXd &unknowns) const
{
  const FreeFace &face = attempt.problem.face();
  const VectorXd motions = face.motions(unknowns.tail(face.n()));
  RigidMotion motion = attempt.target.motion;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    if (attempt.target.by_force[i])
      motion[i] = state.motion[i]; // zero where symmetry holds the component
  VectorXd loads = attempt.target.loads;
  for (std::size_t j = 0; j < attempt.components.size(); ++j)
    if (const unsigned int i = attempt.components[j]; i < n_rigid_components)
      motion[i] = motions[static_cast<Index>(j)];
    else
      loads[i - n_rigid_components] = motions[static_cast<Index>(j)];
  const ContactState before = state;
  advance(state, attempt.problem, opening_, unknowns, motion, attempt.worn.size() == 0 ? wear_ : WearLaw(),
          tolerance_);
  if (attempt.worn.size() > 0) // it is found already
  {
    state.wear_depth += attempt.worn;
    state.found_depth = state.wear_depth;
  }
  state.loads = loads;
  state.work += driven_work(scene_, before, state) +
                scene_.symmetry().n_copies() * work_without_contact(before, state, opening_);
}

SolverReport StepSolver::solve_to(ContactState &state, const Attempt &attempt, VectorXd unknowns,
                                  const unsigned int n_halvings) const
{
  SolverReport report = solver_->solve(attempt.problem, unknowns);
  if (report.converged)
    return accepted(state, attempt, unknowns, std::move(report));
  const bool has_equilibrium = report.verdict != Verdict::unbalanced;
  return n_halvings > 0 && has_equilibrium ? solve_halves(state, attempt.target, report, n_halvings - 1)
                                           : report;
}

/// Takes the solution of an attempt, which its report belongs to, as the state.
SolverReport StepSolver::accepted(ContactState &state, const Attempt &attempt, const VectorXd &unknowns,
                                  SolverReport report) const
{
  const ContactState before = state;
  accept_unknowns(state, attempt, unknowns);
  report.last_part = solved(attempt.problem, unknowns);
  if (implicit_wear_.is_for(before, state))
    wear_implicitly(before, state, attempt, unknowns, report);
  return report;
}

/// Solves a step again that has worn deeper than pressure flattens, with the depth as an unknown. How far
/// nodes slide depends on the depth in partial slip, so that both are found by turns. Where they do not
/// settle, the step stays the explicit one that it was, and its check says so.
void StepSolver::wear_implicitly(const ContactState &before, ContactState &state, const Attempt &attempt,
                                 VectorXd unknowns, SolverReport &report) const
{
  constexpr unsigned int most_turns = 10;
  constexpr double settled = 1e-4; // of the largest depth
  Attempt worn = attempt;
  ContactState found = state;
  SolverReport of_found = report;
  for (unsigned int turn = 0; turn < most_turns; ++turn)
  {
    const VectorXd depths = implicit_wear_.depths(attempt.problem, before, found, unknowns);
    if (depths.size() == 0)
      return;
    if (turn > 0 && (depths - worn.worn).lpNorm<Eigen::Infinity>() <= settled * depths.maxCoeff())
    {
      state = std::move(found);
      report = std::move(of_found);
      return;
    }
    worn.problem = with_depths(attempt.problem, depths);
    worn.worn = depths;
    VectorXd solution = unknowns;
    SolverReport again = solver_->solve(worn.problem, solution);
    again.iterations += of_found.iterations;
    if (!again.converged)
      return;
    found = before;
    accept_unknowns(found, worn, solution);
    of_found = std::move(again);
    of_found.last_part = solved(worn.problem, solution);
  }
}

SolverReport StepSolver::solve_halves(ContactState &state, const FaceTarget &target,
                                      const SolverReport &failure, const unsigned int n_halvings) const
{
  const Attempt half =
      attempt(state, on_the_way(scene_.face_state(state.force, state.motion, state.loads), target, 0.5));
  const SolverReport first = solve_to(state, half, half.unknowns_of(state), n_halvings);
  SolverReport report = first;
  if (first.converged)
  {
    const Attempt rest = attempt(state, target);
    report = solve_to(state, rest, rest.unknowns_of(state), n_halvings);
  }
  if (first.converged)
    add_earlier(report, first);
  report.iterations += failure.iterations;
  return report;
}

/// Nothing presses, so that there are no contact forces. This leaves the motion undetermined; taken is the
/// first one on the way at which the forces vanish (docs/theory.md, section 3).
SolverReport StepSolver::release(ContactState &state, const Attempt &attempt) const
{
  constexpr unsigned int normal = 2;
  FaceTarget open{{}, attempt.target.motion, {}, attempt.target.loads};
  for (const unsigned int component : attempt.components)
    if (component < n_rigid_components)
      open.motion[component] = component == normal ? 0 : state.motion[component];
  open.motion[normal] = opening_motion(free_displacement_with_wear(state, open), scene_.axes());
  const Attempt apart = this->attempt(state, open);
  const VectorXd none = VectorXd::Zero(apart.problem.n_unknowns());
  SolverReport report = make_report(apart.problem, none, 0, tolerance_);
  report.is_released = true;
  if (report.converged)
  {
    accept_unknowns(state, apart, none);
    report.last_part = solved(apart.problem, none);
  }
  return report;
}

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
  elastic.compliance().memory().remember(held.force, held.body);
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
  starts_.keep(scene_.system().compliance().memory().forget_trials(state.force), std::move(coarser));
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
  scene_.system().compliance().memory().restore(memory.bodies);
  if (coarser_ != nullptr && !memory.coarser.empty())
    coarser_->restore(memory.coarser.front());
}
} // namespace orthocone
