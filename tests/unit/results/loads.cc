// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Loads beside the held face: uniform states, reciprocity, energies, all kinds in both backends and all
// models.
#include "results/scenes.h"

#include <orthocone/results/tables.h>
#include <orthocone/scene/legs.h>
#include <orthocone/scene/parameters.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace orthocone::test
{
namespace
{
constexpr std::array<bool, 3> along_x{{true, false, false}}, along_y{{false, true, false}};

Load load_of(const std::string &text)
{
  Load load;
  EXPECT_EQ(parse_load(text, load), "");
  return load;
}

/// A box of 4 x 3 x 2 mm with loads.
Parameters loaded_box(const std::vector<std::string> &loads, const std::vector<Leg> &legs,
                      const unsigned int degree = 2)
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{4, 3, 2}};
  parameters.mesh.cells = {{4, 2, 2}};
  parameters.mesh.degree = degree;
  parameters.material.thermal_expansion = 1.2e-5;
  parameters.contact_solver.tolerance = 1e-12;
  for (const std::string &text : loads)
    parameters.load.loads.push_back(load_of(text));
  parameters.load.legs = legs;
  share_among_bodies(parameters);
  return parameters;
}

Leg leg_of(const std::vector<std::pair<std::string, double>> &loads, const unsigned int steps = 1)
{
  Leg leg;
  leg.loads = loads;
  leg.steps = steps;
  return leg;
}

/// The mean of -n . u over a boundary of the whole body, by a quadrature of the displacement field.
double mean_inwards(const Discretization &space, const Eigen::VectorXd &u, const unsigned int boundary)
{
  const dealii::QGauss<2> quadrature(space.fe().degree + 1);
  dealii::FEFaceValues<3> values(space.mapping(), space.fe(), quadrature,
                                 dealii::update_values | dealii::update_normal_vectors |
                                     dealii::update_JxW_values);
  double sum = 0, area = 0;
  std::vector<dealii::types::global_dof_index> dofs(space.fe().n_dofs_per_cell());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
      {
        values.reinit(cell, face);
        cell->get_dof_indices(dofs);
        for (const unsigned int q : values.quadrature_point_indices())
        {
          area += values.JxW(q);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            sum -= u[static_cast<Eigen::Index>(dofs[i])] * values.shape_value(i, q) *
                   values.normal_vector(q)[space.fe().system_to_component_index(i).first] * values.JxW(q);
        }
      }
  return sum / area;
}
} // namespace

// Pressed on all sides a body is under that pressure everywhere, which the plane then bears; it shrinks by
// p (1 - 2 nu)/E in all directions.
TEST(Loads, PressAFreeBodyHydrostatically)
{
  constexpr double p = 40, e = 210000, strain = p * (1 - 2 * 0.3) / e;
  for (const unsigned int degree : {1, 2, 3})
  {
    Parameters parameters =
        loaded_box({"all: pressure on x- x+ y- y+ top"}, {leg_of({{"all", p}}, 2)}, degree);
    parameters.geometry.top_face = TopFace::free;
    parameters.friction.mu = {{0, 0}};
    TestScene scene(parameters);
    ASSERT_EQ(scene.symmetry.name(), "quarter");
    expect_checked_steps(scene);
    for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    {
      const ContactFields fields = scene.evaluator.fields(scene.state, node);
      const auto &at = scene.discretization.contact_surface().nodes[node].position;
      EXPECT_NEAR(fields.pressure, p, 1e-10 * p);
      EXPECT_NEAR(fields.displacement[0], -strain * at[0], 1e-10 * strain);
      EXPECT_NEAR(fields.displacement[1], -strain * at[1], 1e-10 * strain);
    }
    const Totals totals = scene.totals();
    EXPECT_NEAR(totals.elastic_energy, 0.5 * 3 * p * strain * 24, 1e-10 * p * strain * 24);
    EXPECT_LE(totals.held.components.norm(), 1e-9 * p * 12);
  }
}

