// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/tables.h>

#include <orthocone/base/numbers.h>
#include <orthocone/results/volume_fields.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
namespace
{
using Step = SolvedStep;
using Probed = ProbedStep;
using Cycle = CycleRow;

std::string word_of(const NodeStatus status)
{
  return status == NodeStatus::open ? "open" : status == NodeStatus::stick ? "stick" : "slip";
}

double degrees(const SolvedStep &step, const unsigned int axis)
{
  return step.state.motion.rotation()[axis] / radians_per_degree;
}

double dissipated(const SolvedStep &step)
{
  return step.totals.total_dissipation - step.before.total_dissipation;
}

/// The columns in the order that files have always had.
Columns<SolvedStep> first_history_columns()
{
  return {{"step", "", "number of the load step, from 1", [](const Step &s) { return s.state.step; }},
          {"ux", "mm", "motion of the held face along x", [](const Step &s) { return s.state.motion[0]; }},
          {"uy", "mm", "motion of the held face along y", [](const Step &s) { return s.state.motion[1]; }},
          {"uz", "mm", "motion of the held face along z", [](const Step &s) { return s.state.motion[2]; }},
          {"force_x", "N",
           "force of the counterface on the body along x; without supports the held face carries -force_x",
           [](const Step &s) { return s.totals.force[0]; }},
          {"force_y", "N",
           "force of the counterface on the body along y; without supports the held face carries -force_y",
           [](const Step &s) { return s.totals.force[1]; }},
          {"force_z", "N", "force of the counterface on the body along z, > 0 where it is pressed",
           [](const Step &s) { return s.totals.force[2]; }},
          {"max_slip", "mm", "largest slip of a node in contact",
           [](const Step &s) { return s.totals.max_slip; }},
          {"max_accumulated_slip", "mm", "largest accumulated slip of a node: length of its path of slip",
           [](const Step &s) { return s.totals.max_accumulated_slip; }},
          {"min_pressure", "MPa", "least pressure of a node",
           [](const Step &s) { return s.totals.min_pressure; }},
          {"max_pressure", "MPa", "largest pressure of a node",
           [](const Step &s) { return s.totals.max_pressure; }},
          {"n_open", "", "nodes (or rings) that are open", [](const Step &s) { return s.totals.n_open; }},
          {"n_stick", "", "nodes (or rings) that stick", [](const Step &s) { return s.totals.n_stick; }},
          {"n_slip", "", "nodes (or rings) that slip", [](const Step &s) { return s.totals.n_slip; }},
          {"stick_area", "mm^2", "area that sticks", [](const Step &s) { return s.totals.stick_area; }},
          {"dissipation", "N mm", "energy that friction dissipates in the step", dissipated},
          {"total_dissipation", "N mm", "energy that friction has dissipated since the start",
           [](const Step &s) { return s.totals.total_dissipation; }},
          {"elastic_energy", "N mm", "energy that is stored in the bodies",
           [](const Step &s) { return s.totals.elastic_energy; }},
          {"method", "", "contact solver", [](const Step &s) { return s.method; }},
          {"iterations", "", "iterations of the contact solver",
           [](const Step &s) { return s.report.iterations; }},
          {"residual", "", "residual: norm of the natural map relative to the norm of the contact forces",
           [](const Step &s) { return s.report.residual; }}};
}

/// Columns that were added later come behind them.
Columns<SolvedStep> later_history_columns()
{
  constexpr const char *of_plane = "moment of the counterface on the body, about the centre of the held face";
  return {
      {"rx", "degrees", "rotation of the held face about x", [](const Step &s) { return degrees(s, 0); }},
      {"ry", "degrees", "rotation of the held face about y", [](const Step &s) { return degrees(s, 1); }},
      {"rz", "degrees", "rotation of the held face about z", [](const Step &s) { return degrees(s, 2); }},
      {"moment_x", "N mm", of_plane, [](const Step &s) { return s.totals.moment[0]; }},
      {"moment_y", "N mm", of_plane, [](const Step &s) { return s.totals.moment[1]; }},
      {"moment_z", "N mm", of_plane, [](const Step &s) { return s.totals.moment[2]; }},
      {"cycle", "", "number of the cycle, from 1; 0 in the preload",
       [](const Step &s) { return s.step.cycle; }},
      {"phase", "", "step of the cycle or preload, from 0", [](const Step &s) { return s.step.phase; }},
      {"driven", "", "components of the held face that are driven", [](const Step &s) { return s.driven; }},
      {"worn_volume", "mm^3", "volume that has been worn off since the start",
       [](const Step &s) { return s.totals.worn_volume; }},
      {"max_wear_depth", "mm", "largest worn depth of a node",
       [](const Step &s) { return s.totals.max_wear_depth; }}};
}

/// Force and moment on the held face, with the signs of the load program, and the size of the contact.
Columns<SolvedStep> columns_of_held_face_and_contact()
{
  constexpr const char *on_face = "moment on the held face, about its centre, as Mx, My and Mz of the legs";
  // Zero has no sign.
  return {
      {"contact_area", "mm^2", "sum of the areas of the nodes in contact",
       [](const Step &s) { return s.totals.contact_area; }},
      {"held_force_x", "N", "force on the held face along x, as Fx of the legs",
       [](const Step &s) { return s.totals.held[0] + 0.; }},
      {"held_force_y", "N", "force on the held face along y, as Fy of the legs",
       [](const Step &s) { return s.totals.held[1] + 0.; }},
      {"held_force_z", "N", "force on the held face along z, as Fz of the legs: -force_z without supports",
       [](const Step &s) { return s.totals.held[2] + 0.; }},
      {"held_moment_x", "N mm", on_face, [](const Step &s) { return s.totals.held[3] + 0.; }},
      {"held_moment_y", "N mm", on_face, [](const Step &s) { return s.totals.held[4] + 0.; }},
      {"held_moment_z", "N mm", on_face, [](const Step &s) { return s.totals.held[5] + 0.; }},
      {"time", "s", "time of the program file at the end of the step; without one, the number of the step",
       [](const Step &s) { return s.step.time.value_or(s.step.number); }}};
}

Columns<CycleRow> first_cycle_columns()
{
  return {
      {"cycle", "", "number of the last cycle of the row", [](const Cycle &c) { return c.cycle; }},
      {"n_cycles", "", "cycles that the row stands for", [](const Cycle &c) { return c.n_cycles; }},
      {"last_step", "", "number of the last load step of the cycle",
       [](const Cycle &c) { return c.last_step; }},
      {"peak_force_z", "N", "force_z where the total force is largest",
       [](const Cycle &c) { return c.peak_force_z; }},
      {"force_z", "N", "force along z at the end of the cycle", [](const Cycle &c) { return c.force_z; }},
      {"max_slip", "mm", "largest slip of a node in contact in the cycle",
       [](const Cycle &c) { return c.max_slip; }},
      {"max_accumulated_slip", "mm", "largest accumulated slip of a node since the start",
       [](const Cycle &c) { return c.max_accumulated_slip; }},
      {"accumulated_slip", "mm", "largest accumulated slip of a node in the cycles of the row",
       [](const Cycle &c) { return c.accumulated_slip; }},
      {"dissipation", "N mm", "energy that friction dissipates in the cycles of the row",
       [](const Cycle &c) { return c.dissipation; }},
      {"total_dissipation", "N mm", "energy that friction has dissipated since the start",
       [](const Cycle &c) { return c.total_dissipation; }},
      {"work", "N mm",
       "work of the held face, of all its forces and moments, and of the loads, in the cycles of the row: "
       "dissipation + change of elastic_energy + energy that leaves with worn material",
       [](const Cycle &c) { return c.work; }},
      {"change", "", "largest relative difference between the states at both ends of the cycle",
       [](const Cycle &c) { return c.change; }},
      {"iterations", "", "iterations of the contact solver", [](const Cycle &c) { return c.iterations; }},
      {"worn_volume", "mm^3", "volume that has been worn off since the start",
       [](const Cycle &c) { return c.worn_volume; }},
      {"max_wear_depth", "mm", "largest worn depth of a node at the end of the cycle",
       [](const Cycle &c) { return c.max_wear_depth; }},
      {"wear_error", "mm^3", "estimated error that jumps cause in worn_volume",
       [](const Cycle &c) { return c.wear_error; }}};
}

/// What fretting tests report; nan where a cycle has no loop, or its loop no such figure.
Columns<CycleRow> columns_of_fretting()
{
  return {{"stroke", "mm",
           "2 delta*: largest distance between two tangential positions of the held face in the cycle, along "
           "which the loop is evaluated",
           [](const Cycle &c) { return c.loop.stroke; }},
          {"tangential_force", "N", "Q*: largest tangential force along the stroke",
           [](const Cycle &c) { return c.loop.peak_force; }},
          {"slip_ratio", "",
           "delta_0/delta*: width of the loop at zero force over the stroke; nan where the force does not "
           "cross zero twice",
           [](const Cycle &c) { return c.loop.slip_ratio; }},
          {"energy_ratio", "", "E_d/(4 Q* delta*), with the area E_d of the loop; nan without a stroke",
           [](const Cycle &c) { return c.loop.energy_ratio; }},
          {"friction_largest", "", "Q*/P: largest tangential force over the normal force there",
           [](const Cycle &c) { return c.loop.friction_largest; }},
          {"friction_energy", "", "E_d/(4 P delta_0), with the mean normal force P; nan where nothing slips",
           [](const Cycle &c) { return c.loop.friction_energy; }},
          {"friction_geometric", "", "Q/P in the middle of the stroke, mean of both directions",
           [](const Cycle &c) { return c.loop.friction_geometric; }},
          {"loop_stiffness", "N/mm",
           "slope of the loop in the first step after a reversal, mean of both reversals",
           [](const Cycle &c) { return c.loop.stiffness; }},
          {"worst_energy", "N/mm", "largest energy that a node dissipates per area in the cycles of the row",
           [](const Cycle &c) { return c.worst_energy; }},
          {"worst_wear", "mm", "largest depth that a node loses in the cycles of the row",
           [](const Cycle &c) { return c.worst_wear; }}};
}

std::optional<double> on_surface(const LinePoint &point, const double value)
{
  return point.contact ? std::optional(value + 0.) : std::nullopt; // zero has no sign
}

Columns<LinePoint> line_columns_in_body()
{
  using P = LinePoint;
  return {{"s", "mm", "distance from the first end of the line", [](const P &p) { return p.distance; }},
          {"x", "mm", "place of the point in the undeformed whole body, along x",
           [](const P &p) { return p.body.place[0]; }},
          {"y", "mm", "place along y", [](const P &p) { return p.body.place[1]; }},
          {"z", "mm", "place along z, > 0 in the body, < 0 in the lower body",
           [](const P &p) { return p.body.place[2]; }},
          {"u_x", "mm", "displacement from the undeformed body along x",
           [](const P &p) { return p.body.displacement[0]; }},
          {"u_y", "mm", "displacement along y", [](const P &p) { return p.body.displacement[1]; }},
          {"u_z", "mm", "displacement along z", [](const P &p) { return p.body.displacement[2]; }},
          {"stress_xx", "MPa",
           "normal stress along x, > 0 is tension; like all stresses the mean of the elements that meet at "
           "the point",
           [](const P &p) { return p.body.stress[0][0]; }},
          {"stress_yy", "MPa", "normal stress along y", [](const P &p) { return p.body.stress[1][1]; }},
          {"stress_zz", "MPa", "normal stress along z", [](const P &p) { return p.body.stress[2][2]; }},
          {"stress_xy", "MPa", "shear stress of x and y", [](const P &p) { return p.body.stress[0][1]; }},
          {"stress_xz", "MPa", "shear stress of x and z", [](const P &p) { return p.body.stress[0][2]; }},
          {"stress_yz", "MPa", "shear stress of y and z", [](const P &p) { return p.body.stress[1][2]; }}};
}

/// nan where a point is not on the contact surface.
Columns<LinePoint> line_columns_on_surface()
{
  using P = LinePoint;
  const auto of = [](const P &p) { return p.contact.value_or(ContactFields()); };
  return {{"pressure", "MPa", "normal traction; nan off the contact surface, as are all columns that follow",
           [of](const P &p) { return on_surface(p, of(p).pressure); }},
          {"traction_x", "MPa", "friction traction of the counterface on the body along x",
           [of](const P &p) { return on_surface(p, of(p).friction_traction[0]); }},
          {"traction_y", "MPa", "friction traction of the counterface on the body along y",
           [of](const P &p) { return on_surface(p, of(p).friction_traction[1]); }},
          {"slip_x", "mm", "slip along x; 0 where the surface is open",
           [of](const P &p) { return on_surface(p, of(p).slip[0]); }},
          {"slip_y", "mm", "slip along y; 0 where the surface is open",
           [of](const P &p) { return on_surface(p, of(p).slip[1]); }},
          {"status", "",
           "open, stick or slip, as at the nearest contact node; inside off the contact surface",
           [of](const P &p) { return p.contact ? word_of(of(p).status) : std::string("inside"); }},
          {"traction_z", "MPa", "friction traction along z, on surfaces with another normal",
           [of](const P &p) { return on_surface(p, of(p).friction_traction[2]); }},
          {"slip_z", "mm", "slip along z, on surfaces with another normal",
           [of](const P &p) { return on_surface(p, of(p).slip[2]); }}};
}

/// The lines of one file. An `Item` has a name, a unit, and a text on its meaning.
template<typename Item>
std::string lines(const std::string &file, const std::vector<Item> &items)
{
  std::string text;
  for (const Item &item : items)
    text += file + "\t" + item.name + "\t" + item.unit + "\t" + item.how + "\n";
  return text;
}
} // namespace

