// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"
#include "results/scenes.h"

#include <algorithm>

namespace orthocone::test
{
namespace
{
/// A cylinder on one like it, of another modulus.
Parameters on_body(const double stiffness, const unsigned int degree = 2)
{
  Parameters parameters = small_scene(degree);
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  parameters.lower.material.young_modulus *= stiffness;
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0, 0, -0.05, 2)};
  return parameters;
}

/// On one with other cells, too.
Parameters on_other_cells(const double stiffness)
{
  Parameters parameters = on_body(stiffness);
  parameters.lower.mesh.rings = 4;
  parameters.lower.mesh.layers = 3;
  parameters.lower.geometry.height = 7;
  return parameters;
}

Parameters swapped(Parameters parameters)
{
  std::swap(parameters.geometry, parameters.lower.geometry);
  std::swap(parameters.mesh, parameters.lower.mesh);
  std::swap(parameters.material, parameters.lower.material);
  return parameters;
}

double slip(const TestScene &scene)
{
  return scene.totals().max_accumulated_slip;
}
} // namespace

TEST(LowerBody, LikeBodiesMeetWithoutSlipAndHalveAFrictionlessPlane)
{
  for (const unsigned int degree : {1, 2})
  {
    TestScene both(on_body(1, degree));
    Parameters plane = on_body(1, degree);
    plane.obstacle.kind = ObstacleKind::rigid;
    plane.friction.mu = {{0, 0}};
    plane.load.legs = {move_to(0, 0, -0.05, 2), move_to(0, 0, -0.025, 2)};
    plane.mesh.model = ModelKind::quarter;
    TestScene half(plane);
    both.march();
    half.march();
    EXPECT_LE(slip(both), closeness * 0.1);
    EXPECT_LE(largest_difference(both.state.force, half.state.force), closeness);
  }
}

TEST(LowerBody, IsAPlaneWhereItIsStiff)
{
  TestScene soft(on_body(1)), stiff(on_body(1e8));
  Parameters parameters = on_body(1);
  parameters.obstacle.kind = ObstacleKind::rigid;
  TestScene rigid(with_model(parameters, ModelKind::quarter));
  for (TestScene *const scene : {&soft, &stiff, &rigid})
    scene->march();
  constexpr double close = 1e-6;
  EXPECT_LE(largest_difference(stiff.state.force, rigid.state.force), close);
  EXPECT_NEAR(stiff.totals().total_dissipation / rigid.totals().total_dissipation, 1, close);
  EXPECT_LT(soft.totals().force[2], 0.6 * rigid.totals().force[2]);
}

TEST(LowerBody, ReducedModelsGiveTheAnswersOfTheFullOne)
{
  TestScene whole(with_model(on_other_cells(0.3), ModelKind::full));
  whole.march();
  for (const ModelKind model : {ModelKind::half, ModelKind::quarter})
  {
    TestScene part(with_model(on_other_cells(0.3), model));
    part.march();
    expect_same_fields(part, whole, closeness);
    EXPECT_NEAR(part.totals().elastic_energy / whole.totals().elastic_energy, 1, closeness);
  }
}

TEST(LowerBody, ChangesPlacesWithTheOtherOne)
{
  Parameters parameters = on_body(0.3);
  parameters.lower.geometry.height = 6;
  TestScene there(parameters), back(swapped(parameters));
  there.march();
  back.march();
  ASSERT_EQ(there.state.n_nodes(), back.state.n_nodes());
  const double largest = there.state.force.lpNorm<Eigen::Infinity>();
  EXPECT_GT(slip(there), 1e-4);
  for (Eigen::Index i = 0; i < there.state.n_nodes(); ++i)
  {
    EXPECT_NEAR(there.state.force[3 * i], back.state.force[3 * i], closeness * largest);
    for (const Eigen::Index d : {1, 2}) // what draws one draws the other the opposite way
      EXPECT_NEAR(there.state.force[3 * i + d], -back.state.force[3 * i + d], closeness * largest);
  }
}

/// Slip and its border belong to both bodies. Without the Poisson's ratio of the other one, slip along the
/// border would be too stiff or too soft.
TEST(LowerBody, HasTheStickZoneOfTheOtherOne)
{
  Parameters parameters = on_body(0.3);
  parameters.material.poisson_ratio = 0.05;
  parameters.lower.material.poisson_ratio = 0.45;
  parameters.lower.geometry.height = 6;
  parameters.load.legs.push_back(move_to(0.01, 0, -0.05, 2));
  Parameters turned = swapped(parameters);
  turned.load.legs.back() = move_to(-0.01, 0, -0.05, 2);
  TestScene there(parameters), back(turned);
  std::vector<double> areas;
  const auto area = [](const TestScene &scene, const ContactState &after)
  { return scene.evaluator.stick_area(after); };
  there.march([&](const ContactState &, const ContactState &after, const LoadStep &)
              { areas.push_back(area(there, after)); });
  back.march([&](const ContactState &, const ContactState &after, const LoadStep &step)
             { EXPECT_NEAR(area(back, after) / areas[step.number - 1], 1, 1e-6) << step.number; });
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 10);
  EXPECT_LT(*std::max_element(areas.begin(), areas.end()), 300);
}

