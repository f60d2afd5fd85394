// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/mesh_search.h>

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/memory_need.h>
#include <orthocone/base/blas_threads.h>
#include <orthocone/base/memory.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/march/march.h>
#include <orthocone/results/totals.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
namespace
{
/// The steps up to the end of the first cycle.
std::vector<LoadStep> first_cycle(const LoadOptions &load)
{
  LoadOptions shortened = load;
  shortened.cycles = std::min(1U, load.cycles);
  return load_steps(shortened);
}

/// Number of the first step in which the top stands lowest.
unsigned int peak(const std::vector<LoadStep> &steps)
{
  return std::min_element(steps.begin(), steps.end(),
                          [](const LoadStep &a, const LoadStep &b)
                          { return a.motion[2] + a.force[2] < b.motion[2] + b.force[2]; })
      ->number;
}

std::string line_of(const unsigned int level, const Scene &scene, const std::string &quantities)
{
  return "accuracy       level " + std::to_string(level) + ", " +
         std::to_string(scene.surface().nodes.size()) + " contact nodes: " + quantities;
}

double area_of(const Scene &scene)
{
  double area = 0;
  for (const ContactNode &node : scene.surface().nodes)
    area += node.area;
  return scene.symmetry().n_copies() * area;
}

/// Errors of a slip or a dissipation that is next to nothing are related to a thousandth of the motion of the
/// top (mm) and of its work: where all sticks, digits of what slips at the rim are not worth any mesh.
Quantities unless_negligible(Quantities errors, const Quantities &values, const double motion)
{
  constexpr double negligible = 1e-3;
  const auto relate = [&](const unsigned int i, const double least)
  {
    const double share = std::min(1., std::abs(values[i]) / (negligible * least));
    errors[i] = share > 0 ? share * errors[i] : 0; // the error of a value of 0 is infinite
  };
  relate(0, motion);
  relate(2, values[1] * motion / 2);
  return errors;
}

/// Measures what the search is for on the way through the first cycle.
class QuantityWatch : public MarchObserver
{
public:
  QuantityWatch(const Scene &scene, const unsigned int peak_step)
      : evaluator_(scene),
        peak_step_(peak_step)
  {
  }

  void accepted(ContactState &state) override
  {
    const Totals totals = compute_totals(evaluator_, state);
    values_[0] = std::max(values_[0], totals.max_slip);
    if (state.step == peak_step_)
    {
      values_[1] = totals.force.norm();
      values_[stick_area_index] = totals.stick_area;
    }
    values_[2] = totals.total_dissipation;
  }

  const Quantities &values() const { return values_; }

private:
  const ContactFieldEvaluator evaluator_;
  unsigned int peak_step_;
  Quantities values_{};
};
} // namespace

Quantities march_first_cycle(const Scene &scene, StepSolver &solver)
{
  const std::vector<LoadStep> steps = first_cycle(scene.parameters().load);
  QuantityWatch watch(scene, peak(steps));
  ContactState state(scene.gaps());
  const BlasThreads threads(state.force.size());
  if (march(steps, solver, state, watch) == MarchEnd::unsolved)
    throw std::runtime_error("Mesh/Accuracy: load step " + std::to_string(state.step + 1) +
                             " is not solved on a mesh of " + std::to_string(scene.surface().nodes.size()) +
                             " contact nodes; Mesh/Resolution takes a mesh without a search");
  return watch.values();
}

ChosenMesh find_mesh(const Parameters &parameters, const ModelChoice &choice, const Teller &tell,
                     const double gigabytes)
{
  constexpr std::size_t least_levels = 3;
  const Stopwatch watch;
  ChosenMesh found{parameters.mesh, parameters.mesh};
  AccuracyEstimate accuracy{parameters.mesh.accuracy};
  std::vector<Quantities> levels;
  const bool is_axisymmetric = choice.symmetry.is_axisymmetric();
  for (unsigned int level = 0; level < n_ladder_levels(is_axisymmetric); ++level)
  {
    Parameters finer = parameters;
    finer.mesh = ladder_mesh(parameters.geometry, parameters.mesh, is_axisymmetric, level);
    if (level > 0 && is_too_large(finer, choice.symmetry, gigabytes))
    {
      tell("accuracy       level " + std::to_string(level) + " would need more memory than this machine has");
      break;
    }
    found.mesh = finer.mesh;
    found.scene = nullptr; // two at a time would need twice the memory
    found.scene = std::make_unique<Scene>(finer, choice);
    StepSolver solver(*found.scene);
    levels.push_back(march_first_cycle(*found.scene, solver));
    found.starts = solver.memory();
    accuracy.values = levels.back();
    accuracy.errors = unless_negligible(estimated_errors(levels, area_of(*found.scene)), levels.back(),
                                        largest_motion(parameters.load, 2));
    tell(line_of(level, *found.scene, describe_quantities(accuracy)));
    if (levels.size() >= least_levels && accuracy.is_reached())
      break;
  }
  found.accuracy = accuracy;
  found.search_seconds = watch.seconds();
  tell("accuracy       " + describe(accuracy));
  return found;
}

ChosenMesh choose_mesh(const Parameters &parameters, const ModelChoice &choice, const Teller &tell)
{
  if (parameters.mesh.accuracy != 0)
    return find_mesh(parameters, choice, tell, memory_limit().gigabytes);
  Parameters meshed = parameters;
  meshed.mesh = resolved_mesh(parameters.geometry, parameters.mesh, choice.symmetry.is_axisymmetric());
  const BackendChoice backend = choose_backend(meshed, choice.symmetry, memory_limit().gigabytes);
  meshed.mesh.backend = backend.backend;
  if (!backend.reason.empty())
    tell(backend.reason);
  return {parameters.mesh, meshed.mesh};
}
} // namespace orthocone
