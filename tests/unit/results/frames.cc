// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Contact surfaces with normals of their own: scenes turned in space, wedges, grooves and press fits.
#include "results/scenes.h"
#include "results/turned.h"

#include <orthocone/scene/parameters.h>

#include <Eigen/Geometry>

namespace orthocone::test
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

Leg moved_by(const Vector3d &way, const unsigned int steps)
{
  return move_to(way[0], way[1], way[2], steps);
}

/// A small block on a rigid sphere of radius 60 mm with orthotropic friction whose slip rule is another one,
/// pressed and pushed around a corner, so that it wears. All of it is turned in space.
Parameters turned_block(const Folder &folder, const std::string &name, const Matrix3d &turn)
{
  Parameters parameters;
  parameters.geometry = imported(folder.write(
      name, box_mesh({{4, 3, 2}}, {4, 3, 2}, {{3, 3, 3, 3, 1, 2}},
                     [&](const Vector3d &place) { return Vector3d(turn * (place - Vector3d(2, 1.5, 0))); })));
  parameters.mesh.degree = 2;
  const auto along = [&](const unsigned int d) { return linear(turn.col(d)); };
  parameters.obstacle.distance =
      "sqrt(" + along(0) + "^2 + " + along(1) + "^2 + " + linear(turn.col(2), 60) + "^2) - 60";
  parameters.friction.slip_potential = std::array<double, 2>{{0.05, 0.2}};
  const Vector3d axis = turn * Vector3d(std::cos(0.5), std::sin(0.5), 0);
  parameters.friction.first_axis = std::array<Expression, 3>{
      {Expression(to_text(axis[0])), Expression(to_text(axis[1])), Expression(to_text(axis[2]))}};
  parameters.wear.law = "archard";
  parameters.wear.coefficient = 1e-6;
  const Vector3d pressed(0, 0, -0.03);
  parameters.load.legs = {moved_by(turn * pressed, 2), moved_by(turn * (pressed + Vector3d(0.006, 0, 0)), 3),
                          moved_by(turn * (pressed + Vector3d(0.006, 0.006, 0)), 3)};
  parameters.contact_solver.tolerance = 1e-12;
  share_among_bodies(parameters);
  return parameters;
}

/// A prism along y, of n cells around: its lower side is that of `height`, and its upper one is at z = top.
std::string prism(const double width, const double top, const std::vector<unsigned int> &cells,
                  const std::function<double(double)> &height)
{
  return box_mesh({{width, 4, 1}}, cells, {{3, 3, 3, 3, 1, 2}},
                  [&](const Vector3d &place)
                  {
                    const double across = place[0] - width / 2, low = height(across);
                    return Vector3d(across, place[1] - 2, low + place[2] * (top - low));
                  });
}
} // namespace

TEST(Frames, TurnASceneWithItsForces)
{
  const Folder folder;
  const Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()) * Eigen::AngleAxisd(2, Vector3d::UnitZ()))
          .toRotationMatrix();
  TestScene upright(turned_block(folder, "upright.msh", Matrix3d::Identity())),
      turned(turned_block(folder, "turned.msh", turn));
  upright.march();
  turned.march();
  const Vector3d force = upright.totals().force, of_turned = turned.totals().force;
  EXPECT_GT(force.head<2>().norm(), 0.05 * force[2]);
  EXPECT_LE((of_turned - turn * force).norm(), 1e-10 * force.norm());
  ASSERT_EQ(upright.state.n_nodes(), turned.state.n_nodes());
  double difference = 0, slip = 0;
  for (unsigned int node = 0; node < upright.state.n_nodes(); ++node)
  {
    const ContactFields a = upright.evaluator.fields(upright.state, node),
                        b = turned.evaluator.fields(turned.state, node);
    EXPECT_EQ(a.status, b.status);
    difference = std::max(
        {difference, (b.slip - turn * a.slip).norm(), (b.displacement - turn * a.displacement).norm()});
    slip = std::max(slip, a.slip.norm());
  }
  EXPECT_LE(difference, 1e-9 * slip);
  EXPECT_GT(upright.totals().max_wear_depth, 1e-6);
  EXPECT_NEAR(turned.totals().worn_volume, upright.totals().worn_volume, 1e-9 * upright.totals().worn_volume);
  EXPECT_NEAR(turned.evaluator.stick_area(turned.state), upright.evaluator.stick_area(upright.state), 1e-6);
}

