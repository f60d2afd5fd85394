// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/step_search.h>

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/cost_model.h>
#include <orthocone/accuracy/first_cycle.h>
#include <orthocone/base/machine.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/computed_steps.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/load_program.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace orthocone
{
namespace
{
constexpr const char *entry = "Load program/Accuracy";
constexpr unsigned int most_parts = 64; // of a step: docs/accuracy.md, "A number: `Load program/Accuracy`"

/// A mesh on which load steps cause the same errors as on the run's mesh, and which costs less if possible:
/// these errors depend on the path, not on the singular edges. A gap needs cells that resolve the contact.
MeshOptions search_mesh(const Parameters &parameters, const ModelChoice &choice)
{
  const GeometryOptions &geometry = parameters.geometry;
  const bool is_axisymmetric = choice.symmetry.is_axisymmetric();
  const bool is_plain = parameters.obstacle.is_plane() && !parameters.friction.varies();
  Parameters plain = parameters; // without the entries that only a single mesh has
  plain.mesh.quadrature_points = plain.mesh.refinements = plain.mesh.adaptive = 0;
  plain.mesh.refined_cells.clear();
  plain.mesh.backend = BodyBackend::automatic;
  const MeshOptions ladder = ladder_mesh(plain, is_axisymmetric, is_plain ? 1 : 3);
  if (parameters.mesh.accuracy != 0)
    return ladder;
  Parameters given = parameters, coarser = parameters;
  given.mesh = resolved_mesh(parameters, is_axisymmetric);
  coarser.mesh = ladder;
  const auto dofs = [&](const Parameters &of) { return model_size(of, choice.symmetry).dofs; };
  const bool is_adaptive = given.mesh.adaptive != 0;
  if (kind_of(geometry).chooser_of_mesh().empty() && is_plain && (is_adaptive || dofs(coarser) < dofs(given)))
    return ladder;
  given.mesh.adaptive = 0;
  if (!given.mesh.refined_cells.empty())
    given.mesh.refined_cells.pop_back();
  else if (!is_adaptive)
    given.mesh.refinements -= std::min(1U, given.mesh.refinements);
  return given.mesh;
}

/// The legs of a program, beginning with the preload.
std::vector<Leg *> legs_of(LoadOptions &load)
{
  std::vector<Leg *> legs;
  for (Leg &leg : load.preload)
    legs.push_back(&leg);
  for (Leg &leg : load.legs)
    legs.push_back(&leg);
  return legs;
}

/// The known errors of a leg.
struct LegError
{
  Quantities change{};        ///< what halving its parts changes
  Quantities change_before{}; ///< what halving them before changed
  bool was_halved = true;     ///< in the round before; nothing is known in the first one
  Quantities error{};         ///< of the parts as they are, percent

  double largest() const { return *std::max_element(error.begin(), error.end()); }
};

class StepSearch
{
public:
  StepSearch(const Parameters &parameters, const ModelChoice &choice, const double wanted)
      : scene_(parameters, choice),
        load_(first_cycle(parameters.load)),
        n_cycles_(parameters.load.cycles),
        errors_(legs_of(load_).size()),
        area_(contact_area(scene_))
  {
    estimate_.wanted = wanted;
  }

  /// Estimates the errors of the parts as they are.
  void measure()
  {
    const FirstCycle cycle = march(load_, scene_.parameters().contact_solver);
    estimate_.values = cycle.quantities;
    motion_ = cycle.motion;
    estimate_.errors = {};
    for (std::size_t i = 0; i < errors_.size(); ++i)
    {
      if (errors_[i].was_halved || errors_[i].largest() > negligible * estimate_.wanted)
        measure_leg(i);
      for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
        estimate_.errors[quantity] += errors_[i].error[quantity];
    }
  }

  /// Halves the parts of the legs with the largest errors in quantities that are not reached. Returns whether
  /// there is such a leg.
  bool divide()
  {
    bool has_divided = false;
    const std::vector<Leg *> legs = legs_of(load_);
    for (std::size_t i = 0; i < errors_.size(); ++i)
    {
      errors_[i].was_halved = is_to_halve(errors_[i]) && may_halve(i);
      if (errors_[i].was_halved)
        legs[i]->parts *= 2;
      has_divided = has_divided || errors_[i].was_halved;
    }
    return has_divided;
  }

  /// Changes by ten times the tolerance, percent.
  Quantities solver_errors() const
  {
    constexpr double looser = 10, most = 0.1;
    ContactSolverOptions options = scene_.parameters().contact_solver;
    options.tolerance = std::max(options.tolerance, std::min(most, looser * options.tolerance));
    return relative_errors(changes(march(load_, options).quantities), estimate_.values, area_, motion_);
  }

  const AccuracyEstimate &estimate() const { return estimate_; }
  const LoadOptions &load() const { return load_; }
  std::size_t n_nodes() const { return scene_.surface().nodes.size(); }

private:
  static constexpr double negligible = 0.05; ///< share of what is wanted

  FirstCycle march(const LoadOptions &load, const ContactSolverOptions &options) const
  {
    StepSolver solver(scene_, options);
    return march_first_cycle(scene_, load, solver, entry);
  }

  Quantities changes(const Quantities &values) const
  {
    Quantities change{};
    for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
      change[quantity] = std::abs(values[quantity] - estimate_.values[quantity]);
    return change;
  }

  void measure_leg(const std::size_t i)
  {
    LegError &leg = errors_[i];
    LoadOptions halved = load_;
    legs_of(halved)[i]->parts *= 2;
    leg.change_before = leg.change;
    leg.change = changes(march(halved, scene_.parameters().contact_solver).quantities);
    Quantities error{};
    for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
      error[quantity] =
          first_order_error(leg.change[quantity], leg.was_halved ? leg.change_before[quantity] : 0);
    leg.error = relative_errors(error, estimate_.values, area_, motion_);
  }

  /// Whether the program with all its cycles stays within the limits of a parameter file.
  bool may_halve(const std::size_t i) const
  {
    LoadOptions halved = load_;
    halved.cycles = n_cycles_;
    Leg &leg = *legs_of(halved)[i];
    leg.parts *= 2;
    return leg.parts <= most_parts &&
           least_computed_parts(halved, scene_.parameters().wear) <= most_solved_parts &&
           LoadProgram(halved).n_solved_parts() <= most_counted_parts;
  }

  bool is_to_halve(const LegError &leg) const
  {
    constexpr double large = 0.5; // relative to the leg with the largest error
    for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
    {
      double most = 0;
      for (const LegError &other : errors_)
        most = std::max(most, other.error[quantity]);
      if (estimate_.errors[quantity] > estimate_.wanted && leg.error[quantity] >= large * most)
        return true;
    }
    return false;
  }

  const Scene scene_;
  LoadOptions load_;
  const unsigned int n_cycles_; ///< of the whole program
  std::vector<LegError> errors_;
  const double area_;
  double motion_ = 0; ///< largest of the top along z, mm
  AccuracyEstimate estimate_{};
};

std::string line_of(const StepSearch &search)
{
  std::string parts;
  LoadOptions load = search.load();
  for (const Leg *leg : legs_of(load))
    parts += (parts.empty() ? "" : ", ") + std::to_string(leg->parts);
  return "accuracy       steps in " + parts + " parts, " + std::to_string(search.n_nodes()) +
         " contact nodes: " + describe_quantities(search.estimate());
}
} // namespace

DividedSteps find_steps(const Parameters &parameters, const ModelChoice &choice, const double wanted,
                        const Reporter &report)
{
  Parameters searched = parameters;
  searched.mesh = search_mesh(parameters, choice);
  searched.mesh.backend = choose_backend(searched, choice.symmetry, memory_limit().gigabytes).backend;
  StepSearch search(searched, choice, wanted);
  do
  {
    search.measure();
    report(line_of(search));
  } while (!search.estimate().is_reached() && search.divide());
  DividedSteps divided{search.load(), {search.estimate(), search.solver_errors()}};
  divided.load.cycles = parameters.load.cycles;
  divided.load.accuracy = 0;
  report("accuracy       of the steps " + describe(divided.accuracy.estimate));
  return divided;
}
} // namespace orthocone
