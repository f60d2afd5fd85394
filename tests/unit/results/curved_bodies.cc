// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Two elastic bodies with normals of their own: shafts in hubs of other cells.
#include "body/curved_msh.h"
#include "folder_of_files.h"
#include "rejection.h"
#include "results/scenes.h"

#include <orthocone/results/motion_checks.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/parameters.h>

#include <deal.II/grid/grid_generator.h>

namespace orthocone::test
{
namespace
{
using Eigen::Vector3d;

constexpr double seat = 10, rim = 15, hole = 5, seat_length = 6, overlap = 0.01; // radii, mm

/// A part of a ring in the plane (x, z), from the axis z on: "base" is its inner edge and "top" its outer
/// one; "x0" is the edge in x = 0, and "side" the other end.
std::string ring_section(const unsigned int cells, const double inner, const double outer,
                         const Hexahedra type, const double angle)
{
  return mapped_square({{cells, 3}}, type,
                       [=](const double u, const double w) -> std::array<double, 2>
                       {
                         const double r = inner + w * (outer - inner);
                         return {{r * std::sin(u * angle), r * std::cos(u * angle)}};
                       });
}

CurvedSurface cylinder_about(const Vector3d &axis, const std::string &name)
{
  return {name, SurfaceKind::cylinder, {}, {{axis[0], axis[1], axis[2]}}};
}

void add_interference(Parameters &parameters)
{
  Load fit;
  EXPECT_EQ(parse_load("fit: interference", fit), "");
  parameters.load.loads = {fit};
  Leg assembled;
  assembled.loads = {{"fit", 1}};
  parameters.load.legs = {assembled};
}

/// The scene of two bodies from files in plane strain, the hub above. `is_named`: their edges are cylinders.
Parameters hub_and_shaft(const std::string &hub, const std::string &shaft, const bool is_named)
{
  Parameters parameters;
  parameters.geometry = imported(hub, {"x0"});
  parameters.geometry.kind = GeometryKind::plane_strain;
  parameters.geometry.thickness = seat_length;
  parameters.lower.geometry = BodyOptions::lower().geometry;
  parameters.lower.geometry.shape = BodyShape::file;
  parameters.lower.geometry.mesh_file = shaft;
  parameters.lower.geometry.contact_surfaces = {"top"};
  parameters.lower.geometry.symmetry_surfaces = {"x0"};
  for (GeometryOptions *const geometry : {&parameters.geometry, &parameters.lower.geometry})
    if (is_named)
      geometry->curved_surfaces = {cylinder_about(Vector3d::UnitY(), "base"),
                                   cylinder_about(Vector3d::UnitY(), "top")};
  parameters.mesh.degree = parameters.lower.mesh.degree = 2;
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.obstacle.normal = ObstacleNormal::surface;
  parameters.obstacle.gap = to_text(-overlap);
  parameters.contact_solver.tolerance = 1e-12;
  add_interference(parameters);
  return parameters;
}

/// Quarters of ring and shaft that only their seats and their planes of symmetry hold.
Parameters quarters(const Folder &folder, const unsigned int of_hub, const unsigned int of_shaft,
                    const Hexahedra type, const bool is_named)
{
  const std::string number = std::to_string(of_hub) + "-" + std::to_string(of_shaft) + ".msh";
  Parameters parameters = hub_and_shaft(
      folder.write("hub" + number, ring_section(of_hub, seat, rim, type, pi / 2)),
      folder.write("shaft" + number, ring_section(of_shaft, hole, seat, type, pi / 2)), is_named);
  for (GeometryOptions *const geometry : {&parameters.geometry, &parameters.lower.geometry})
  {
    geometry->supports = {{"side", {{false, false, true}}}};
    geometry->top_face = TopFace::free;
  }
  parameters.lower.geometry.held_surface.clear();
  share_among_bodies(parameters);
  return parameters;
}

/// Lame's pressure of free rings in plane strain, with E' = E / (1 - nu^2) and nu' = nu / (1 - nu).
double pressure_of_free_rings(const Parameters &parameters)
{
  const auto compliance = [](const MaterialOptions &material, const double other, const double sign)
  {
    const double nu = material.poisson_ratio, a2 = seat * seat, b2 = other * other;
    return (1 - nu * nu) / material.young_modulus * (sign * (b2 + a2) / (b2 - a2) + sign * nu / (1 - nu)) *
           seat;
  };
  return overlap /
         (compliance(parameters.material, rim, 1) + compliance(parameters.lower.material, hole, -1));
}

/// Sum of the normal forces on the whole seat, N.
double seat_force(const TestScene &scene)
{
  return scene.symmetry.n_copies() * scene.state.force(Eigen::seq(0, Eigen::last, 3)).sum();
}

/// The largest departure of the pressures of contact nodes from a value, relative.
double departure(const TestScene &scene, const double expected)
{
  double largest = 0;
  for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    largest = std::max(largest, std::abs(scene.evaluator.fields(scene.state, node).pressure / expected - 1));
  return largest;
}
} // namespace

// Named surfaces: cells of one body need not match those of the other one.
TEST(CurvedBodies, HaveLamesPressureOnUnequalCells)
{
  const Folder folder;
  Parameters parameters = quarters(folder, 12, 9, Hexahedra::of_8_nodes, true);
  parameters.lower.material.young_modulus = 70000;
  parameters.lower.material.poisson_ratio = 0.33;
  TestScene scene(parameters);
  expect_checked_steps(scene);
  EXPECT_LE(departure(scene, pressure_of_free_rings(parameters)), 1e-3);
  EXPECT_NEAR(scene.totals().contact_area, pi / 2 * seat * seat_length * 2, 1e-4 * 100 * pi);
}

// Without names the distance is that of the cells: quadratic ones of both bodies miss the seat by different
// lengths, which becomes a pressure between neighbours. It falls with the cells; matching cells have none.
TEST(CurvedBodies, HaveAPressureThatIsEvenToTheOrderOfTheirCells)
{
  const Folder folder;
  std::vector<double> unnamed, named;
  for (const bool is_named : {false, true})
    for (const unsigned int n : {1, 2})
    {
      TestScene scene(quarters(folder, 12 * n, 9 * n, Hexahedra::of_27_nodes, is_named));
      scene.march();
      (is_named ? named : unnamed).push_back(departure(scene, pressure_of_free_rings(scene.parameters)));
    }
  RecordProperty("unnamed", to_text(unnamed[0]) + " " + to_text(unnamed[1]));
  RecordProperty("named", to_text(named[0]) + " " + to_text(named[1]));
  EXPECT_LE(unnamed[1], unnamed[0] / 4);
  EXPECT_LE(named[1], named[0] / 2);
  EXPECT_LE(named[0], unnamed[0] / 100);
  TestScene matching(quarters(folder, 8, 8, Hexahedra::of_27_nodes, false));
  matching.march();
  EXPECT_LE(departure(matching, pressure_of_free_rings(matching.parameters)), 5e-4);
}

namespace
{
/// Halves of ring and shaft, held at the rim and in the hole. The ring is moved along z after the fit.
Parameters halves(const Folder &folder)
{
  Parameters parameters = hub_and_shaft(
      folder.write("half_hub.msh", ring_section(12, seat, rim, Hexahedra::of_8_nodes, pi)),
      folder.write("half_shaft.msh", ring_section(12, hole, seat, Hexahedra::of_8_nodes, pi)), true);
  parameters.geometry.symmetry_surfaces = parameters.lower.geometry.symmetry_surfaces = {"x0", "side"};
  parameters.lower.geometry.held_surface = "base";
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.load.legs.push_back(move_to(0, 0, -0.012, 3));
  share_among_bodies(parameters);
  return parameters;
}
} // namespace

// Nothing but the shaft holds the ring, and no force acts on its rim: it is not taken for one that is let go.
TEST(CurvedBodies, HoldARingThatIsFree)
{
  const Folder folder;
  Parameters parameters = halves(folder);
  parameters.load.legs.pop_back();
  parameters.geometry.top_face = TopFace::free;
  TestScene free(parameters);
  expect_checked_steps(free);
  const double pressure = free.evaluator.fields(free.state, 0).pressure;
  EXPECT_GT(pressure, 1);
  EXPECT_LE(departure(free, pressure), 1e-2);
  parameters.geometry.top_face = TopFace::clamped;
  Leg let_go;
  let_go.targets[2] = Drive{true, 0};
  parameters.load.legs.push_back(let_go);
  TestScene driven(parameters);
  expect_checked_steps(driven);
  EXPECT_LE(std::abs(driven.totals().force[2]), 1e-8 * driven.state.force.lpNorm<1>());
  EXPECT_GT(driven.totals().contact_area, 1);
}

TEST(CurvedBodies, ChangePlaces)
{
  const Folder folder;
  const Parameters parameters = halves(folder);
  Parameters turned = parameters;
  for (const auto member : {&GeometryOptions::mesh_file, &GeometryOptions::held_surface})
    std::swap(turned.geometry.*member, turned.lower.geometry.*member);
  std::swap(turned.geometry.contact_surfaces, turned.lower.geometry.contact_surfaces);
  turned.load.legs.back() = move_to(0, 0, 0.012, 3);
  TestScene there(parameters), back(turned);
  there.march();
  back.march();
  const Vector3d force = there.totals().force;
  EXPECT_GT(force[2], 0.1 * there.state.force.lpNorm<1>());
  EXPECT_LE((back.totals().force + force).norm(), 1e-7 * force.norm());
  EXPECT_GT(there.totals().max_accumulated_slip, 1e-3);
  EXPECT_NEAR(back.totals().max_accumulated_slip, there.totals().max_accumulated_slip, 1e-9);
  EXPECT_NEAR(back.totals().total_dissipation, there.totals().total_dissipation,
              1e-6 * there.totals().total_dissipation);
  // The centre of the rim is at z = 0, which is not the size of the ring.
  const MotionChecks checks = motion_checks(there.scene, there.state, there.state.displacement,
                                            there.scene.given_way(there.state.force));
  EXPECT_GT(checks.flattening, 1e-5);
  EXPECT_LT(checks.flattening, 1e-2);
}

namespace
{
/// A ring around z, or the quarter of it between x = 0 and y = 0, as a solid: "base" is its inner side, "top"
/// the outer one, and "side" its ends.
std::string solid_ring(const unsigned int cells, const double inner, const double outer,
                       const bool is_quarter)
{
  dealii::Triangulation<2> section;
  dealii::Triangulation<3> ring;
  if (is_quarter)
    dealii::GridGenerator::quarter_hyper_shell(section, dealii::Point<2>(), inner, outer, cells / 4);
  else
    dealii::GridGenerator::hyper_shell(section, dealii::Point<2>(), inner, outer, cells);
  dealii::GridGenerator::extrude_triangulation(section, 2, seat_length, ring);
  constexpr double rounding = 1e-9;
  for (const auto &face : ring.active_face_iterators())
    if (face->at_boundary())
    {
      const auto centre = face->center();
      const bool is_end = centre[2] < rounding || centre[2] > seat_length - rounding;
      face->set_boundary_id(is_end                                                   ? 3
                            : is_quarter && centre[0] < rounding                     ? 4
                            : is_quarter && centre[1] < rounding                     ? 5
                            : std::hypot(centre[0], centre[1]) < (inner + outer) / 2 ? 1
                                                                                     : 2);
    }
  return Msh(ring).text();
}

/// The hub is held at its rim, and the shaft, a ring of other cells, in its hole. Friction is 0.1 along the
/// axis and 0.3 around it.
Parameters solids(const Folder &folder, const bool is_quarter, const double nu = 0.3)
{
  const auto write =
      [&](const char *const name, const unsigned int cells, const double inner, const double outer)
  {
    return folder.write(std::string(name) + (is_quarter ? "-quarter.msh" : ".msh"),
                        solid_ring(cells, inner, outer, is_quarter));
  };
  Parameters parameters = hub_and_shaft(write("hub", 16, seat, rim), write("shaft", 20, hole, seat), false);
  for (GeometryOptions *const geometry : {&parameters.geometry, &parameters.lower.geometry})
  {
    geometry->kind = GeometryKind::solid;
    geometry->symmetry_surfaces =
        is_quarter ? std::vector<std::string>{"x0", "y0"} : std::vector<std::string>{};
    geometry->supports = {{"side", {{false, false, true}}}};
    geometry->curved_surfaces = {cylinder_about(Vector3d::UnitZ(), "base"),
                                 cylinder_about(Vector3d::UnitZ(), "top")};
  }
  parameters.lower.geometry.held_surface = "base";
  parameters.material.poisson_ratio = parameters.lower.material.poisson_ratio = nu;
  parameters.mesh.refinements = parameters.lower.mesh.refinements = 0;
  parameters.friction.mu = {{0.1, 0.3}};
  parameters.friction.first_axis =
      std::array<Expression, 3>{{Expression("0"), Expression("0"), Expression("1")}};
  share_among_bodies(parameters);
  return parameters;
}

/// Lame's pressure of rings in plane strain that are held at rim and hole: u = A r + B / r is 0 there.
double pressure_of_held_rings(const double nu)
{
  constexpr double modulus = 210000;
  const auto compliance = [&](const double held)
  {
    const double ratio = held * held / (seat * seat);
    return (1 + nu) / modulus * seat * std::abs(1 - ratio) / (1 / (1 - 2 * nu) + ratio);
  };
  return overlap / (compliance(rim) + compliance(hole));
}
} // namespace

TEST(CurvedBodies, AreTheSameInAQuarter)
{
  const Folder folder;
  TestScene whole(solids(folder, false)), quarter(solids(folder, true));
  expect_checked_steps(whole);
  expect_checked_steps(quarter);
  EXPECT_EQ(quarter.symmetry.name(), "quarter");
  const double expected = pressure_of_held_rings(0.3);
  EXPECT_LE(departure(quarter, expected), 2e-2);
  EXPECT_NEAR(seat_force(quarter), seat_force(whole), 1e-8 * seat_force(whole));
  EXPECT_NEAR(quarter.totals().max_pressure, whole.totals().max_pressure, 1e-7 * expected);
  EXPECT_NEAR(seat_force(quarter), expected * 2 * pi * seat * seat_length, 2e-3 * seat_force(whole));
}

// The torque that slips the whole seat, mu p 2 pi a^2 L, and the force that pushes the hub off.
TEST(CurvedBodies, SlipAroundAndAlongTheSeat)
{
  const Folder folder;
  Parameters turned = solids(folder, false), pushed = solids(folder, false, 0);
  Leg leg;
  leg.targets[5] = Drive{false, 0.2};
  leg.steps = 2;
  turned.load.legs.push_back(leg);
  TestScene around(turned);
  around.march();
  const double torque = std::abs(around.scene.held_wrench(around.state.force, around.state.motion)[5]);
  EXPECT_NEAR(torque, 0.3 * pressure_of_held_rings(0.3) * 2 * pi * seat * seat * seat_length, 5e-3 * torque);
  for (GeometryOptions *const geometry : {&pushed.geometry, &pushed.lower.geometry})
    geometry->supports.clear();
  pushed.load.legs.push_back(move_to(0, 0, 0.2, 4));
  TestScene along(pushed);
  along.march();
  const double force = std::abs(along.totals().force[2]);
  EXPECT_NEAR(force, 0.1 * pressure_of_held_rings(0) * 2 * pi * seat * seat_length, 5e-3 * force);
}

TEST(CurvedBodies, AreRefusedWhereTheyOverlapWithoutAnInterference)
{
  const Folder folder;
  Parameters parameters = quarters(folder, 8, 6, Hexahedra::of_8_nodes, true);
  const ModelSymmetry symmetry = choose_model(parameters).symmetry;
  EXPECT_NO_THROW(require_bodies_side_by_side(parameters, symmetry));
  parameters.obstacle.gap = "0.001";
  EXPECT_EQ(
      rejection_of([&] { require_bodies_side_by_side(parameters, symmetry); }),
      "Load program/Loads: 'fit: interference' drives nothing, because the bodies overlap nowhere: allowed "
      "are meshes that overlap, a negative Obstacle/Gap, such as -0.01, or no such load");
  parameters.load.loads.clear();
  EXPECT_NO_THROW(require_bodies_side_by_side(parameters, symmetry));
  EXPECT_TRUE(overlap_warnings(parameters, symmetry).empty());
  parameters.obstacle.gap = "-0.2";
  EXPECT_NE(
      rejection_of([&] { require_bodies_side_by_side(parameters, symmetry); }).find("fit: interference"),
      std::string::npos);
  parameters.obstacle.gap = "-0.001";
  EXPECT_EQ(overlap_warnings(parameters, symmetry).size(), 1u);
}
} // namespace orthocone::test
