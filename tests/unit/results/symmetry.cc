// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <set>

namespace orthocone::test
{
namespace
{
Eigen::Vector3d mapped(const Eigen::Matrix2d &map, const Eigen::Vector3d &vector)
{
  Eigen::Vector3d result = vector;
  result.head<2>() = map * vector.head<2>();
  return result;
}

void expect_same_totals(const Totals &a, const Totals &b)
{
  constexpr double height = 10; // mm, the arm of the moments
  EXPECT_LE((a.force - b.force).norm(), closeness * b.force.norm());
  EXPECT_LE((a.moment - b.moment).norm(), closeness * height * b.force.norm());
  EXPECT_NEAR(a.max_slip, b.max_slip, closeness * b.max_slip);
  EXPECT_NEAR(a.max_pressure, b.max_pressure, closeness * b.max_pressure);
  EXPECT_NEAR(a.elastic_energy, b.elastic_energy, closeness * b.elastic_energy);
  EXPECT_NEAR(a.total_dissipation, b.total_dissipation, closeness * b.total_dissipation);
  EXPECT_NEAR(a.stick_area, b.stick_area, closeness * 315);
  EXPECT_EQ(a.n_open, b.n_open);
  EXPECT_EQ(a.n_stick, b.n_stick);
  EXPECT_EQ(a.n_slip, b.n_slip);
}
} // namespace

// Quarter = half = full, in the middle of unloading, for each law and degree.
TEST(Symmetry, ReducedModelsGiveTheAnswersOfTheFullOne)
{
  for (const unsigned int degree : {1, 2})
    for (const std::array<double, 2> p :
         {std::array<double, 2>{{0.3, 0.15}}, std::array<double, 2>{{0.05, 0.2}}})
    {
      Parameters parameters = small_scene(degree);
      parameters.friction.slip_potential = p;
      parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.05, 3)};
      TestScene whole(with_model(parameters, ModelKind::full));
      whole.march();
      for (const ModelKind model : {ModelKind::half, ModelKind::quarter})
      {
        TestScene part(with_model(parameters, model));
        part.march();
        expect_same_fields(part, whole, closeness);
        expect_same_totals(part.totals(), whole.totals());
      }
    }
}

// A box whose cells shrink towards its edges, pressed, partly released, and moved along x.
TEST(Symmetry, ReducedModelsOfABoxGiveTheAnswersOfTheFullOne)
{
  Parameters parameters = small_scene(2);
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{12, 16, 10}};
  parameters.mesh.cells = {{4, 6, 2}};
  parameters.mesh.edge_grading = 0.7;
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.05, 2)};
  for (const bool is_sheared : {false, true})
  {
    if (is_sheared)
      parameters.load.legs.push_back(move_to(0.02, 0, -0.05, 2));
    TestScene whole(with_model(parameters, ModelKind::full));
    whole.march();
    EXPECT_GT(whole.totals().n_slip, 0u);
    for (const ModelKind model : {ModelKind::half, ModelKind::quarter})
      if (model == ModelKind::half || !is_sheared)
      {
        TestScene part(with_model(parameters, model));
        part.march();
        expect_same_fields(part, whole, closeness);
        expect_same_totals(part.totals(), whole.totals());
      }
  }
}

// Nodes that leave the plane count for a share of their step, which must be that of their images in the whole
// body.
TEST(Symmetry, NodesThatLiftOffDissipateAlikeInEveryModel)
{
  for (const unsigned int degree : {1, 2})
  {
    Parameters parameters = small_scene(degree);
    parameters.friction.mu = {{0.4, 0.2}};
    parameters.friction.slip_potential = std::array<double, 2>{{0.3, 0.25}};
    parameters.load.legs = {move_to(0, 0, -0.05, 2), move_to(0.03, 0, -0.05, 3), move_to(0.03, 0, 0.01, 1)};
    TestScene whole(with_model(parameters, ModelKind::full));
    TestScene half(with_model(parameters, ModelKind::half));
    whole.march();
    half.march();
    EXPECT_EQ(whole.totals().n_stick + whole.totals().n_slip, 0u);
    expect_same_totals(half.totals(), whole.totals());
    parameters.load.legs = {move_to(0, 0, -0.05, 2), move_to(0, 0, 0.01, 1)};
    TestScene uncut(with_model(parameters, ModelKind::full));
    TestScene quarter(with_model(parameters, ModelKind::quarter));
    uncut.march();
    quarter.march();
    expect_same_totals(quarter.totals(), uncut.totals());
  }
}