// Warmth alone makes a free body larger, with neither stress, force nor energy, in every material and shape.
TEST(Loads, WarmAFreeBodyWithoutForces)
{
  constexpr double strain = 1.2e-5 * 50;
  Parameters box = loaded_box({"warm: temperature"}, {leg_of({{"warm", 50}})});
  box.geometry.top_face = TopFace::free;
  box.material.law.choose("orthotropic");
  Parameters cylinder = small_scene(2);
  cylinder.geometry.top_face = TopFace::free;
  cylinder.friction.mu = {{0.3, 0.3}};
  cylinder.material.thermal_expansion = 1.2e-5;
  cylinder.load = box.load;
  share_among_bodies(cylinder);
  for (const Parameters &parameters :
       {box, cylinder, with_model(cylinder, ModelKind::quarter), with_model(cylinder, ModelKind::full)})
  {
    TestScene scene(parameters);
    scene.march();
    const Totals totals = scene.totals();
    const double scale = 210000 * strain;
    EXPECT_LE(scene.state.force.lpNorm<Eigen::Infinity>(), 1e-9 * scale);
    EXPECT_LE(totals.elastic_energy, 1e-9 * scale);
    for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    {
      const ContactFields fields = scene.evaluator.fields(scene.state, node);
      const auto &at = scene.discretization.contact_surface().nodes[node].position;
      EXPECT_NEAR(fields.displacement[0], strain * at[0], 1e-9 * strain);
      EXPECT_NEAR(fields.displacement[1], strain * at[1], 1e-9 * strain);
    }
  }
}

// Between smooth plates that do not give way a warm body is under the stress -E alpha T along z alone.
TEST(Loads, WarmABodyBetweenPlates)
{
  constexpr double e = 210000, alpha = 1.2e-5, warmth = 50, stress = e * alpha * warmth;
  Parameters parameters = loaded_box({"warm: temperature"}, {leg_of({{"warm", warmth}}, 2)});
  parameters.geometry.top_face = TopFace::guided;
  parameters.friction.mu = {{0, 0}};
  TestScene scene(parameters);
  expect_checked_steps(scene);
  const Totals totals = scene.totals();
  EXPECT_NEAR(totals.min_pressure, stress, 1e-10 * stress);
  EXPECT_NEAR(totals.max_pressure, stress, 1e-10 * stress);
  EXPECT_NEAR(totals.held[2], -12 * stress, 1e-10 * 12 * stress);
  EXPECT_NEAR(totals.elastic_energy, 0.5 * stress * stress / e * 24, 1e-10 * stress * stress / e * 24);
  EXPECT_NEAR(totals.conjugates[0], stress * alpha * 24, 1e-10 * stress * alpha * 24);
}

// Betti between two pressures, and between each of them and contact forces: the work of one on the
// displacement by the other is the same both ways. Works are integrated over the surfaces from fields of the
// whole body.
TEST(Loads, KeepReciprocity)
{
  Parameters parameters =
      loaded_box({"side: pressure on x+", "flank: pressure on y+"}, {leg_of({{"side", 1}, {"flank", 1}})});
  parameters.geometry.supports = {{"y-", along_y}};
  parameters.mesh.model = ModelKind::full;
  share_among_bodies(parameters);
  TestScene scene(parameters);
  const ElasticBody &body = scene.condensed;
  const Discretization &space = body.mesh().solid();
  constexpr std::array<double, 2> areas{{6, 8}}; // mm^2
  const auto work = [&](const unsigned int load, const Eigen::VectorXd &u)
  {
    return areas[load] *
           mean_inwards(space, u, boundary_of_marked(parameters.geometry, load == 0 ? "x+" : "y+"));
  };
  NodeVector force(3 * scene.state.n_nodes());
  for (Eigen::Index i = 0; i < force.size(); ++i)
    force[i] = std::sin(1. + static_cast<double>(i * i));
  const Eigen::VectorXd by_forces = body.with_motion({}, body.elastic_displacement(force));
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(space.n_free());
  for (const unsigned int load : {0, 1})
  {
    const Eigen::VectorXd unit = Eigen::Vector2d::Unit(load), other = Eigen::Vector2d::Unit(1 - load);
    const double of_pair = work(load, body.with_motion({}, at_rest, other));
    EXPECT_NEAR(of_pair, work(1 - load, body.with_motion({}, at_rest, unit)), 1e-10 * std::abs(of_pair));
    const double of_forces = work(load, by_forces);
    EXPECT_NEAR(of_forces, force.dot(body.moved_with({}, unit)), 1e-10 * std::abs(of_forces));
    EXPECT_NEAR(of_forces, scene.scene.load_conjugates(force, {}, Eigen::Vector2d::Zero())[load],
                1e-10 * std::abs(of_forces));
  }
}

// Without contact the held face and supports carry what loads bring, force and moment.
TEST(Loads, AreBalancedByTheHeldFace)
{
  Parameters parameters = loaded_box({"side: pressure on x+", "pull: traction on y- along 1, 2, 2"},
                                     {leg_of({{"side", 7}, {"pull", 3}})});
  parameters.obstacle.gap = "1";
  TestScene scene(parameters);
  expect_checked_steps(scene);
  const Eigen::Vector3d on_side(-7 * 6, 0, 0), pull = 3 * 8 * Eigen::Vector3d(1, 2, 2) / 3;
  const Eigen::Vector3d moment =
      Eigen::Vector3d(2, 0, -1).cross(on_side) + Eigen::Vector3d(0, -1.5, -1).cross(pull);
  EXPECT_LE((scene.totals().held.force() + on_side + pull).norm(), 1e-9 * pull.norm());
  EXPECT_LE((scene.totals().held.moment() + moment).norm(), 1e-9 * moment.norm());
}

