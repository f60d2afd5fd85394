// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Small scenes, marched without a run folder.
#pragma once

#include <orthocone/body/node_compliance.h>
#include <orthocone/march/march.h>
#include <orthocone/results/step_checks.h>
#include <orthocone/results/totals.h>
#include <orthocone/scene/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace orthocone::test
{
/// Slip ellipses of the paper's cases B and C, for the friction ellipse (0.3, 0.15).
const std::array<std::array<double, 2>, 2> slip_ellipses{{{{0.3, 0.15}}, {{0.05, 0.2}}}};

/// Parameters of a small cylinder under the paper's cycle with the friction of its case B.
inline Parameters small_scene(const unsigned int degree = 1)
{
  Parameters parameters;
  parameters.mesh.core_cells = 4;
  parameters.mesh.rings = 3;
  parameters.mesh.layers = 2;
  parameters.mesh.degree = degree;
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.1, 5), move_to(0, 0, 0, 10)};
  return parameters;
}

/// The same without symmetry.
inline Parameters full_scene(const unsigned int degree = 1)
{
  Parameters parameters = small_scene(degree);
  parameters.mesh.model = ModelKind::full;
  return parameters;
}

inline Parameters with_model(Parameters parameters, const ModelKind model)
{
  parameters.mesh.model = model;
  return parameters;
}

/// How far answers of the same scene in other words may be apart, relative: what the solver leaves,
/// amplified.
constexpr double closeness = 1e-8;

inline double largest_difference(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
{
  return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

/// A scene that can be marched step by step; `on_step` sees the state before, the state after and the step.
class TestScene
{
public:
  explicit TestScene(const Parameters &parameters_)
      : parameters(parameters_),
        scene(parameters, choose_model(parameters)),
        symmetry(scene.symmetry()),
        discretization(scene.body().unknowns()),
        condensed(scene.body()),
        evaluator(scene),
        shares(symmetry.force_shares(discretization.contact_surface())),
        opening(node_compliance(discretization.contact_surface(), symmetry, parameters.material)),
        state(scene.gaps(), scene.n_loads())
  {
  }

  using Watcher =
      std::function<void(const ContactState &before, const ContactState &after, const LoadStep &step)>;

  void march(const Watcher &on_step = {})
  {
    struct Caller : MarchObserver
    {
      bool accepts(const MarchedStep &solved) override
      {
        before = solved.before;
        step = solved.step;
        return true;
      }
      void accepted(ContactState &after) override
      {
        if (call)
          call(*before, after, *step);
      }
      void failed(const LoadStep &unsolved, const SolverReport &report, double) override
      {
        ADD_FAILURE() << "step " << unsolved.number << " residual " << report.residual;
      }
      Watcher call;
      std::optional<ContactState> before;
      std::optional<LoadStep> step;
    } caller;
    caller.call = on_step;
    StepSolver solver(scene);
    ASSERT_EQ(orthocone::march(LoadProgram(parameters.load).steps(), solver, state, caller), MarchEnd::done);
  }

  Totals totals() const { return compute_totals(evaluator, state); }

  const Parameters parameters;
  const Scene scene;
  const ModelSymmetry &symmetry;
  const BodyUnknowns &discretization;
  const ElasticBody &condensed;
  const ContactFieldEvaluator evaluator;
  const Eigen::VectorXd shares;
  const Eigen::VectorXd opening;
  ContactState state;
};

/// Marches a scene whose bodies must be in equilibrium after each step, and keep their energy in it.
inline void expect_checked_steps(TestScene &scene)
{
  StepChecker checker(scene.scene, scene.parameters.checks, 1e-10);
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        const StepChecks checks =
            checker.check({before, compute_totals(scene.evaluator, before)},
                          {after, compute_totals(scene.evaluator, after)}, SolverReport{}, 0);
        EXPECT_LE(checks.equilibrium, 1e-9);
        EXPECT_LE(checks.energy_identity, 1e-9);
      });
}

/// Node of the scene at a place, or -1.
inline int node_at(const TestScene &scene, const Eigen::Vector3d &place)
{
  const auto &nodes = scene.discretization.contact_surface().nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if ((nodes[i].place() - place).norm() < 1e-9)
      return static_cast<int>(i);
  return -1;
}

/// Forces and slips of all nodes of `part` equal those of `whole` at the same places, to `tolerance` relative
/// to the largest of them.
inline void expect_same_fields(const TestScene &part, const TestScene &whole, const double tolerance)
{
  const Totals largest = whole.totals();
  const double force = largest.force[2] / static_cast<double>(whole.state.n_nodes());
  const double slip = std::max(largest.max_accumulated_slip, 1e-12);
  const auto &nodes = part.discretization.contact_surface().nodes;
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    const int other = node_at(whole, nodes[i].place());
    ASSERT_GE(other, 0);
    const ContactFields a = part.evaluator.fields(part.state, i);
    const ContactFields b = whole.evaluator.fields(whole.state, other);
    EXPECT_LE((a.nodal_force - b.nodal_force).norm(), tolerance * force)
        << nodes[i].position[0] << " " << nodes[i].position[1];
    EXPECT_LE((a.slip - b.slip).norm(), tolerance * slip);
    EXPECT_LE(std::abs(a.pressure - b.pressure), tolerance * largest.max_pressure);
    EXPECT_LE(std::abs(a.accumulated_slip - b.accumulated_slip), tolerance * slip);
    EXPECT_LE(std::abs(a.dissipated_energy - b.dissipated_energy), tolerance * slip * largest.max_pressure);
    EXPECT_EQ(a.status, b.status);
  }
}
} // namespace orthocone::test
