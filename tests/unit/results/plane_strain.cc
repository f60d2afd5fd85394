// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Scenes in plane strain: a solid slice one cell thick, closed forms, and half models.
#include "results/scenes.h"

#include <orthocone/body/backends/condensed_body.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/results/step_checks.h>
#include <orthocone/scene/half_space_obstacle.h>

#include <algorithm>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;

/// A block 8 x 1.5 x 4 mm on a plane.
Parameters block(const unsigned int degree)
{
  Parameters parameters;
  parameters.geometry.kind = GeometryKind::plane_strain;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{8, 1.5, 4}};
  parameters.mesh.cells = {{6, 1, 3}};
  parameters.mesh.degree = degree;
  parameters.mesh.edge_grading = parameters.mesh.layer_grading = 0.8;
  parameters.friction.mu = {{0.3, 0.15}};
  parameters.contact_solver.tolerance = 1e-12;
  parameters.load.legs = {move_to(0, 0, -0.02, 1), move_to(0.01, 0, -0.02, 2)};
  return parameters;
}

/// W of the solid slice of the same cells between y = 0 and the thickness, where u_y is held: that of lines
/// along y, which move alike under forces that are spread evenly.
MatrixXd compliance_of_slice(const Parameters &parameters, const ContactSurface &lines)
{
  dealii::Triangulation<3> mesh;
  make_shape(parameters.geometry, parameters.mesh)->make_solid({}, mesh);
  const double side = parameters.geometry.sizes[1] / 2;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && std::abs(std::abs(face->center()[1]) - side) < 1e-12)
      face->set_boundary_id(Boundary::plane_normal_to_y);
  const Discretization space(mesh, parameters.mesh, parameters.geometry.top_face);
  const Stiffness stiffness(space, Materials(Material(parameters.material)));
  const StiffnessFactor factor(stiffness.matrix(), space.n_interior());
  const CondensedBody body(space, factor, LocalAxes(0.));
  const auto &nodes = space.contact_surface().nodes;
  const auto n = static_cast<Index>(lines.nodes.size());
  MatrixXd spread = MatrixXd::Zero(3 * static_cast<Index>(nodes.size()), 3 * n);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const auto line = std::find_if(lines.nodes.begin(), lines.nodes.end(),
                                   [&](const ContactNode &of)
                                   { return std::abs(of.position[0] - nodes[i].position[0]) < 1e-10; });
    spread.block<3, 3>(3 * static_cast<Index>(i), 3 * (line - lines.nodes.begin())) =
        nodes[i].area / line->area * Eigen::Matrix3d::Identity();
  }
  return spread.transpose() * *body.compliance().dense() * spread;
}

/// The forces after one step from rest to q, N.
Eigen::VectorXd solved(const Compliance &compliance, const FrictionLaw &law, const NodeVector &q)
{
  const ContactSystem system(compliance, FrictionLaws(compliance.n_nodes(), law));
  ContactSolverOptions options;
  options.tolerance = 1e-13;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(q.size());
  EXPECT_TRUE(make_contact_solver(system, options)->solve(ContactStep(system, q), forces).converged);
  return forces;
}
} // namespace

// Pressed and pushed by one step, so that nodes stick, slip and open.
TEST(PlaneStrain, HasTheForcesOfASolidSlice)
{
  for (const unsigned int degree : {1, 2, 3})
  {
    const Parameters parameters = block(degree);
    const TestScene scene(parameters);
    ASSERT_EQ(scene.symmetry.full_name(), "plane strain, full");
    MatrixXd slice = compliance_of_slice(parameters, scene.discretization.contact_surface());
    const MatrixXd section = *scene.scene.compliance().dense();
    for (Index i = 1; i < slice.rows(); ++i)
      if (i % 3 == 2) // u_y is held, with a compliance of its own
      {
        slice.row(i) = section.row(i);
        slice.col(i) = section.col(i);
      }
    EXPECT_LE((slice - section).norm(), 1e-10 * section.norm());
    const NodeVector q = scene.condensed.moved_with(moved_by(0.01, 0, -0.02));
    const OrthotropicFriction law{0.3, 0.15, 0.3, 0.15};
    const Eigen::VectorXd one = solved(DenseCompliance(slice), law, q),
                          other = solved(DenseCompliance(section), law, q);
    EXPECT_GT(other.norm(), 1);
    EXPECT_LE((one - other).norm(), 1e-10 * other.norm());
  }
}