// NAFEMS R0094, CGS-4: F / G = (tan a + mu) / (1 - mu tan a), in gross sliding up the slope.
TEST(Frames, PushAWedgeUpItsSlope)
{
  const Folder folder;
  constexpr double slope = 0.1, mu = 0.2;
  Parameters parameters;
  parameters.geometry =
      imported(folder.write("wedge.msh", prism(4, 3, {3, 2, 2}, [](const double x) { return slope * x; })));
  parameters.mesh.degree = 1;
  parameters.friction.mu = {{mu, mu}};
  parameters.obstacle.distance = "(z - 0.1*x)/sqrt(1 + 0.1^2)";
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(1, 0, -0.01 + slope * 1, 4)};
  share_among_bodies(parameters);
  TestScene scene(parameters);
  scene.march();
  const Totals totals = scene.totals();
  EXPECT_NEAR(-totals.force[0] / totals.force[2], (slope + mu) / (1 - mu * slope), 1e-9);
  EXPECT_NEAR(totals.contact_area, 16 * std::sqrt(1 + slope * slope), 1e-9);
}

// F = mu G / sin(half angle), pulled along the groove; all models and both backends.
TEST(Frames, PullAPrismAlongAGroove)
{
  const Folder folder;
  const double half_angle = 0.6, mu = 0.15, flank = 1 / std::tan(half_angle);
  Parameters parameters;
  parameters.geometry = imported(
      folder.write("prism.msh", prism(4, 3, {4, 2, 2},
                                      [&](const double x) { return std::max(0.5, std::abs(x)) * flank; })));
  parameters.mesh.degree = 2;
  parameters.friction.mu = {{mu, mu}};
  std::ostringstream distance;
  distance << "min(z*sin(" << half_angle << ") - x*cos(" << half_angle << "), z*sin(" << half_angle
           << ") + x*cos(" << half_angle << "))";
  parameters.obstacle.distance = distance.str();
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(0, 1, -0.01, 4)};
  share_among_bodies(parameters);
  TestScene condensed(parameters);
  condensed.march();
  const Totals totals = condensed.totals();
  EXPECT_NEAR(-totals.force[1] / totals.force[2], mu / std::sin(half_angle), 1e-6);
  EXPECT_NEAR(totals.force[0], 0, 1e-9 * totals.force[2]);
  parameters.mesh.backend = BodyBackend::multigrid;
  TestScene multigrid(parameters);
  multigrid.march();
  EXPECT_LE((multigrid.totals().force - totals.force).norm(), 1e-8 * totals.force.norm());
}

namespace
{
Expression expression(const char *text)
{
  return Expression(text);
}

/// Friction of a shaft: 0.1 along z, and 0.3 around it.
void set_axial_friction(FrictionOptions &friction)
{
  friction.mu = {{0.1, 0.3}};
  friction.first_axis = std::array<Expression, 3>{{expression("0"), expression("0"), expression("1")}};
}

/// Adds an interference, and a leg that drives it to 1.
void set_interference(Parameters &parameters)
{
  Load fit;
  EXPECT_EQ(parse_load("fit: interference", fit), "");
  parameters.load.loads = {fit};
  parameters.contact_solver.tolerance = 1e-12;
  Leg assembled;
  assembled.loads = {{"fit", 1}};
  parameters.load.legs = {assembled};
  share_among_bodies(parameters);
}

/// A hub between the radii 10 and 20 mm, 6 mm long, around a rigid shaft that is 0.01 mm too thick.
Parameters hub_on_shaft(const Folder &folder, const double poisson_ratio)
{
  constexpr double inner = 10, outer = 20, length = 6;
  dealii::Triangulation<3> ring;
  dealii::Triangulation<2> section;
  dealii::GridGenerator::concentric_hyper_shells(section, dealii::Point<2>(), inner, outer, 3, 0., 32);
  dealii::GridGenerator::extrude_triangulation(section, 2, length, ring);
  for (const auto &face : ring.active_face_iterators())
    if (face->at_boundary())
    {
      const auto centre = face->center();
      const bool is_end = centre[2] < 1e-9 || centre[2] > length - 1e-9;
      face->set_boundary_id(is_end ? 3 : std::hypot(centre[0], centre[1]) < (inner + outer) / 2 ? 1 : 2);
    }
  Parameters parameters;
  parameters.geometry =
      imported(folder.write("hub.msh", mapped_mesh(ring, [](const Vector3d &place) { return place; })));
  parameters.mesh.degree = 2;
  parameters.material.poisson_ratio = poisson_ratio;
  parameters.obstacle.normal = ObstacleNormal::surface;
  parameters.obstacle.gap = "-0.01";
  set_axial_friction(parameters.friction);
  set_interference(parameters);
  return parameters;
}

/// The pressure of Lame's solution in plane strain at the bore of a hub whose outer surface is held: with
/// u(a) = delta and u(b) = 0, E delta / ((1 + nu) a) (1/a^2 + 1/((1 - 2 nu) b^2)) / (1/a^2 - 1/b^2).
double pressure_of_held_hub(const double nu)
{
  constexpr double modulus = 210000, a = 10, b = 20, delta = 0.01;
  return modulus * delta / ((1 + nu) * a) * (1 / (a * a) + 1 / ((1 - 2 * nu) * b * b)) /
         (1 / (a * a) - 1 / (b * b));
}

double normal_force(const TestScene &scene)
{
  return scene.state.force(Eigen::seq(0, Eigen::last, 3)).sum();
}
} // namespace

