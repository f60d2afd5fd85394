// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/line_fields.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
using Eigen::Vector3d;

Line line(const std::array<double, 3> &from, const std::array<double, 3> &to, const unsigned int n)
{
  return {"L", from, to, n};
}

std::vector<LinePoint> along(const Line &line, const TestScene &scene)
{
  const LineFields fields(line, scene.evaluator);
  const Parameters &parameters = scene.parameters;
  const ContactState &state = scene.state;
  const Deformation upper{scene.condensed.with_motion(
                              state.motion, scene.condensed.elastic_displacement(state.force), state.loads),
                          free_strain(parameters.load.loads, state.loads, false, parameters.material)};
  Deformation lower;
  if (fields.is_in_lower())
  {
    const ElasticBody &body = scene.scene.lower()->body();
    lower.displacement = body.with_motion(
        {}, body.elastic_displacement(scene.scene.lower()->own_force(state.force)), state.loads);
  }
  return fields.at(scene.evaluator.all_fields(state), upper, lower);
}

double largest_stress(const std::vector<LinePoint> &points)
{
  double largest = 0;
  for (const LinePoint &point : points)
    largest = std::max(largest, point.body.stress.norm());
  return largest;
}

void expect_same(const LinePoint &a, const LinePoint &b, const double stress, const double bound)
{
  constexpr double depth = 0.1; // mm, by which the body is pressed
  EXPECT_LE((a.body.place - b.body.place).norm(), 1e-12);
  EXPECT_LE((a.body.displacement - b.body.displacement).norm(), bound * depth);
  EXPECT_LE((a.body.stress - b.body.stress).norm(), bound * stress);
  ASSERT_EQ(a.contact.has_value(), b.contact.has_value());
  if (!a.contact)
    return;
  EXPECT_NEAR(a.contact->pressure, b.contact->pressure, bound * stress);
  EXPECT_LE((a.contact->friction_traction - b.contact->friction_traction).norm(), bound * stress);
  EXPECT_LE((a.contact->slip - b.contact->slip).norm(), bound * depth);
  EXPECT_EQ(a.contact->status, b.contact->status);
}

/// Lines on planes of symmetry, across them, and in the part that no reduced model has.
const std::array<Line, 4> through_the_body{{{"A", {{0, 0, 0}}, {{0, 0, 10}}, 21},
                                            {"B", {{-10, 0, 0}}, {{10, 0, 0}}, 41},
                                            {"C", {{-6, -7, 0}}, {{5, 3, 9}}, 37},
                                            {"D", {{-3, 6, 2}}, {{-3, -6, 2}}, 25}}};
} // namespace

// Half and quarter models give what the full one does, whose mesh is symmetric.
TEST(LineFields, OfReducedModelsAreThoseOfTheFullOne)
{
  for (const unsigned int degree : {1, 2})
  {
    Parameters parameters = small_scene(degree);
    parameters.load.legs = {move_to(0, 0, -0.1, 1), move_to(0, 0, -0.05, 2)};
    TestScene whole(with_model(parameters, ModelKind::full));
    whole.march();
    for (const ModelKind model : {ModelKind::half, ModelKind::quarter})
    {
      TestScene part(with_model(parameters, model));
      part.march();
      for (const Line &one : through_the_body)
      {
        const auto of_whole = along(one, whole), of_part = along(one, part);
        ASSERT_EQ(of_whole.size(), of_part.size());
        for (std::size_t i = 0; i < of_whole.size(); ++i)
          expect_same(of_part[i], of_whole[i], largest_stress(of_whole), closeness);
      }
    }
  }
}

