// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scenes.h"

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector2d;

namespace
{
constexpr double tolerance = 1e-8;

const std::array<std::array<double, 2>, 2> slip_ellipses{{{{0.3, 0.15}}, {{0.05, 0.2}}}};

Parameters loaded_in(const unsigned int n_steps, const std::array<double, 2> &p)
{
  Parameters parameters = small_scene(1);
  parameters.friction.p = p;
  parameters.load.legs = {Leg{{{0, 0, -0.1}}, n_steps}};
  return parameters;
}

void expect_uniform_pressure(const Scene &scene)
{
  const Parameters &parameters = scene.parameters;
  const double pressure = parameters.material.young_modulus * 0.1 / parameters.geometry.height;
  for (const ContactFields &fields : scene.evaluator.all_fields(scene.state))
    EXPECT_NEAR(fields.pressure, pressure, 1e-6 * pressure);
}
} // namespace

TEST(Physics, PressureIsUniformWithoutFriction)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    Parameters parameters = small_scene(degree);
    parameters.mesh.rim_grading = 0.6;
    parameters.mesh.layer_grading = 0.7;
    parameters.load.legs = {Leg{{{0, 0, -0.1}}, 1}};
    parameters.friction.mu = parameters.friction.p = {{1e-9, 1e-9}};
    parameters.geometry.top_face = TopFace::guided;
    Scene guided(parameters);
    guided.march();
    expect_uniform_pressure(guided);
    parameters.geometry.top_face = TopFace::clamped;
    parameters.material.poisson_ratio = 0; // nothing wants to slip
    parameters.friction.mu = parameters.friction.p = {{0.3, 0.1}};
    Scene clamped(parameters);
    clamped.march();
    expect_uniform_pressure(clamped);
  }
}

// A body that sticks everywhere is the body clamped at its base: nothing moves there, and by uniqueness of
// the linear problem equilibrium of the interior (tested with the condensation) does the rest.
TEST(Physics, StickingEverywhereIsClampedAtTheBase)
{
  Parameters parameters = small_scene(2);
  parameters.friction.mu = parameters.friction.p = {{50, 30}};
  parameters.load.legs = {Leg{{{0.01, 0.02, -0.1}}, 2}};
  Scene scene(parameters);
  scene.march();
  EXPECT_EQ(scene.totals().n_stick, scene.state.n_nodes());
  const Eigen::VectorXd u = scene.condensed.volume_displacement(scene.state.top, scene.state.force);
  for (const ContactNode &node : scene.discretization.contact_surface().nodes)
    for (const unsigned int dof : node.dofs)
      EXPECT_NEAR(u[dof], 0, 1e-12);
}

TEST(Physics, MonotoneLoadingIsProportional)
{
  for (const auto &p : slip_ellipses)
  {
    Scene once(loaded_in(1, p));
    once.march();
    for (const unsigned int n_steps : {5, 50})
    {
      Scene often(loaded_in(n_steps, p));
      often.march();
      expect_same_fields(often, once, tolerance);
    }
  }
}

TEST(Physics, ScalesWithDisplacementAndModulus)
{
  constexpr double factor = 3;
  Parameters parameters = small_scene(1);
  parameters.load.legs = {Leg{{{0, 0, -0.1}}, 1}, Leg{{{0, 0, -0.06}}, 2}};
  Scene scene(parameters);
  scene.march();
  Parameters farther = parameters;
  for (Leg &leg : farther.load.legs)
    leg.target[2] *= factor;
  Scene pushed(farther);
  pushed.march();
  Parameters stiffer = parameters;
  stiffer.material.young_modulus *= factor;
  Scene stiff(stiffer);
  stiff.march();
  const double size = scene.state.force.norm();
  EXPECT_LE((pushed.state.force - factor * scene.state.force).norm(), tolerance * size);
  EXPECT_LE((stiff.state.force - factor * scene.state.force).norm(), tolerance * size);
  EXPECT_LE((pushed.state.displacement - factor * scene.state.displacement).norm(),
            tolerance * scene.state.displacement.norm());
  EXPECT_LE((stiff.state.displacement - scene.state.displacement).norm(),
            tolerance * scene.state.displacement.norm());
}