// In a bar a traction and the force that it amounts to, on a second rigid face, are the same, as is the
// motion of that face; each finds the conjugate that the others give.
TEST(Loads, AreTheSameByTractionForceAndMotion)
{
  constexpr double stress = 30, e = 210000;
  std::optional<Eigen::VectorXd> contact;
  for (const auto &[text, value, conjugate] :
       {std::tuple{"end: traction on x+ along x", stress, 4 * stress / e},
        {"end: force on x+ along x", 6 * stress, 4 * stress / e},
        {"end: motion on x+ along x", 4 * stress / e, 6 * stress}})
  {
    SCOPED_TRACE(text);
    Parameters parameters =
        loaded_box({text, "down: pressure on top"}, {leg_of({{"down", 1}}), leg_of({{"end", value}})});
    parameters.geometry.top_face = TopFace::free;
    parameters.geometry.supports = {{"x-", along_x}, {"y-", along_y}};
    parameters.friction.mu = {{0, 0}};
    share_among_bodies(parameters);
    TestScene scene(parameters);
    expect_checked_steps(scene);
    const Totals totals = scene.totals();
    const double scale = parameters.load.loads[0].kind->acts_by_traction() ? totals.load_areas[0] : 1;
    // The pressure from above widens the bar by nu p/E.
    const bool is_motion = parameters.load.loads[0].kind->word() == "motion";
    const double widened = is_motion ? -6 * 0.3 : 4 * 0.3 / e;
    EXPECT_NEAR(totals.conjugates[0] / scale, conjugate + widened, 1e-9 * conjugate);
    if (!is_motion)
    {
      EXPECT_LE(largest_difference(scene.state.displacement, contact.value_or(scene.state.displacement)),
                1e-9);
      contact = scene.state.displacement;
    }
  }
}

// A rig with everything at once, out of phase: energies of all loads balance, forward and back.
TEST(Loads, KeepTheEnergyOfACycle)
{
  Parameters parameters = loaded_box({"bulk: traction on x+ along x", "squeeze: pressure on y- y+",
                                      "warm: temperature", "lift: force on y+ along z"},
                                     {}, 1);
  parameters.geometry.supports = {{"x-", along_x}};
  share_among_bodies(parameters);
  Leg press;
  press.targets[2] = Drive{true, -600};
  press.loads = {{"squeeze", 10}};
  Leg shear = leg_of({{"bulk", 40}, {"lift", 20}}, 3);
  shear.targets[1] = Drive{true, 60};
  Leg back = leg_of({{"bulk", -40}, {"warm", 5}}, 3);
  back.targets[1] = Drive{true, -60};
  parameters.load.legs = {press, shear, back};
  TestScene scene(parameters);
  expect_checked_steps(scene);
  EXPECT_GT(scene.totals().total_dissipation, 1e-4 * scene.totals().elastic_energy);
  EXPECT_NEAR(scene.totals().loads[3], 20, 1e-6 * 20);
}

