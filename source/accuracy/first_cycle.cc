// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/first_cycle.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/threads.h>
#include <orthocone/results/totals.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
namespace
{
/// Number of the first step in which the top is lowest.
unsigned int peak(const LoadSteps &steps)
{
  const std::vector<LoadStep> &different = steps.different();
  return std::min_element(different.begin(), different.end(),
                          [](const LoadStep &a, const LoadStep &b)
                          { return a.motion[2] + a.force[2] < b.motion[2] + b.force[2]; })
      ->number;
}

/// Measures the quantities on the way.
class QuantityWatch : public MarchObserver
{
public:
  QuantityWatch(const Scene &scene, const unsigned int peak_step, MarchObserver &also)
      : evaluator_(scene),
        peak_step_(peak_step),
        also_(also)
  {
  }

  bool accepts(const MarchedStep &solved) override
  {
    if (solved.step.cycle == 1 && solved.step.phase == 0)
      work_before_ = solved.before.work;
    is_in_cycle_ = solved.step.cycle > 0;
    return also_.accepts(solved);
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
    if (is_in_cycle_)
      values_[loop_area_index] = state.work - work_before_;
    motion_ = std::max(motion_, std::abs(state.motion[2]));
    also_.accepted(state);
  }

  FirstCycle measured() const { return {values_, motion_}; }

private:
  const ContactFieldEvaluator evaluator_;
  unsigned int peak_step_;
  MarchObserver &also_;
  bool is_in_cycle_ = false;
  double work_before_ = 0; ///< work before the cycle, N mm
  Quantities values_{};
  double motion_ = 0; ///< largest of the top along z, mm
};
} // namespace

LoadOptions first_cycle(LoadOptions load)
{
  load.cycles = std::min(1U, load.cycles);
  return load;
}

FirstCycle march_first_cycle(const Scene &scene, const LoadOptions &load, StepSolver &solver,
                             const char *const entry, MarchObserver &also)
{
  const LoadSteps steps = LoadProgram(first_cycle(load)).steps();
  QuantityWatch watch(scene, peak(steps), also);
  ContactState state(scene.gaps(), scene.n_loads());
  const BlasThreads threads(state.force.size());
  const auto unsolved = [&](const std::string &why)
  {
    return std::runtime_error(std::string(entry) + ": load step " + std::to_string(state.step + 1) +
                              " is not solved on a mesh of " + std::to_string(scene.surface().nodes.size()) +
                              " contact nodes" + why + "; " + entry + " = 0 runs without this search");
  };
  try
  {
    if (march(steps, solver, state, watch) == MarchEnd::unsolved)
      throw unsolved("");
  }
  catch (const SolveError &error)
  {
    throw unsolved(std::string(": ") + error.what());
  }
  return watch.measured();
}

FirstCycle march_first_cycle(const Scene &scene, const LoadOptions &load, StepSolver &solver,
                             const char *const entry)
{
  MarchObserver nobody;
  return march_first_cycle(scene, load, solver, entry, nobody);
}

double contact_area(const Scene &scene)
{
  double area = 0;
  for (const ContactNode &node : scene.surface().nodes)
    area += node.area;
  return scene.symmetry().n_copies() * area;
}
} // namespace orthocone