// A block without lateral contraction that sticks is sheared evenly, by motions along x and y: G u / H.
TEST(PlaneStrain, IsShearedAlongItsThirdDirection)
{
  for (const unsigned int degree : {1, 2, 4})
  {
    Parameters parameters = block(degree);
    parameters.friction.mu = {{9, 9}};
    parameters.material.poisson_ratio = 0;
    parameters.load.legs = {move_to(0, 0, -0.02, 1), move_to(0, 0.03, -0.02, 1)};
    TestScene scene(parameters);
    ASSERT_EQ(scene.symmetry.full_name(), "plane strain, half, with u_y");
    expect_checked_steps(scene);
    const double force = parameters.material.young_modulus / 2 * 0.03 / 4 * 8 * 1.5;
    EXPECT_NEAR(scene.totals().force[1], -force, 1e-9 * force);
    EXPECT_NEAR(scene.totals().force[2], parameters.material.young_modulus * 0.02 / 4 * 8 * 1.5,
                1e-9 * force);
    EXPECT_NEAR(scene.scene.held_wrench(scene.state.force, scene.state.motion)[1], force, 1e-9 * force);
  }
}

TEST(PlaneStrain, HalfModelsGiveTheAnswersOfTheFullOne)
{
  for (const unsigned int degree : {1, 2})
    for (const bool pulls_along_y : {false, true})
    {
      Parameters parameters = block(degree);
      parameters.load.legs = {move_to(0, 0, -0.02, 2), move_to(0, pulls_along_y ? 0.01 : 0, -0.015, 3)};
      TestScene half(parameters), whole(with_model(parameters, ModelKind::full));
      EXPECT_EQ(half.symmetry.name(), "half");
      EXPECT_EQ(half.symmetry.has_third(), pulls_along_y);
      expect_checked_steps(half);
      expect_checked_steps(whole);
      expect_same_fields(half, whole, closeness);
      EXPECT_NEAR(half.totals().elastic_energy / whole.totals().elastic_energy, 1, closeness);
      EXPECT_NEAR(half.totals().stick_area, whole.totals().stick_area, closeness * 8 * 1.5);
      EXPECT_EQ(half.totals().n_slip + half.totals().n_stick, whole.totals().n_slip + whole.totals().n_stick);
    }
}

// Two equal blocks, of which one is the mirror image of the other, are twice as soft as one on a rigid plane.
TEST(PlaneStrain, MeetsALowerBody)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const double y : {0., 0.01})
    {
      Parameters parameters = block(degree);
      parameters.friction.mu = {{0, 0}};
      parameters.load.legs = {move_to(0, y, -0.02, 1)};
      TestScene single(parameters);
      single.march();
      parameters.obstacle.kind = ObstacleKind::body;
      parameters.lower.geometry = parameters.geometry;
      parameters.lower.mesh = parameters.mesh;
      parameters.lower.material = parameters.material;
      TestScene pair(parameters);
      expect_checked_steps(pair);
      EXPECT_NEAR(2 * pair.totals().force[2] / single.totals().force[2], 1, 1e-9);
      parameters.lower.mesh.cells = {{10, 1, 3}}; // faces that do not match
      TestScene uneven(parameters);
      expect_checked_steps(uneven);
      EXPECT_NEAR(2 * uneven.totals().force[2] / single.totals().force[2], 1, 5e-3);
    }
}