const Columns<SolvedStep> &history_columns()
{
  static const Columns<SolvedStep> columns = []
  {
    Columns<SolvedStep> all = first_history_columns();
    for (const Columns<SolvedStep> &later : {later_history_columns(), columns_of_held_face_and_contact()})
      all.insert(all.end(), later.begin(), later.end());
    return all;
  }();
  return columns;
}

const Columns<SolvedStep> &checks_columns()
{
  static const Columns<SolvedStep> columns{
      {"step", "", "number of the load step, from 1", [](const Step &s) { return s.state.step; }},
      {"equilibrium", "", "relative error of forces and displacements of the body",
       [](const Step &s) { return s.checks.equilibrium; }},
      {"penetration", "",
       "largest penetration, relative to the largest displacement or motion along z, whichever is smaller",
       [](const Step &s) { return s.checks.law.penetration; }},
      {"complementarity", "",
       "smaller one of gap and normal force of a node, each relative to the largest of its kind",
       [](const Step &s) { return s.checks.law.complementarity; }},
      {"friction_cone", "", "how far forces lie outside of the friction cone, relative to the largest force",
       [](const Step &s) { return s.checks.law.friction_cone; }},
      {"slip_rule", "", "relative change of slip that does not follow the slip rule",
       [](const Step &s) { return s.checks.law.slip_rule; }},
      {"work", "N mm",
       "work of the held face, of all its forces and moments, and of the loads, in the step: dissipation + "
       "change of elastic_energy + energy that leaves with worn material, but for energy_defect",
       [](const Step &s) { return s.checks.work; }},
      {"energy_identity", "", "relative error of an energy balance that holds for load steps of any size",
       [](const Step &s) { return s.checks.energy_identity; }},
      {"energy_defect", "",
       "energy that the step leaves open in the balance, relative to the largest energy so far",
       [](const Step &s) { return s.checks.energy_defect; }}};
  return columns;
}

