// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Surfaces that are held at zero beside the held face: patch tests, rollers in place of planes of symmetry,
// forces in place of motions, both backends and all models.
#include "results/scenes.h"

#include <orthocone/multigrid/multigrid_body.h>

namespace orthocone::test
{
namespace
{
constexpr std::array<bool, 3> along_x{{true, false, false}}, along_y{{false, true, false}},
    along_z{{false, false, true}}, in_all{{true, true, true}};

/// A box of 4 x 3 x 2 mm whose model is the full one.
Parameters supported_box(const std::vector<Support> &supports, const unsigned int degree = 2)
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{4, 3, 2}};
  parameters.geometry.supports = supports;
  parameters.mesh.cells = {{4, 3, 2}};
  parameters.mesh.degree = degree;
  parameters.mesh.model = ModelKind::full;
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.002, 1)};
  return parameters;
}

Leg leg_to(const std::vector<std::tuple<unsigned int, bool, double>> &targets)
{
  Leg leg;
  for (const auto &[component, by_force, value] : targets)
    leg.targets[component] = Drive{by_force, value};
  leg.steps = 1;
  return leg;
}
} // namespace

// On two rollers, under a top that is free sideways: strains are u_z/h along z and -nu u_z/h across, the
// pressure is E u_z/h, whatever the cells.
TEST(Supports, LeaveABlockOnRollersUniform)
{
  for (const unsigned int degree : {1, 2})
  {
    Parameters parameters = supported_box({{"x-", along_x}, {"y+", along_y}}, degree);
    parameters.geometry.top_face = TopFace::guided;
    parameters.friction.mu = {{0, 0}};
    TestScene scene(parameters);
    expect_checked_steps(scene);
    const double strain = 0.002 / 2, pressure = strain * parameters.material.young_modulus;
    for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    {
      const ContactFields fields = scene.evaluator.fields(scene.state, node);
      const auto &at = scene.discretization.contact_surface().nodes[node].position;
      EXPECT_NEAR(fields.pressure, pressure, 1e-9 * pressure);
      EXPECT_NEAR(fields.slip[0], 0.3 * strain * (at[0] + 2), 1e-9 * 0.002);
      EXPECT_NEAR(fields.slip[1], 0.3 * strain * (at[1] - 1.5), 1e-9 * 0.002);
    }
    EXPECT_NEAR(scene.totals().held[2], -12 * pressure, 1e-9 * 12 * pressure);
  }
}

// What symmetry does in the half model of a block, a roller does for a block of half its size.
TEST(Supports, AreAPlaneOfSymmetryAsARoller)
{
  for (const unsigned int degree : {1, 2})
  {
    Parameters whole = supported_box({}, degree), part = supported_box({{"x-", along_x}}, degree);
    part.geometry.sizes[0] = 2;
    part.mesh.cells[0] = 2;
    for (Parameters *const parameters : {&whole, &part})
    {
      parameters->friction.mu = {{0.3, 0.15}};
      parameters->load.legs = {move_to(0, 0, -0.002, 2), move_to(0, 0.0005, -0.002, 2)};
    }
    TestScene one(whole), other(part);
    one.march();
    expect_checked_steps(other);
    const Totals of_whole = one.totals(), of_part = other.totals();
    EXPECT_GT(of_whole.total_dissipation, 0);
    EXPECT_NEAR(2 * of_part.total_dissipation, of_whole.total_dissipation, 1e-9 * of_whole.total_dissipation);
    EXPECT_LE((2 * of_part.force.tail<2>() - of_whole.force.tail<2>()).norm(), 1e-10 * of_whole.force.norm());
    EXPECT_NEAR(of_part.max_slip, of_whole.max_slip, 1e-9 * of_whole.max_slip);
  }
}

// Pressed and pushed against supports by motions, then by the forces that these motions took.
TEST(Supports, GiveTheSameStatesByForceAsByMotion)
{
  constexpr unsigned int x = 0, z = 2;
  Parameters by_motion = supported_box({{"x+", {{true, false, true}}}}, 1);
  by_motion.load.legs = {leg_to({{z, false, -0.002}}), leg_to({{x, false, 0.0005}})};
  TestScene moved(by_motion);
  std::vector<Wrench> wrenches;
  moved.march([&](const ContactState &, const ContactState &after, const LoadStep &)
              { wrenches.push_back(moved.scene.held_wrench(after.force, after.motion)); });
  ASSERT_GT((moved.totals().held.force() + moved.totals().force).norm(), 1); // supports carry a part
  for (const char *const method : {"newton", "gauss-seidel", "uzawa"})
  {
    SCOPED_TRACE(method);
    Parameters by_force = by_motion;
    by_force.contact_solver.method = method;
    by_force.contact_solver.maximum_iterations = 100000;
    by_force.load.legs.clear();
    for (const Wrench &wrench : wrenches)
      by_force.load.legs.push_back(leg_to({{z, true, wrench[z]}, {x, true, wrench[x]}}));
    TestScene pushed(by_force);
    expect_checked_steps(pushed);
    EXPECT_LE(largest_difference(pushed.state.motion.components, moved.state.motion.components), 1e-8);
    EXPECT_LE(largest_difference(pushed.state.force, moved.state.force), 1e-8);
  }
}