/// Unequal cells: total forces are near each other from the first, and draw together under refinement.
TEST(LowerBody, ChangesPlacesUnderRefinementWhereCellsDiffer)
{
  double differences[2];
  for (const unsigned int refinements : {0, 1})
  {
    Parameters parameters = on_other_cells(0.3);
    parameters.mesh.refinements = parameters.lower.mesh.refinements = refinements;
    TestScene there(parameters), back(swapped(parameters));
    there.march();
    back.march();
    differences[refinements] = std::abs(there.totals().force[2] / back.totals().force[2] - 1);
  }
  EXPECT_LT(differences[0], 1e-3);
  EXPECT_LT(differences[1], differences[0] / 2);
}

/// A uniform pressure through unequal cells and degrees, on flat surfaces (nu = 0, no friction).
TEST(LowerBody, PassesThePatchTest)
{
  Parameters parameters = small_scene();
  parameters.geometry.shape = BodyShape::box;
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0, 0}};
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  parameters.lower.material.young_modulus = 70000;
  parameters.lower.geometry.sizes[2] = 5;
  parameters.mesh.cells = {{4, 4, 2}};
  parameters.mesh.edge_grading = 0.7;
  parameters.lower.mesh.cells = {{6, 2, 2}};
  parameters.lower.mesh.degree = 2;
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene scene(parameters);
  scene.march();
  const double pressure = 0.1 / (10 / 210000. + 5 / 70000.); // springs in series, MPa
  const auto &nodes = scene.discretization.contact_surface().nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_NEAR(scene.state.force[3 * static_cast<Eigen::Index>(i)] / (pressure * nodes[i].area), 1, 1e-10);
}

/// Forces and moments about the origin, of both bodies, whatever the forces.
TEST(LowerBody, IsInBalanceWithTheOtherOne)
{
  Parameters parameters = with_model(on_other_cells(0.3), ModelKind::full);
  parameters.friction.angle = 30;
  const Scene scene(parameters, choose_model(parameters));
  std::srand(1);
  const NodeVector force = NodeVector::Random(3 * static_cast<Eigen::Index>(scene.surface().nodes.size()));
  const Wrench upper = scene.body().wrench(force);
  const Wrench image = scene.lower()->body().wrench(scene.lower()->own_force(force));
  const double h = parameters.geometry.height, h_lower = parameters.lower.geometry.height;
  constexpr double rounding = 1e-11;
  EXPECT_NEAR(upper[0], -image[0], rounding);
  EXPECT_NEAR(upper[1], -image[1], rounding);
  EXPECT_NEAR(upper[2], image[2], rounding);
  EXPECT_NEAR(upper[3] - h * upper[1], image[3] - h_lower * image[1], 10 * rounding);
  EXPECT_NEAR(upper[4] + h * upper[0], image[4] + h_lower * image[0], 10 * rounding);
  EXPECT_NEAR(upper[5], -image[5], 10 * rounding);
}

TEST(LowerBody, HasASumOfCompliancesThatIsSymmetric)
{
  const Parameters parameters = on_other_cells(0.3);
  const Scene scene(parameters, choose_model(parameters));
  EXPECT_EQ(scene.symmetry().name(), "quarter");
  const Eigen::MatrixXd own = scene.lower()->compliance();
  EXPECT_EQ((own - own.transpose()).lpNorm<Eigen::Infinity>(), 0);
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(own, Eigen::EigenvaluesOnly).eigenvalues()[0],
            -1e-12 * own.lpNorm<Eigen::Infinity>());
  const NodeVector force = NodeVector::LinSpaced(own.rows(), 1, 2);
  EXPECT_LE((scene.given_way(force) - own * force).norm(), 1e-12 * (own * force).norm());
}

TEST(LowerBody, PassesTheChecksOfEveryStep)
{
  TestScene scene(on_other_cells(0.5));
  expect_checked_steps(scene);
}

TEST(LowerBody, MustLieUnderAllOfTheOther)
{
  Parameters parameters = on_body(1);
  parameters.lower.geometry.radius = 9;
  const std::string why = rejection_of([&] { TestScene{parameters}; });
  EXPECT_EQ(why.find("Obstacle/Kind = body: the lower body is under "), 0U) << why;
}
} // namespace orthocone::test
