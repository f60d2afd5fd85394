// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/mesh_search.h>

#include <orthocone/accuracy/adaptive_mesh.h>
#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/cost_model.h>
#include <orthocone/accuracy/first_cycle.h>
#include <orthocone/base/machine.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/options.h>

#include <algorithm>

namespace orthocone
{
namespace
{
std::string line_of(const unsigned int level, const Scene &scene, const std::string &quantities)
{
  return "accuracy       level " + std::to_string(level) + ", " +
         std::to_string(scene.surface().nodes.size()) + " contact nodes: " + quantities;
}

/// Whether the mesh has reached its share of the accuracy.
bool is_fine_enough(AccuracyEstimate accuracy, const double most_steps_share)
{
  for (double &steps_share : accuracy.steps_share)
    steps_share = std::min(steps_share, most_steps_share);
  return accuracy.is_reached();
}

/// The meshes of a search. A ladder of graded meshes comes first, since gradings towards the edge take most
/// of the error away at once; then cells are halved where the solution asks for it, which no grading knows
/// beforehand. Each mesh is finer than the one before: levels of the ladder. For a solid, levels from 2
/// on are level 1 with rounds of refinement of single cells.
class MeshLevels
{
public:
  MeshLevels(const Parameters &parameters, const ModelChoice &choice, const double gigabytes)
      : given_(parameters),
        choice_(choice),
        gigabytes_(gigabytes)
  {
  }

  unsigned int n_levels() const
  {
    constexpr unsigned int most_rounds = 4;
    return is_axisymmetric() ? n_ladder_levels(true) : n_graded + most_rounds;
  }

  /// `to_halve` are the cells that the solution on the mesh before asked for.
  Parameters finer(const unsigned int level, const std::vector<CellRange> &to_halve)
  {
    Parameters finer = given_;
    if (is_axisymmetric() || level < n_graded)
      finer.mesh = ladder_mesh(given_, is_axisymmetric(), level);
    else
    {
      finer.mesh = before_;
      finer.mesh.refined_cells.push_back(to_halve);
    }
    before_ = finer.mesh;
    of_latest_ = choose_backend(finer, choice_.symmetry, gigabytes_);
    finer.mesh.backend = of_latest_.backend;
    return finer;
  }

  /// Why the latest mesh has its backend; empty where nothing was compared.
  const std::string &reason() const { return of_latest_.reason; }

private:
  static constexpr unsigned int n_graded = 2;

  bool is_axisymmetric() const { return choice_.symmetry.is_axisymmetric(); }

  const Parameters &given_;
  const ModelChoice &choice_;
  const double gigabytes_;
  MeshOptions before_{};
  BackendChoice of_latest_{BodyBackend::automatic};
};

/// Solves the first cycle on the mesh of `finer`, keeps the model, and adds its quantities. Returns the cells
/// to halve.
std::vector<CellRange> solve_level(const Parameters &finer, const ModelChoice &choice,
                                   std::vector<Quantities> &levels, ChosenModel &found,
                                   AccuracyEstimate &accuracy)
{
  found.parameters = finer;
  found.scene = nullptr; // two at a time would need twice the memory
  found.scene = std::make_unique<Scene>(finer, choice);
  StepSolver solver(*found.scene);
  const auto watch = RefinementWatch::of(*found.scene);
  const FirstCycle cycle = march_first_cycle(*found.scene, finer.load, solver, "Mesh/Accuracy", *watch);
  levels.push_back(cycle.quantities);
  found.starts = solver.memory();
  accuracy.values = levels.back();
  accuracy.errors = estimated_errors(levels, contact_area(*found.scene), cycle.motion);
  return watch->cells_to_halve();
}
} // namespace

ChosenModel find_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                      const double gigabytes, const Quantities &steps_share, const double most_steps_share)
{
  constexpr std::size_t least_levels = 3;
  const Stopwatch watch;
  ChosenModel found{parameters, parameters};
  AccuracyEstimate accuracy{parameters.mesh.accuracy, {}, {}, steps_share, parameters.mesh.accuracy_of};
  std::vector<Quantities> levels;
  std::vector<CellRange> to_halve;
  std::string reason;
  MeshLevels meshes(parameters, choice, gigabytes);
  for (unsigned int level = 0; level < meshes.n_levels(); ++level)
  {
    const Parameters finer = meshes.finer(level, to_halve);
    if (level > 0 && is_too_large(finer, choice.symmetry, gigabytes))
    {
      report("accuracy       level " + std::to_string(level) +
             " would need more memory than this machine has");
      break;
    }
    reason = meshes.reason();
    to_halve = solve_level(finer, choice, levels, found, accuracy);
    report(line_of(level, *found.scene, describe_quantities(accuracy)));
    if (levels.size() >= least_levels && is_fine_enough(accuracy, most_steps_share))
      break;
  }
  found.accuracy = accuracy;
  found.search_seconds = watch.seconds();
  if (!reason.empty())
    report(reason);
  report("accuracy       " + describe(accuracy));
  return found;
}