// A face that supports resist stays where its force leaves it when nothing touches.
TEST(Supports, CarryAFaceThatDoesNotTouch)
{
  Parameters parameters = supported_box({{"x-", in_all}, {"x+", in_all}}, 1);
  parameters.obstacle.gap = "1";
  parameters.load.legs = {leg_to({{2, true, -1000}})};
  TestScene scene(parameters);
  scene.march();
  EXPECT_LE(scene.state.force.norm(), 1e-6);
  EXPECT_NEAR(scene.state.motion[2], -1000 / scene.condensed.driven()->conjugates(2, 2),
              1e-9 * std::abs(scene.state.motion[2]));
}

TEST(Supports, AreTheSameByBothBackends)
{
  Parameters parameters = supported_box({{"x+", {{true, false, true}}}, {"y-", along_y}});
  parameters.mesh.refinements = 1;
  parameters.mesh.cells = {{2, 2, 1}};
  parameters.load.legs = {move_to(0, 0, -0.002, 1), move_to(0.0005, 0, -0.002, 1)};
  parameters.contact_solver.tolerance = 1e-10;
  TestScene one(parameters);
  parameters.mesh.backend = BodyBackend::multigrid;
  TestScene other(parameters);
  const DrivenField &a = *one.condensed.driven(), &b = *other.condensed.driven();
  EXPECT_LE((a.contact - b.contact).norm(), 1e-9 * a.contact.norm());
  EXPECT_LE((a.conjugates - b.conjugates).norm(), 1e-9 * a.conjugates.norm());
  one.march();
  other.march();
  EXPECT_LE(largest_difference(other.state.force, one.state.force), 1e-7);
}

// A section against one layer of cells whose sides are held along y.
TEST(Supports, HaveTheForcesOfASlice)
{
  for (const unsigned int degree : {1, 2})
  {
    Parameters section = supported_box({{"x+", {{true, false, true}}}}, degree);
    section.mesh.cells[1] = 1;
    section.friction.mu = {{0.3, 0.3}};
    section.load.legs = {move_to(0, 0, -0.002, 1), move_to(0.0005, 0, -0.002, 1)};
    Parameters slice = section;
    section.geometry.kind = GeometryKind::plane_strain;
    slice.geometry.supports.push_back({"y-", along_y});
    slice.geometry.supports.push_back({"y+", along_y});
    TestScene one(section), other(slice);
    expect_checked_steps(one);
    other.march();
    EXPECT_LE((one.totals().force - other.totals().force).norm(), 1e-10 * one.totals().force.norm());
    EXPECT_LE((one.totals().held.force() - other.totals().held.force()).norm(),
              1e-10 * one.totals().held.force().norm());
    EXPECT_GT((one.totals().held.force() + one.totals().force).norm(), 1e-3 * one.totals().force.norm());
  }
}

// A cylinder in a smooth stiff bore is strained along z alone: the oedometric modulus, in every model.
TEST(Supports, KeepACylinderFromWidening)
{
  Parameters parameters = small_scene(2);
  parameters.friction.mu = {{0.3, 0.3}};
  parameters.geometry.supports = {{"side", {{true, true, false}}}};
  parameters.load.legs = {move_to(0, 0, -0.01, 1)};
  const double nu = 0.3, modulus = 210000 * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), pressure = modulus * 0.001;
  for (const ModelKind model : {ModelKind::automatic, ModelKind::quarter, ModelKind::full})
  {
    TestScene scene(with_model(parameters, model));
    ASSERT_EQ(scene.symmetry.is_axisymmetric(), model == ModelKind::automatic);
    expect_checked_steps(scene);
    EXPECT_NEAR(scene.totals().min_pressure, pressure, 1e-9 * pressure);
    EXPECT_NEAR(scene.totals().max_pressure, pressure, 1e-9 * pressure);
    EXPECT_NEAR(scene.totals().held[2], -scene.totals().force[2], 1e-9 * scene.totals().force[2]);
  }
}

TEST(Supports, DecideOfTheModel)
{
  Parameters parameters = supported_box({{"x+", along_x}});
  parameters.mesh.model = ModelKind::automatic;
  parameters.mesh.cells = {{4, 4, 2}};
  parameters.friction.mu = {{0.3, 0.3}};
  EXPECT_EQ(choose_model(parameters).symmetry.name(), "half");
  EXPECT_EQ(choose_model(parameters).reason, "Geometry/Supports = x+: x has no mirror image on x-");
  parameters.geometry.supports.push_back({"x-", along_x});
  EXPECT_EQ(choose_model(parameters).symmetry.name(), "quarter");
  parameters.geometry.supports.push_back({"y-", along_z});
  EXPECT_EQ(choose_model(parameters).symmetry.name(), "half");
}
} // namespace orthocone::test