const Columns<SolvedStep> &timing_columns()
{
  static const Columns<SolvedStep> columns{
      {"step", "", "number of the load step, from 1", [](const Step &s) { return s.state.step; }},
      {"seconds", "s", "wall time of the contact solver", [](const Step &s) { return s.seconds; }},
      {"iterations", "", "iterations of the contact solver",
       [](const Step &s) { return s.report.iterations; }},
      {"v_cycles", "", "V-cycles on the finest mesh, since the step before; 0 without multigrid",
       [](const Step &s) { return s.n_v_cycles; }},
      {"gmres_iterations", "",
       "iterations of GMRES by products of half-spaces without a matrix, on the finest grid or mesh, since "
       "the "
       "step before; 0 without these",
       [](const Step &s) { return s.n_gmres_iterations; }}};
  return columns;
}

const Columns<ProbedStep> &probe_columns()
{
  static const Columns<ProbedStep> columns{
      {"step", "", "number of the load step, from 1", [](const Probed &p) { return p.state.step; }},
      {"uz", "mm", "motion of the held face along z", [](const Probed &p) { return p.state.motion[2]; }},
      {"slip_x", "mm", "slip along x; 0 where the node is open",
       [](const Probed &p) { return p.fields.slip[0]; }},
      {"slip_y", "mm", "slip along y; 0 where the node is open",
       [](const Probed &p) { return p.fields.slip[1]; }},
      {"accumulated_slip", "mm",
       "accumulated slip: length of the path along which the node has slipped since the start",
       [](const Probed &p) { return p.fields.accumulated_slip; }},
      {"force_n", "N", "force of the counterface on the node along the normal",
       [](const Probed &p) { return p.fields.normal_force; }},
      {"force_x", "N", "force of the counterface on the node along x",
       [](const Probed &p) { return p.fields.nodal_force[0]; }},
      {"force_y", "N", "force of the counterface on the node along y",
       [](const Probed &p) { return p.fields.nodal_force[1]; }},
      {"pressure", "MPa", "normal traction", [](const Probed &p) { return p.fields.pressure; }},
      {"traction_x", "MPa", "friction traction along x",
       [](const Probed &p) { return p.fields.friction_traction[0]; }},
      {"traction_y", "MPa", "friction traction along y",
       [](const Probed &p) { return p.fields.friction_traction[1]; }},
      {"status", "", "open, stick or slip", [](const Probed &p) { return word_of(p.fields.status); }},
      {"slip_z", "mm", "slip along z, on surfaces with another normal",
       [](const Probed &p) { return p.fields.slip[2] + 0.; }},
      {"force_z", "N", "force of the counterface on the node along z",
       [](const Probed &p) { return p.fields.nodal_force[2]; }},
      {"traction_z", "MPa", "friction traction along z, on surfaces with another normal",
       [](const Probed &p) { return p.fields.friction_traction[2] + 0.; }}};
  return columns;
}

const Columns<CycleRow> &cycle_columns()
{
  static const Columns<CycleRow> columns = []
  {
    Columns<CycleRow> all = first_cycle_columns(), later = columns_of_fretting();
    all.insert(all.end(), later.begin(), later.end());
    return all;
  }();
  return columns;
}

const Columns<LinePoint> &line_columns()
{
  static const Columns<LinePoint> columns = []
  {
    Columns<LinePoint> all = line_columns_in_body(), later = line_columns_on_surface();
    all.insert(all.end(), later.begin(), later.end());
    return all;
  }();
  return columns;
}

std::string described_columns()
{
  FrictionOptions friction; // with all columns that a run may have
  friction.factor = FrictionFactor("1 + s");
  return lines("history.csv", with_factor(history_columns(), friction)) +
         lines("probe-NAME.csv", probe_columns()) +
         lines("cycles.csv", with_factor(cycle_columns(), friction)) + lines("checks.csv", checks_columns()) +
         lines("timing.csv", timing_columns()) + lines("line-NAME-NNNN.csv", line_columns()) +
         lines("contact-NNNN.vtu", contact_field_list()) + lines("volume-NNNN.vtu", volume_field_list());
}
} // namespace orthocone