// A shaft of radius 10 mm that is 0.01 mm too thick for a rigid bore: p = E / ((1 + nu) (1 - 2 nu)) delta / R
// in plane strain. Its state is linear in the radius, so that every model has it, also on curved faces.
TEST(Frames, PressAShaftIntoABore)
{
  Parameters parameters;
  GeometryOptions &geometry = parameters.geometry;
  geometry.contact_surfaces = {"side"};
  geometry.top_face = TopFace::free;
  geometry.supports = {{"base", {{false, false, true}}}, {"top", {{false, false, true}}}};
  parameters.mesh.core_cells = 4;
  parameters.mesh.rings = 2;
  parameters.mesh.layers = 3;
  parameters.obstacle.normal = ObstacleNormal::surface;
  parameters.obstacle.gap = "-0.01";
  set_axial_friction(parameters.friction);
  set_interference(parameters);
  const double nu = parameters.material.poisson_ratio;
  const double expected = parameters.material.young_modulus / ((1 + nu) * (1 - 2 * nu)) * 0.01 / 10;
  for (const auto &[model, tolerance] : {std::pair(ModelKind::automatic, 1e-9),
                                         {ModelKind::quarter, 1e-8},
                                         {ModelKind::half, 1e-8},
                                         {ModelKind::full, 1e-8}})
  {
    TestScene scene(with_model(parameters, model));
    EXPECT_EQ(scene.symmetry.name(), model == ModelKind::automatic ? "axisymmetric" : to_word(model));
    expect_checked_steps(scene);
    for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    {
      const ContactFields fields = scene.evaluator.fields(scene.state, node);
      EXPECT_NEAR(fields.pressure, expected, tolerance * expected);
      EXPECT_NEAR(fields.displacement.head<2>().norm(), 0.01, 1e-10);
    }
    EXPECT_NEAR(scene.totals().contact_area, 2 * pi * 10 * 10, 1e-3 * 200 * pi);
    EXPECT_NEAR(scene.evaluator.stick_area(scene.state), scene.totals().contact_area, 1e-3);
  }
}

namespace
{
/// A box of 8 x 6 x 4 mm between three walls, two of which it touches when it is pressed.
Parameters box_between_walls()
{
  Parameters parameters;
  GeometryOptions &geometry = parameters.geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{8, 6, 4}};
  geometry.contact_surfaces = {"base", "x-", "x+"};
  geometry.top_face = TopFace::guided;
  geometry.supports = {{"y-", {{true, true, false}}}, {"y+", {{true, true, false}}}};
  parameters.mesh.cells = {{4, 2, 2}};
  parameters.mesh.degree = 2;
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.obstacle.distance = "min(z, 4.002 - abs(x))";
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.05, 2), move_to(0, 0, -0.02, 1)};
  share_among_bodies(parameters);
  return parameters;
}
} // namespace