TEST(Symmetry, HalfFollowsATangentialLeg)
{
  for (const bool along_x : {true, false})
  {
    Parameters parameters = small_scene(1);
    const double x = along_x ? 0.01 : 0;
    const double y = along_x ? 0 : 0.01;
    parameters.load.legs = {move_to(0, 0, -0.05, 1), move_to(x, y, -0.05, 2)};
    TestScene whole(with_model(parameters, ModelKind::full));
    TestScene half(with_model(parameters, ModelKind::automatic));
    EXPECT_EQ(half.symmetry.n_copies(), 2u);
    whole.march();
    half.march();
    expect_same_fields(half, whole, closeness);
    expect_same_totals(half.totals(), whole.totals());
    EXPECT_LT(half.totals().force[along_x ? 0 : 1], -1000); // the plane holds the body back
    const Eigen::Vector3d moment = half.totals().moment;    // a half has that about the normal of its plane
    EXPECT_GT((along_x ? 1 : -1) * moment[along_x ? 1 : 0], 1000);
    EXPECT_EQ(moment[along_x ? 0 : 1], 0);
    EXPECT_EQ(moment[2], 0);
  }
}

// Points of the contact files: no place twice, every image of every node, forces that add up to the total.
TEST(Symmetry, EachNodeOfTheWholeBodyIsOnePlace)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const ModelKind kind :
         {ModelKind::full, ModelKind::half, ModelKind::quarter, ModelKind::axisymmetric})
    {
      Parameters parameters = with_model(small_scene(degree), kind);
      if (kind == ModelKind::axisymmetric)
        parameters.friction.mu = {{0.2, 0.2}};
      parameters.load.legs = {move_to(0, 0, -0.1, 1)};
      TestScene scene(parameters);
      scene.march();
      const ContactSurface &surface = scene.discretization.contact_surface();
      const WholeSurface whole = scene.symmetry.whole(surface);
      std::set<std::pair<long, long>> places;
      std::vector<unsigned int> n_images(surface.nodes.size(), 0);
      Eigen::Vector3d force = Eigen::Vector3d::Zero();
      for (const auto &[node, image] : whole.nodes)
      {
        const auto &position = surface.nodes[node].position;
        const Eigen::Vector3d place = mapped(whole.images[image], {position[0], position[1], 0});
        places.emplace(std::lround(1e6 * place[0]), std::lround(1e6 * place[1]));
        ++n_images[node];
        force += mapped(whole.images[image], scene.evaluator.fields(scene.state, node).nodal_force);
      }
      EXPECT_EQ(places.size(), whole.nodes.size());
      for (unsigned int node = 0; node < n_images.size(); ++node)
        EXPECT_EQ(n_images[node], scene.symmetry.n_images(surface, surface.nodes[node]));
      EXPECT_LE((force - scene.totals().force).norm(), 1e-9 * scene.totals().force[2]);
    }
}

// The scene turned by 90 degrees: friction along x and y changed places, fields turned.
TEST(Symmetry, FieldsTurnWithTheScene)
{
  Parameters parameters = small_scene(1);
  parameters.friction.slip_potential = std::array<double, 2>{{0.05, 0.2}};
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.06, 2)};
  TestScene original(parameters);
  original.march();
  Parameters swapped = parameters;
  std::swap(swapped.friction.mu[0], swapped.friction.mu[1]);
  std::swap((*swapped.friction.slip_potential)[0], (*swapped.friction.slip_potential)[1]);
  TestScene exchanged(swapped);
  exchanged.march();
  parameters.friction.angle = 90;
  TestScene turned(parameters);
  turned.march();
  expect_same_fields(turned, exchanged, closeness);
  const auto &nodes = original.discretization.contact_surface().nodes;
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    const int other = node_at(turned, {nodes[i].position[1], nodes[i].position[0], 0});
    ASSERT_GE(other, 0);
    const Eigen::Vector3d a = original.evaluator.fields(original.state, i).slip;
    const Eigen::Vector3d b = turned.evaluator.fields(turned.state, other).slip;
    EXPECT_LE((a - Eigen::Vector3d(b[1], b[0], 0)).norm(), closeness * original.totals().max_slip);
  }
}

TEST(Symmetry, AxesDoNotMatterToIsotropicFriction)
{
  Parameters parameters = small_scene(1);
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.mesh.model = ModelKind::full;
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.06, 2)};
  TestScene straight(parameters);
  straight.march();
  parameters.friction.angle = 37;
  TestScene turned(parameters);
  turned.march();
  expect_same_fields(turned, straight, closeness);
}

// Axes turned by 30 degrees act like a body turned by -30 degrees; the o-grid is not symmetric under that,
// but a turn by 90 degrees of everything is.
TEST(Symmetry, TurnedAxesTurnByRightAngles)
{
  Parameters parameters = small_scene(1);
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  parameters.friction.angle = 30;
  TestScene first(parameters);
  first.march();
  parameters.friction.angle = 120;
  TestScene second(parameters);
  second.march();
  expect_same_totals(first.totals(), second.totals());
  EXPECT_EQ(first.symmetry.n_copies(), 1u);
}
} // namespace orthocone::test