TEST(Physics, FrictionNeverDrives)
{
  for (const auto &p : slip_ellipses)
  {
    Parameters parameters = small_scene(1);
    parameters.friction.p = p;
    Scene scene(parameters);
    scene.march(
        [](const ContactState &before, const ContactState &after, const LoadStep &step)
        {
          for (Index i = 0; i < after.n_nodes(); ++i)
          {
            const Vector2d change =
                after.displacement.segment<2>(3 * i + 1) - before.displacement.segment<2>(3 * i + 1);
            EXPECT_LE(after.force.segment<2>(3 * i + 1).dot(change), 1e-9)
                << "step " << step.number << " node " << i;
          }
        });
  }
}

// Work of the top = change of elastic energy + dissipation. With trapezoidal sums this holds to rounding,
// except for the work of the normal forces at nodes that open or close within a step.
TEST(Physics, EnergyBalances)
{
  for (const auto &p : slip_ellipses)
  {
    Parameters parameters = small_scene(2);
    parameters.friction.p = p;
    parameters.load.legs = {Leg{{{0, 0, -0.1}}, 2}, Leg{{{0.004, 0.003, -0.08}}, 3}, Leg{{{0, 0, -0.03}}, 4}};
    Scene scene(parameters);
    Totals last;
    double work = 0;
    scene.march(
        [&](const ContactState &before, const ContactState &after, const LoadStep &)
        {
          const Totals now = scene.totals();
          ASSERT_EQ(now.n_open, 0u);
          for (unsigned int d = 0; d < 3; ++d)
            work -= 0.5 * (last.force[d] + now.force[d]) * (after.top[d] - before.top[d]);
          last = now;
          EXPECT_NEAR(work, now.elastic_energy + now.total_dissipation, 1e-9 * work);
          EXPECT_GT(now.total_dissipation, 0);
        });
  }
}

// Down and up again: everything is undone, and the area of the force-displacement loop is the dissipation up
// to the time integration's error, which falls with the number of steps.
TEST(Physics, FullUnloadingErasesTheHistory)
{
  for (const auto &p : slip_ellipses)
  {
    Parameters parameters = small_scene(1);
    parameters.friction.p = p;
    parameters.load.cycles = 2;
    Scene scene(parameters);
    std::vector<NodeVector> forces;
    double loop = 0;
    double last_force = 0;
    scene.march(
        [&](const ContactState &before, const ContactState &after, const LoadStep &)
        {
          forces.push_back(after.force);
          const double force = scene.totals().force[2];
          loop -= 0.5 * (last_force + force) * (after.top[2] - before.top[2]);
          last_force = force;
        });
    EXPECT_EQ(scene.totals().force.norm(), 0);
    EXPECT_LE(scene.totals().max_slip, 1e-14);
    EXPECT_NEAR(loop, scene.totals().total_dissipation, 1e-2 * loop);
    for (std::size_t i = 0; i < forces.size() / 2; ++i)
      EXPECT_LE((forces[i] - forces[i + forces.size() / 2]).norm(), tolerance * forces[4].norm());
  }
}

TEST(Physics, PartialUnloadingKeepsTheHistory)
{
  Parameters parameters = small_scene(1);
  parameters.load.preload = {Leg{{{0, 0, -0.02}}, 1}};
  parameters.load.legs = {Leg{{{0, 0, -0.1}}, 3}, Leg{{{0, 0, -0.02}}, 5}};
  Scene scene(parameters);
  Eigen::VectorXd preloaded;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &step)
      {
        if (step.number == 1)
          preloaded = after.displacement;
      });
  EXPECT_GT((scene.state.displacement - preloaded).norm(), 0.1 * preloaded.norm());
}

// The whole body in steady gross sliding: every node follows the top, and the resultant is the slip rule's.
TEST(Physics, GrossSlidingHasTheResultantOfTheSlipRule)
{
  for (const auto &p : std::vector<std::array<double, 2>>{{{0.8, 0.4}}, {{1, 1}}})
  {
    Parameters parameters = small_scene(1);
    parameters.friction.mu = {{0.8, 0.4}};
    parameters.friction.p = p;
    parameters.load.legs = {Leg{{{0, 0, -0.01}}, 1}, Leg{{{1, 1, -0.01}}, 20}};
    Scene scene(parameters);
    scene.march();
    const Eigen::Vector3d force = scene.totals().force;
    const Vector2d expected = sliding_traction(scene.law, std::sqrt(0.5), std::sqrt(0.5));
    EXPECT_EQ(scene.totals().n_stick, 0u);
    EXPECT_LE((force.head<2>() / force[2] - expected).norm(), 1e-9);
  }
}
} // namespace orthocone::test