// A box between three walls, in all models: each wall has its own sums, which add up to those of the body.
// The corner nodes touch the ground, whose pressure is even under a body without Poisson's ratio.
TEST(Frames, SumUpEachOfSeveralSurfaces)
{
  const Parameters parameters = box_between_walls();
  std::vector<SurfaceTotals> of_full;
  for (const ModelKind model : {ModelKind::full, ModelKind::half, ModelKind::quarter})
  {
    TestScene scene(with_model(parameters, model));
    expect_checked_steps(scene);
    const Totals totals = scene.totals();
    ASSERT_EQ(totals.surfaces.size(), 3u);
    const auto &[base, left, right] = std::tie(totals.surfaces[0], totals.surfaces[1], totals.surfaces[2]);
    EXPECT_LE((base.force + left.force + right.force - totals.force).norm(), 1e-9 * totals.force.norm());
    EXPECT_NEAR(base.contact_area + left.contact_area + right.contact_area, totals.contact_area, 1e-9);
    EXPECT_NEAR(base.total_dissipation + left.total_dissipation + right.total_dissipation,
                totals.total_dissipation, 1e-9 * totals.total_dissipation);
    EXPECT_NEAR(left.force[0], left.normal_force, 1e-9 * left.normal_force) << "into the body";
    EXPECT_NEAR(right.force[0], -left.force[0], 1e-8 * left.force[0]);
    EXPECT_GT(left.normal_force, 0.01 * base.normal_force);
    if (of_full.empty())
      of_full = totals.surfaces;
    for (std::size_t i = 0; i < of_full.size(); ++i)
    {
      EXPECT_LE((totals.surfaces[i].force - of_full[i].force).norm(), 1e-8 * of_full[0].normal_force);
      EXPECT_NEAR(totals.surfaces[i].contact_area, of_full[i].contact_area, 1e-9);
      EXPECT_NEAR(totals.surfaces[i].max_pressure, of_full[i].max_pressure, 1e-8 * of_full[0].max_pressure);
    }
  }
}

// One wall of two breaks the symmetry, although the counterface has it. Where a wall stands along the normal,
// its nodes have an area nevertheless.
TEST(Frames, KeepASurfaceWithoutAMirrorImage)
{
  Parameters parameters = box_between_walls();
  parameters.geometry.contact_surfaces = {"base", "x-"};
  parameters.obstacle.distance = "z + 0*x";
  TestScene scene(parameters);
  EXPECT_EQ(scene.symmetry.name(), "half");
  scene.march();
  const auto &nodes = scene.discretization.contact_surface().nodes;
  EXPECT_TRUE(
      std::any_of(nodes.begin(), nodes.end(), [](const ContactNode &node) { return node.height > 1; }));
  for (unsigned int node = 0; node < nodes.size(); ++node)
    EXPECT_TRUE(std::isfinite(scene.evaluator.fields(scene.state, node).pressure));
}

TEST(Frames, HaveAnEvenPressureUpToTheCorners)
{
  Parameters parameters = box_between_walls();
  parameters.material.poisson_ratio = 0;
  TestScene scene(parameters);
  scene.march();
  EXPECT_NEAR(scene.totals().max_pressure, 210000 * 0.02 / 4, 1e-6 * 1000);
}

// Lame's pressure, as a mean over the plane faces of the file, and the torque that slips the whole seat: mu p
// 2 pi a^2 L, with the friction around it.
TEST(Frames, TurnAHubOnItsShaft)
{
  const Folder folder;
  Parameters parameters = hub_on_shaft(folder, 0.3);
  parameters.geometry.supports = {{"side", {{false, false, true}}}};
  Leg turned;
  turned.targets[5] = Drive{false, 0.1};
  turned.steps = 2;
  parameters.load.legs.push_back(turned);
  TestScene scene(parameters);
  double pressure = 0;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &step)
      {
        if (step.number == 1)
          pressure = after.force(Eigen::seq(0, Eigen::last, 3)).sum() / (2 * pi * 10 * 6);
      });
  const double expected = pressure_of_held_hub(0.3);
  EXPECT_NEAR(pressure, expected, 2e-3 * expected);
  const double torque = std::abs(scene.scene.held_wrench(scene.state.force, scene.state.motion)[5]);
  EXPECT_NEAR(torque, 0.3 * expected * 2 * pi * 100 * 6, 5e-3 * torque);
}

// The force that pushes it off the shaft: mu p 2 pi a L, with the friction along it. Without Poisson's ratio
// it changes no pressure.
TEST(Frames, PushAHubOffItsShaft)
{
  const Folder folder;
  Parameters parameters = hub_on_shaft(folder, 0);
  parameters.load.legs.push_back(move_to(0, 0, 0.2, 4));
  TestScene scene(parameters);
  scene.march();
  const double force = std::abs(scene.totals().force[2]), expected = pressure_of_held_hub(0);
  EXPECT_NEAR(force, 0.1 * normal_force(scene), 1e-6 * force);
  EXPECT_NEAR(force, 0.1 * expected * 2 * pi * 10 * 6, 5e-3 * force);
}
} // namespace orthocone::test
