// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <Eigen/Sparse>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector2d;

namespace
{
Parameters loaded_in(const unsigned int n_steps, const std::array<double, 2> &p)
{
  Parameters parameters = small_scene(1);
  parameters.friction.slip_potential = p;
  parameters.load.legs = {move_to(0, 0, -0.1, n_steps)};
  return parameters;
}

void expect_uniform_pressure(const TestScene &scene, const double closeness = 1e-6)
{
  const Parameters &parameters = scene.parameters;
  const double pressure = parameters.material.young_modulus * 0.1 / parameters.geometry.height;
  for (const ContactFields &fields : scene.evaluator.all_fields(scene.state))
    EXPECT_NEAR(fields.pressure, pressure, closeness * pressure);
}
} // namespace

TEST(Physics, PressureIsUniformWithoutFriction)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    Parameters parameters = small_scene(degree);
    parameters.mesh.rim_grading = 0.6;
    parameters.mesh.layer_grading = 0.7;
    parameters.load.legs = {move_to(0, 0, -0.1, 1)};
    parameters.friction.mu = {{1e-9, 1e-9}};
    parameters.geometry.top_face = TopFace::guided;
    TestScene guided(parameters);
    guided.march();
    expect_uniform_pressure(guided);
    parameters.geometry.top_face = TopFace::clamped;
    parameters.material.poisson_ratio = 0; // nothing wants to slip
    parameters.friction.mu = {{0.3, 0.1}};
    TestScene clamped(parameters);
    clamped.march();
    expect_uniform_pressure(clamped);
  }
}

/// Where curved cells of two sizes meet, their faces are not quite the same: 2e-6 of the pressure here.
/// Cells with straight edges are exact (test HangingNodes.LeaveAConstantStressConstant).
TEST(Physics, PressureIsNearlyUniformBesideCurvedCellsOfTwoSizes)
{
  using Rounds = std::vector<std::vector<CellRange>>;
  for (const auto &[degree, rounds] :
       {std::pair{2U, Rounds{{{1, 2}, {5, 5}}}}, {3U, Rounds{{{2, 4}}, {{7, 9}}}}})
  {
    Parameters parameters = small_scene(degree);
    parameters.mesh.refined_cells = rounds;
    parameters.mesh.model = ModelKind::quarter;
    parameters.load.legs = {move_to(0, 0, -0.1, 1)};
    parameters.friction.mu = {{1e-9, 1e-9}};
    parameters.geometry.top_face = TopFace::guided;
    TestScene guided(parameters);
    guided.march();
    ASSERT_FALSE(guided.evaluator.surface().hanging.empty());
    expect_uniform_pressure(guided, 1e-5);
  }
}

// A body that sticks everywhere is the body clamped at its base: forces from a linear solve of its own, with
// the displacement of all contact nodes prescribed (Dirichlet), by Eigen's sparse Cholesky.
TEST(Physics, StickingEverywhereIsClampedAtTheBase)
{
  Parameters parameters = small_scene(2);
  parameters.friction.mu = {{50, 30}};
  parameters.load.legs = {move_to(0.01, 0.02, -0.1, 2)};
  TestScene scene(parameters);
  scene.march();
  EXPECT_EQ(scene.totals().n_stick, scene.state.n_nodes());
  const Stiffness stiffness = scene.scene.body().mesh().stiffness(parameters.material);
  const auto n_interior = static_cast<Index>(scene.discretization.n_interior());
  const auto n_free = static_cast<Index>(scene.discretization.n_free());
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < n_free; ++row)
    for (auto entry = stiffness.matrix().begin(row); entry != stiffness.matrix().end(row); ++entry)
    {
      const auto column = static_cast<Index>(entry->column());
      entries.emplace_back(row, column, entry->value());
      if (column != row)
        entries.emplace_back(column, row, entry->value());
    }
  Eigen::SparseMatrix<double> k(n_free, n_free);
  k.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd v = Eigen::VectorXd::Zero(n_free); // displacement less the rigid motion with the top
  const auto &nodes = scene.discretization.contact_surface().nodes;
  for (const ContactNode &node : nodes)
    for (unsigned int d = 0; d < 3; ++d)
      v[node.dofs[d]] = -scene.state.motion[d];
  const Eigen::VectorXd load = -(k * v);
  const Eigen::SparseMatrix<double> interior = k.topLeftCorner(n_interior, n_interior);
  v.head(n_interior) =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(interior).solve(load.head(n_interior));
  const Eigen::VectorXd reaction = k * v;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(scene.state.force[3 * static_cast<Index>(i) + (d + 1) % 3], reaction[nodes[i].dofs[d]],
                  closeness * scene.state.force.lpNorm<Eigen::Infinity>());
}

TEST(Physics, MonotoneLoadingIsProportional)
{
  for (const auto &p : slip_ellipses)
  {
    TestScene once(loaded_in(1, p));
    once.march();
    for (const unsigned int n_steps : {5, 50})
    {
      TestScene often(loaded_in(n_steps, p));
      often.march();
      expect_same_fields(often, once, closeness);
    }
  }
}

TEST(Physics, ScalesWithDisplacementAndModulus)
{
  constexpr double factor = 3;
  Parameters parameters = small_scene(1);
  parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.06, 2)};
  TestScene scene(parameters);
  scene.march();
  Parameters farther = parameters;
  for (Leg &leg : farther.load.legs)
    leg.targets[2]->value *= factor;
  TestScene pushed(farther);
  pushed.march();
  Parameters stiffer = parameters;
  stiffer.material.young_modulus *= factor;
  TestScene stiff(stiffer);
  stiff.march();
  const double size = scene.state.force.norm();
  EXPECT_LE((pushed.state.force - factor * scene.state.force).norm(), closeness * size);
  EXPECT_LE((stiff.state.force - factor * scene.state.force).norm(), closeness * size);
  EXPECT_LE((pushed.state.displacement - factor * scene.state.displacement).norm(),
            closeness * scene.state.displacement.norm());
  EXPECT_LE((stiff.state.displacement - scene.state.displacement).norm(),
            closeness * scene.state.displacement.norm());
}

// The whole body in steady gross sliding: every node follows the top, and the resultant is the slip rule's.
TEST(Physics, GrossSlidingHasTheResultantOfTheSlipRule)
{
  for (const auto &p : std::vector<std::array<double, 2>>{{{0.8, 0.4}}, {{1, 1}}})
  {
    Parameters parameters = small_scene(1);
    parameters.friction.mu = {{0.8, 0.4}};
    parameters.friction.slip_potential = p;
    parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(1, 1, -0.01, 20)};
    TestScene scene(parameters);
    scene.march();
    const Eigen::Vector3d force = scene.totals().force;
    const Vector2d expected = scene.scene.system().law(0).force_against({std::sqrt(0.5), std::sqrt(0.5)});
    EXPECT_EQ(scene.totals().n_stick, 0u);
    EXPECT_LE((force.head<2>() / force[2] - expected).norm(), 1e-9);
  }
}
} // namespace orthocone::test