TEST(Loads, AreTheSameByBothBackends)
{
  Parameters parameters =
      loaded_box({"bulk: traction on x+ along x", "warm: temperature", "face: motion on x- along z"},
                 {move_to(0, 0, -0.002, 1), leg_of({{"bulk", 20}, {"warm", 2}, {"face", -1e-4}})});
  parameters.mesh.cells = {{2, 2, 1}};
  parameters.mesh.refinements = 1;
  parameters.mesh.model = ModelKind::full;
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

// A load that a model leaves symmetric is the same in every model.
TEST(Loads, AreTheSameInEveryModel)
{
  Parameters parameters = small_scene(2);
  parameters.friction.mu = {{0.3, 0.3}};
  parameters.load.loads = {load_of("squeeze: pressure on side"), load_of("down: traction on side along -z")};
  parameters.load.legs = {move_to(0, 0, -0.01, 1), leg_of({{"squeeze", 100}, {"down", 20}}, 2)};
  share_among_bodies(parameters);
  std::optional<Totals> first;
  for (const ModelKind model : {ModelKind::quarter, ModelKind::half, ModelKind::full})
  {
    TestScene scene(with_model(parameters, model));
    expect_checked_steps(scene);
    const Totals totals = scene.totals();
    if (first)
    {
      EXPECT_NEAR(totals.held[2], first->held[2], closeness * std::abs(first->held[2]));
      EXPECT_LE(largest_difference(totals.conjugates, first->conjugates), closeness);
    }
    first = totals;
  }
  TestScene section(parameters);
  ASSERT_TRUE(section.symmetry.is_axisymmetric());
  expect_checked_steps(section);
  EXPECT_NEAR(section.totals().held[2], first->held[2], 1e-2 * std::abs(first->held[2])); // other cells
  const double area = 2 * pi * 10 * 10;
  EXPECT_NEAR(section.totals().load_areas[0], area, 1e-12 * area);
}

// A section against one layer of cells whose sides are held along y.
TEST(Loads, HaveTheForcesOfASlice)
{
  Parameters section =
      loaded_box({"bulk: traction on x+ along x", "warm: temperature", "side: pressure on x-"},
                 {move_to(0, 0, -0.002, 1), leg_of({{"bulk", 50}, {"warm", 3}, {"side", 30}}, 2)});
  section.mesh.cells[1] = 1;
  section.friction.mu = {{0.3, 0.3}};
  Parameters slice = section;
  section.geometry.kind = GeometryKind::plane_strain;
  share_among_bodies(section);
  slice.geometry.supports = {{"y-", along_y}, {"y+", along_y}};
  TestScene one(section), other(slice);
  expect_checked_steps(one);
  other.march();
  EXPECT_LE((one.totals().force - other.totals().force).norm(), 1e-10 * one.totals().force.norm());
  EXPECT_LE(largest_difference(one.totals().conjugates, other.totals().conjugates), 1e-10);
  EXPECT_NEAR(one.totals().elastic_energy, other.totals().elastic_energy,
              1e-10 * one.totals().elastic_energy);
}

// Loads on the lower body: what presses the upper one up from below and the lower one down is the same pair.
TEST(Loads, OnTheLowerBodyAreThoseOfItsImage)
{
  Parameters parameters =
      loaded_box({"pull: traction on x+ along 0, 0, 1", "push: traction on lower x+ along 0, 0, -1"},
                 {move_to(0, 0, -0.002, 1), leg_of({{"pull", 20}, {"push", 20}})});
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower.geometry.shape = parameters.geometry.shape;
  parameters.lower.geometry.sizes = parameters.geometry.sizes;
  parameters.lower.mesh.cells = parameters.mesh.cells;
  parameters.lower.mesh.degree = parameters.mesh.degree;
  share_among_bodies(parameters);
  TestScene scene(parameters);
  expect_checked_steps(scene);
  // Both bodies are images of each other, so that nothing slides and both loads do the same work.
  const Totals totals = scene.totals();
  EXPECT_LE(totals.max_slip, 1e-12);
  const Eigen::VectorXd own = scene.condensed.moved_with({}, totals.loads),
                        both = scene.scene.driven_displacement({}, totals.loads);
  const double by_motion = -0.002 * 6; // the upper one moves with its face
  EXPECT_NEAR(totals.conjugates[0] - by_motion, totals.conjugates[1], 1e-9 * totals.conjugates[1]);
  for (Eigen::Index i = 0; i < both.size(); i += 3)
    EXPECT_NEAR(both[i], 2 * own[i], 1e-9 * own.lpNorm<Eigen::Infinity>());
}

// Each column of history.csv has a name of its own.
TEST(Loads, HaveNoNameOfAnotherColumn)
{
  std::string instead;
  for (const Column<SolvedStep> &column : history_columns())
    EXPECT_FALSE(loads_codec().parse(column.name + ": temperature", instead)) << column.name;
  EXPECT_TRUE(loads_codec().parse("bulk: temperature", instead));
}

TEST(Loads, DecideOfTheModel)
{
  const auto model_of = [](const std::string &text)
  {
    Parameters parameters = loaded_box({text}, {leg_of({{"a", 1}})});
    parameters.mesh.cells = {{4, 4, 2}};
    parameters.friction.mu = {{0.3, 0.3}};
    return choose_model(parameters);
  };
  EXPECT_EQ(model_of("a: pressure on x- x+").symmetry.name(), "quarter");
  EXPECT_EQ(model_of("a: traction on y- y+ along z").symmetry.name(), "quarter");
  EXPECT_EQ(model_of("a: pressure on x+").symmetry.name(), "half");
  EXPECT_EQ(model_of("a: pressure on x+").reason, "Load program/Loads: a acts on x+ and not on x-");
  EXPECT_EQ(model_of("a: traction on y- y+ along x").reason, "Load program/Loads: a acts along x");
  EXPECT_EQ(model_of("a: temperature").symmetry.name(), "quarter");
}
} // namespace orthocone::test