// A stiff block with the profile of a cylinder on a half-plane: half width a = 2 sqrt(P' R / (pi E*)), and
// the largest pressure 2 P' / (pi a).
TEST(PlaneStrain, MeetsAHalfPlaneAsHertzSays)
{
  constexpr double modulus = 70000, nu = 0.3, radius = 50, force = 300; // N/mm
  Parameters parameters = block(2);
  parameters.mesh.cells = {{80, 1, 2}};
  parameters.mesh.edge_grading = 1.02;
  parameters.material.young_modulus = 1e12;
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0, 0}};
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = {modulus, nu};
  parameters.obstacle.gap = "x^2/100";
  Leg press;
  press.targets[2] = Drive{true, -force * 1.5};
  parameters.load.legs = {press};
  TestScene scene(parameters);
  expect_checked_steps(scene);
  const double a = 2 * std::sqrt(force * radius * (1 - nu * nu) / (3.14159265358979 * modulus));
  EXPECT_NEAR(scene.totals().max_pressure / (2 * force / (3.14159265358979 * a)), 1, 0.01);
  EXPECT_NEAR(scene.totals().contact_area / (2 * a * 1.5), 1, 0.03);
  parameters.load.legs = {move_to(0, 0, -0.01, 1)};
  EXPECT_THROW(choose_model(parameters), InputError);
}

// Axes of friction at an angle push the block out of the plane, and only then it has a third component.
TEST(PlaneStrain, MovesOutOfThePlaneWhereFrictionAsksForIt)
{
  Parameters parameters = block(1);
  EXPECT_FALSE(choose_model(parameters).symmetry.has_third());
  parameters.friction.angle = 90;
  EXPECT_FALSE(choose_model(parameters).symmetry.has_third());
  parameters.friction.angle = 40;
  const ModelChoice choice = choose_model(parameters);
  EXPECT_TRUE(choice.symmetry.has_third());
  EXPECT_NE(choice.reason.find("u_y is modelled because Friction/Orthotropy angle = 40"), std::string::npos)
      << choice.reason;
  TestScene scene(parameters);
  expect_checked_steps(scene);
  EXPECT_GT(std::abs(scene.totals().force[1]), 5e-3 * scene.totals().force[2]);
}

// The strip that output draws is as wide as the body is thick, and has the total force.
TEST(PlaneStrain, TheWholeSurfaceIsTheStripWithTheTotalForce)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const ModelKind model : {ModelKind::full, ModelKind::automatic})
    {
      Parameters parameters = with_model(block(degree), model);
      parameters.load.legs = {move_to(0, 0, -0.02, 1)};
      TestScene scene(parameters);
      scene.march();
      const ContactSurface &surface = scene.discretization.contact_surface();
      const WholeSurface whole = scene.symmetry.whole(surface);
      EXPECT_EQ(whole.faces.size(), 6);
      Eigen::Vector2d lowest(9, 9), highest(-9, -9);
      double force = 0;
      for (const WholeSurface::Node &node : whole.nodes)
      {
        const Eigen::Vector2d place = whole.place(node, surface.nodes[node.node].position);
        lowest = lowest.cwiseMin(place);
        highest = highest.cwiseMax(place);
        force += scene.evaluator.fields(scene.state, node.node).nodal_force[2];
      }
      EXPECT_LE((highest - Eigen::Vector2d(4, 0.75)).norm() + (lowest + Eigen::Vector2d(4, 0.75)).norm(),
                1e-12);
      EXPECT_NEAR(force / scene.totals().force[2], 1, 1e-12);
      for (const auto &face : whole.faces)
      {
        const auto at = [&](const unsigned int i)
        { return whole.place(whole.nodes[face[i]], surface.nodes[whole.nodes[face[i]].node].position); };
        EXPECT_LT(at(0)[0], at(degree)[0]);
        EXPECT_LT(at(0)[1], at(static_cast<unsigned int>(face.size()) - 1)[1]);
      }
    }
}
} // namespace orthocone::test