// Points on one ring of a revolved body have fields that are turned with it.
TEST(LineFields, OfARevolvedBodyTurnAboutTheAxis)
{
  Parameters parameters = small_scene(2);
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene scene(parameters);
  ASSERT_TRUE(scene.symmetry.is_axisymmetric());
  scene.march();
  const auto on_x = along(line({{0, 0, 0}}, {{8, 0, 4}}, 9), scene);
  const auto turned = along(line({{0, 0, 0}}, {{-4.8, 6.4, 4}}, 9), scene);
  Eigen::Matrix3d turn;
  turn << -0.6, -0.8, 0, 0.8, -0.6, 0, 0, 0, 1;
  for (std::size_t i = 0; i < on_x.size(); ++i)
  {
    EXPECT_LE((turned[i].body.displacement - turn * on_x[i].body.displacement).norm(), 1e-12);
    Eigen::Matrix3d stress;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        stress(a, b) = on_x[i].body.stress[a][b];
    const Eigen::Matrix3d expected = turn * stress * turn.transpose();
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        EXPECT_NEAR(turned[i].body.stress[a][b], expected(a, b), 1e-10 * largest_stress(on_x));
  }
  EXPECT_EQ(on_x[0].body.stress[0][0], on_x[0].body.stress[1][1]) << "no direction is special on the axis";
  EXPECT_EQ(on_x[0].body.stress[0][2], 0);
}

// Uniform pressure: the section has it to rounding, and so has the solid, whose mesh is another one.
TEST(LineFields, OfARevolvedBodyAreThoseOfTheSolid)
{
  Parameters parameters = small_scene(2);
  parameters.geometry.top_face = TopFace::guided;
  parameters.friction.mu = {{1e-11, 1e-11}};
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene section(parameters), solid(with_model(parameters, ModelKind::quarter));
  ASSERT_TRUE(section.symmetry.is_axisymmetric());
  ASSERT_FALSE(solid.symmetry.is_axisymmetric());
  section.march();
  solid.march();
  for (const Line &one : {line({{-6, -7, 1}}, {{5, 3, 9}}, 37), line({{0, 0, 1}}, {{0, 0, 10}}, 10)})
  {
    const auto turned = along(one, section), whole = along(one, solid);
    for (std::size_t i = 0; i < whole.size(); ++i)
      expect_same(turned[i], whole[i], largest_stress(whole), 1e-10);
  }
}

namespace
{
constexpr double radius_of_contact = 0.5, p0 = 734.56; // mm, MPa: prm/verification/hertz.prm

Parameters hertz()
{
  Parameters parameters;
  parameters.geometry.height = 20;
  parameters.mesh.core_cells = 40;
  parameters.mesh.core_ratio = 0.1;
  parameters.mesh.rings = 16;
  parameters.mesh.rim_grading = 1.25;
  parameters.mesh.layers = 24;
  parameters.mesh.layer_grading = 0.69;
  parameters.friction.mu = {{0, 0}};
  parameters.obstacle.gap = "(x^2+y^2)/(2*100)";
  Leg leg;
  leg.targets[2] = Drive{true, -384.615};
  leg.steps = 1;
  parameters.load.legs = {leg};
  return parameters;
}
} // namespace

// Johnson, Contact Mechanics, section 3.4: stress along the axis below the contact. The largest shear for a
// Poisson ratio of 0.3 is 0.310 p0 at 0.481 a.
TEST(LineFields, BelowHertzsContactAreThoseOfTheHalfSpace)
{
  TestScene scene(hertz());
  scene.march();
  const double nu = scene.parameters.material.poisson_ratio, a = radius_of_contact;
  double largest = 0, depth = 0;
  for (const LinePoint &point : along(line({{0, 0, 0}}, {{0, 0, 3 * a}}, 301), scene))
  {
    const double z = point.distance / a, fall = 1 / (1 + z * z);
    const double radial = -(1 + nu) * (1 - z * std::atan2(1, z)) + fall / 2;
    EXPECT_NEAR(point.body.stress[2][2] / p0, -fall, 0.02) << z;
    EXPECT_NEAR(point.body.stress[0][0] / p0, radial, 0.02) << z;
    const double shear = (point.body.stress[0][0] - point.body.stress[2][2]) / 2;
    if (shear > largest)
    {
      largest = shear;
      depth = z;
    }
  }
  EXPECT_NEAR(largest / p0, 0.310, 0.005);
  EXPECT_NEAR(depth, 0.481, 0.03);
}