namespace
{
constexpr double share_of_steps = 0.3; ///< of the larger accuracy: docs/accuracy.md, "Load steps"

/// The part of an error of the steps that exceeds what the larger accuracy leaves beside the error of the
/// mesh.
double beyond(const double error, const double larger, const double of_mesh)
{
  return std::max(0., error - (larger - of_mesh));
}

/// The mesh that the parameters ask for. `steps` are errors of the steps, percent, and `larger` is the larger
/// one of both accuracies.
ChosenModel choose_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                        const Quantities &steps, const double larger)
{
  const double wanted = parameters.mesh.accuracy;
  const double gigabytes = of_first_rank(memory_limit().gigabytes); // all must find the same
  Quantities steps_share{};
  for (unsigned int i = 0; i < n_quantities; ++i)
    steps_share[i] = beyond(steps[i], larger, wanted);
  if (wanted != 0)
    return find_mesh(parameters, choice, report, gigabytes, steps_share,
                     beyond(share_of_steps * larger, larger, wanted));
  ChosenModel chosen{parameters, parameters};
  MeshOptions &mesh = chosen.parameters.mesh;
  mesh = resolved_mesh(parameters, choice.symmetry.is_axisymmetric());
  if (mesh.adaptive != 0)
  {
    const Stopwatch watch;
    mesh = adapted_mesh(chosen.parameters, choice, report, gigabytes);
    chosen.search_seconds = watch.seconds();
  }
  const BackendChoice backend = choose_backend(chosen.parameters, choice.symmetry, gigabytes);
  mesh.backend = backend.backend;
  if (!backend.reason.empty())
    report(backend.reason);
  return chosen;
}

/// Fixes the model where cells are named, because their numbers belong to one model.
ChosenModel with_model_of_cells(ChosenModel chosen, const ModelChoice &choice)
{
  MeshOptions &mesh = chosen.parameters.mesh;
  if (!mesh.refined_cells.empty())
    mesh.model = *from_word<ModelKind>(choice.symmetry.name());
  return chosen;
}
} // namespace

ChosenModel choose_mesh_and_steps(const Parameters &given, const ModelChoice &choice, const Reporter &report)
{
  if (given.load.accuracy == 0)
    return with_model_of_cells(choose_mesh(given, choice, report, {}, given.mesh.accuracy), choice);
  const Stopwatch watch;
  const double of_mesh = given.mesh.accuracy, of_steps = given.load.accuracy;
  const double larger = std::max(of_mesh, of_steps);
  const double wanted = of_mesh == 0 ? of_steps : std::min(of_steps, share_of_steps * larger);
  const DividedSteps steps = find_steps(given, choice, wanted, report);
  const double step_seconds = watch.seconds();
  Parameters divided = given;
  divided.load = steps.load;
  ChosenModel chosen = with_model_of_cells(
      choose_mesh(divided, choice, report, steps.accuracy.estimate.errors, larger), choice);
  chosen.given = given;
  chosen.steps = steps.accuracy;
  chosen.search_seconds += step_seconds;
  return chosen;
}
} // namespace orthocone