TEST(LineFields, OnHertzsContactHaveItsPressure)
{
  TestScene scene(hertz());
  scene.march();
  for (const LinePoint &point : along(line({{-1, 0, 0}}, {{1, 0, 0}}, 81), scene))
  {
    ASSERT_TRUE(point.contact.has_value());
    const double r = std::abs(point.body.place[0]) / radius_of_contact;
    EXPECT_NEAR(point.contact->pressure / p0, std::sqrt(std::max(0., 1 - r * r)),
                r > 0.9 && r < 1.1 ? 0.2 : 0.02)
        << r;
    EXPECT_EQ(point.contact->status == NodeStatus::open, r > 1.02 || point.contact->pressure == 0) << r;
  }
}

// A body on its own mirror image: what one does, the other does, too.
TEST(LineFields, OfEqualBodiesAreMirrored)
{
  Parameters parameters = small_scene(2);
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  TestScene scene(parameters);
  scene.march();
  const auto points = along(line({{-5, 2, -9}}, {{-5, 2, 9}}, 37), scene);
  const Vector3d middle(0, 0, -0.05); // mm: each body gives way by half
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const LinePoint &here = points[i], &there = points[points.size() - 1 - i];
    EXPECT_EQ(here.contact.has_value(), here.body.place[2] == 0);
    const Vector3d u = here.body.displacement - middle, v = there.body.displacement - middle;
    if (here.body.place[2] == 0)
      continue; // the line shows the surface of the upper body
    EXPECT_LE((u - Vector3d(v[0], v[1], -v[2])).norm(), closeness * 0.1);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(here.body.stress[d][d], there.body.stress[d][d], closeness * largest_stress(points));
    EXPECT_NEAR(here.body.stress[0][2], -there.body.stress[0][2], closeness * largest_stress(points));
  }
}

// In plane strain nothing changes along y, and y ends where the body does.
TEST(LineFields, OfPlaneStrainAreTheSameAlongY)
{
  Parameters parameters;
  parameters.geometry.kind = GeometryKind::plane_strain;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{8, 1.5, 4}};
  parameters.mesh.cells = {{6, 1, 3}};
  parameters.mesh.volumetric_quadrature = VolumetricQuadrature::full; // Hooke's law holds at every point
  parameters.load.legs = {move_to(0, 0, -0.02, 1)};
  TestScene scene(parameters);
  scene.march();
  const auto points = along(line({{-2, -0.75, 1}}, {{-2, 0.75, 1}}, 7), scene);
  for (const LinePoint &point : points)
    EXPECT_EQ((point.body.stress - points[0].body.stress).norm(), 0);
  EXPECT_NEAR(points[0].body.stress[1][1],
              parameters.material.poisson_ratio * (points[0].body.stress[0][0] + points[0].body.stress[2][2]),
              1e-10 * points[0].body.stress.norm());
  EXPECT_EQ(
      rejection_of(
          [&] {
            along(line({{0, 0, 1}}, {{0, 0.8, 1}}, 2), scene);
          }),
      "Output/Lines: point 2 of 2 of 'L' at (0, 0.8, 1) lies in no body: allowed are points of the body "
      "(box, 8 x 1.5 x 4 mm), whose contact surface is at z = 0 and whose other points are above it; y "
      "from -0.75 to 0.75 mm");
}

TEST(LineFields, LeaveNoBody)
{
  const TestScene scene(small_scene());
  EXPECT_EQ(
      rejection_of(
          [&] {
            along(line({{0, 0, 0}}, {{0, 0, -1}}, 3), scene);
          }),
      "Output/Lines: point 2 of 3 of 'L' at (0, 0, -0.5) lies in no body: allowed are points of the body "
      "(cylinder, radius 10 mm, height 10 mm), whose contact surface is at z = 0 and whose other points are "
      "above it");
}
} // namespace orthocone::test
