// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/scene/gap_file.h>
#include <orthocone/scene/load_path.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/surface_sample.h>

namespace orthocone
{
namespace
{
/// Refuses what a body without a dense compliance cannot do.
void check_backend(const Parameters &parameters)
{
  if (parameters.mesh.backend != BodyBackend::multigrid || !kind_of(parameters.geometry).is_meshed())
    return; // check_body() says of a half-space that it has no mesh
  const std::string method = parameters.contact_solver.method;
  if (find_contact_method(method)->needs_dense)
    throw InputError("Contact solver/Method = " + method +
                     " needs the compliance as a matrix, which Mesh/Backend = multigrid does not compute: "
                     "allowed is newton, or Backend = condensed");
  if (const auto &kind = parameters.obstacle.kind;
      kind.chosen().gives_way() && kind != ObstacleKind::half_space)
    throw InputError("Obstacle/Kind = " + to_word(kind) +
                     " with Mesh/Backend = multigrid, whose V-cycles solve the upper body only: allowed is "
                     "auto or condensed, or Kind = rigid or half-space");
  if (!parameters.material.is_uniform_and_isotropic())
    throw InputError((parameters.material.is_isotropic()
                          ? "Material/Regions = " + parameters.material.regions_text()
                          : parameters.material.law_entry()) +
                     " with Mesh/Backend = multigrid, which solves bodies of one isotropic material only: "
                     "allowed is Backend = condensed");
}

/// Refuses what a half-space, which has neither a mesh nor a matrix, cannot do.
void check_half_space(const Parameters &parameters)
{
  if (kind_of(parameters.geometry).is_meshed())
    return;
  const std::string with = " with " + parameters.geometry.shape_entry(),
                    method = parameters.contact_solver.method;
  if (find_contact_method(method)->needs_dense)
    throw InputError("Contact solver/Method = " + method + with +
                     ", whose compliance is no matrix: allowed is newton");
  const auto &kind = parameters.obstacle.kind;
  if (kind.chosen().gives_way() && kind != ObstacleKind::half_space)
    throw InputError("Obstacle/Kind = " + to_word(kind) + with + ": allowed is rigid or half-space");
  for (const PathLeg &leg : load_path(parameters.load))
    for (unsigned int i = 3; i < n_rigid_components && parameters.geometry.is_periodic; ++i)
      if (leg.after[i].by_force || leg.after[i].value != 0)
        throw InputError(leg.entry + ": " + (leg.after[i].by_force ? wrench_names : motion_names)[i] +
                         " in " + leg.place +
                         " with Geometry/Periodic = yes: allowed are ux, uy, uz and their forces, because a "
                         "surface that turns is not periodic");
  if (parameters.geometry.is_periodic && !parameters.output.lines.empty())
    throw InputError(
        "Output/Lines with Geometry/Periodic = yes: allowed is nothing, because the closed forms of "
        "what is below the surface know no images; Probes are points of the surface");
}

/// Refuses what a friction law that is no ellipse cannot be solved with.
void check_law(const Parameters &parameters)
{
  const std::string &method = parameters.contact_solver.method;
  if (!parameters.friction.has_ellipses() && find_contact_method(method)->needs_ellipses)
    throw InputError("Contact solver/Method = " + method +
                     " needs friction ellipses, and Friction/Law = " + parameters.friction.law.word() +
                     " has none: allowed are newton and gauss-seidel, or Law = ellipses");
}

void check_compression(const LoadOptions &load, const GeometryOptions &geometry)
{
  const ShapeKind &kind = kind_of(geometry);
  if (!kind.has_known_sizes())
    return; // the mesh does not exist yet
  for (const PathLeg &leg : load_path(load))
    if (const double u_z = leg.motion(2); u_z <= -geometry.held_height())
      throw InputError(leg.entry + ": u_z = " + to_text(u_z) +
                       " mm presses the body flat: allowed is more than -" + kind.height_entry(geometry) +
                       " = " + to_text(-geometry.held_height()) + " mm");
}

void check_probes(const GeometryOptions &geometry, const std::vector<Probe> &probes)
{
  const ShapeKind &kind = kind_of(geometry);
  for (const Probe &probe : probes)
    if (!kind.is_on_base(geometry, probe.position))
      throw InputError("Output/Probes: '" + probe.name + "' at (" + to_text(probe.position[0]) + ", " +
                       to_text(probe.position[1]) + ") is off the contact surface: allowed are " +
                       kind.base_in_words(geometry));
}

/// Refuses refinement by what a run finds, which knows one body only.
void check_one_mesh(const MeshOptions &mesh)
{
  const std::string with = " with Obstacle/Kind = body: allowed is ";
  if (mesh.accuracy != 0)
    throw InputError("Mesh/Accuracy = " + to_text(mesh.accuracy) + " %" + with +
                     "0, because the search refines one body only");
  if (mesh.adaptive != 0)
    throw InputError("Mesh/Adaptive = " + std::to_string(mesh.adaptive) + with +
                     "0, because cells are halved in one body only (Mesh/Refinements halves all)");
  if (!mesh.refined_cells.empty())
    throw InputError("Mesh/Refined cells is set" + with +
                     "nothing, because the faces of both bodies are joined without hanging nodes");
}
void check_lower_body(const Parameters &parameters)
{
  constexpr unsigned int most_of_solids = 3;
  if (parameters.obstacle.kind != ObstacleKind::body)
    return;
  check_one_mesh(parameters.mesh);
  const BodyOptions &lower = parameters.lower;
  if (lower.mesh.degree > most_of_solids)
    throw InputError(lower.mesh.section + "/Degree = " + std::to_string(lower.mesh.degree) +
                     ": allowed is a whole number from 1 to 3");
  check_body(lower);
}

/// Refuses a lower body in plane strain that is no section of the same thickness.
void check_lower_section(const Parameters &parameters, const std::string &with)
{
  constexpr unsigned int most_of_faces = 3;
  const GeometryOptions &upper = parameters.geometry, &lower = parameters.lower.geometry;
  const auto thickness = kind_of(lower).thickness(lower);
  if (!thickness)
    throw InputError(lower.shape_entry() + with + "box or file");
  if (thickness->value != upper.section_thickness())
    throw InputError(thickness->entry + " = " + to_text(thickness->value) + " mm" + with +
                     "the thickness of the upper body, " + to_text(upper.section_thickness()) + " mm");
  if (parameters.mesh.degree > most_of_faces)
    throw InputError(parameters.mesh.section + "/Degree = " + std::to_string(parameters.mesh.degree) +
                     " with Obstacle/Kind = body: allowed is a whole number from 1 to 3");
}

/// Refuses legs that drive a top which is free.
void check_free_top(const Parameters &parameters)
{
  if (parameters.geometry.top_face != TopFace::free)
    return;
  for (const PathLeg &leg : load_path(parameters.load))
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      if (leg.after[i].by_force || leg.after[i].value != 0)
        throw InputError(leg.entry + ": " + (leg.after[i].by_force ? wrench_names : motion_names)[i] +
                         " in " + leg.place +
                         " with Geometry/Top face = free, so that there is no held face to drive: allowed "
                         "are names of Load program/Loads, or Top face = clamped");
}

/// Refuses loads along directions in which a guided top is free, where supports hold the body instead.
void check_guided(const Parameters &parameters)
{
  constexpr unsigned int normal = 2, first_in_plane = 3, about_normal = 5;
  if (parameters.geometry.top_face != TopFace::guided || parameters.geometry.supports.empty())
    return;
  for (const PathLeg &leg : load_path(parameters.load))
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      if ((i < normal || i == about_normal) && (leg.after[i].by_force || leg.after[i].value != 0))
        throw InputError(leg.entry + ": " + (leg.after[i].by_force ? wrench_names : motion_names)[i] +
                         " in " + leg.place + " with Geometry/Top face = guided, which is free " +
                         (i < first_in_plane ? "sideways" : "to turn") +
                         ": allowed are uz, Fz, rx, ry, Mx and My, or Top face = clamped");
}

/// Refuses problem files of faces whose motion the body itself resists: their format has no such term.
void check_problem_files(const Parameters &parameters)
{
  if (parameters.output.problem_interval == 0)
    return;
  for (const Load &load : parameters.load.loads)
    if (load.kind->is_force_of_surface())
      throw InputError("Output/Problems with Load program/Loads = '" + load.text() +
                       "': FCLIB's format has no place for the stiffness of the body against the motion of "
                       "that surface; allowed are motions, or Problems = 0");
  if (parameters.geometry.supports.empty())
    return;
  if (parameters.geometry.top_face == TopFace::free)
    throw InputError("Output/Problems with Geometry/Supports and Top face = free: FCLIB's format has no "
                     "place for the stiffness of the supports; allowed is Problems = 0");
  for (const PathLeg &leg : load_path(parameters.load))
    for (unsigned int i = 0; i < n_rigid_components; ++i)
      if (leg.after[i].by_force)
        throw InputError("Output/Problems with Geometry/Supports and " + std::string(wrench_names[i]) +
                         " in " + leg.place + " of " + leg.entry +
                         ": FCLIB's format has no place for the stiffness of the supports against the held "
                         "face; allowed are motions, or Problems = 0");
}

/// Refuses what has no plane strain.
void check_plane_strain(const Parameters &parameters)
{
  if (!parameters.geometry.is_plane_strain())
    return;
  const std::string with = " with Geometry/Kind = plane strain: allowed is ";
  if (!kind_of(parameters.geometry).thickness(parameters.geometry))
    throw InputError(parameters.geometry.shape_entry() + with + "box or file");
  if (parameters.obstacle.kind == ObstacleKind::body)
    return check_lower_section(parameters, with);
}

/// Refuses an interference of the lower body, and a second one.
void check_interference(const std::vector<Load> &loads)
{
  const Load *first = nullptr;
  for (const Load &load : loads)
  {
    if (!load.kind->drives_overlap())
      continue;
    const std::string given = "Load program/Loads: '" + load.text() + "'";
    if (load.is_on_lower)
      throw InputError(given + ": allowed is 'interference' without 'on lower', because it is the overlap of "
                               "the body and its counterface");
    if (first != nullptr)
      throw InputError(given + " beside '" + first->text() +
                       "': allowed is one interference, the share of all negative gaps");
    first = &load;
  }
}

/// Refuses loads on a body that is not there, loads that do nothing, and names that no load has.
void check_loads(const Parameters &parameters)
{
  const std::vector<Load> &loads = parameters.load.loads;
  check_interference(loads);
  for (const Load &load : loads)
  {
    const std::string given = "Load program/Loads: '" + load.text() + "'";
    if (load.is_on_lower && parameters.obstacle.kind != ObstacleKind::body)
      throw InputError(given + " with Obstacle/Kind = " + parameters.obstacle.kind.word() +
                       ": allowed on lower is Kind = body, which has a lower body");
    const MaterialOptions &material = load.is_on_lower ? parameters.lower.material : parameters.material;
    if (const std::string lacking = load.kind->lacking_entry(material); !lacking.empty())
      throw InputError(given + " with " + lacking + " = 0 does nothing: allowed is a number other than 0");
  }
  for (const auto *const legs : {&parameters.load.preload, &parameters.load.cycle_legs()})
    for (const Leg &leg : *legs)
      for (const auto &[name, value] : leg.loads)
        if (std::none_of(loads.begin(), loads.end(),
                         [&, &own = name](const Load &load) { return load.name == own; }))
          throw InputError("Load program: a leg drives " + name +
                           ", which is no load: allowed are names of Load program/Loads");
}

/// Refuses a counterface that is told twice, and curved normals where the counterface is flat by its kind.
void check_obstacle(const ObstacleOptions &obstacle)
{
  const std::string distance = "Obstacle/Distance = " + obstacle.distance;
  if (!obstacle.gap_file.empty())
    read_gap_file(obstacle.gap_file);
  if (!obstacle.distance.empty() && (obstacle.gap != ObstacleOptions().gap || !obstacle.gap_file.empty()))
    throw InputError(distance + " with " +
                     (obstacle.gap_file.empty() ? "Obstacle/Gap = " + obstacle.gap
                                                : "Obstacle/Gap file = " + shown_path(obstacle.gap_file)) +
                     ": allowed is one of both, because each says where the counterface is");
  if (!obstacle.distance.empty() && obstacle.normal == ObstacleNormal::surface)
    throw InputError(distance + " with Obstacle/Normal = surface: allowed is Normal = plane, because the "
                                "gradient of the distance is the normal");
  if (obstacle.normal == ObstacleNormal::plane && obstacle.distance.empty() &&
      Expression(obstacle.gap).has_z())
    throw InputError("Obstacle/Gap = " + obstacle.gap +
                     " contains z, but it is the gap below a place (x, y): allowed is Obstacle/Distance, the "
                     "distance from a place (x, y, z), or Obstacle/Normal = surface");
  const bool is_surface_of_body = obstacle.distance.empty() && obstacle.kind.chosen().is_body();
  if (!obstacle.has_normal_z() && !is_surface_of_body && obstacle.kind.chosen().gives_way())
    throw InputError((obstacle.distance.empty() ? "Obstacle/Normal = surface" : distance) +
                     " with Obstacle/Kind = " + obstacle.kind.word() + ": allowed is Kind = rigid" +
                     (obstacle.distance.empty() ? " or body" : ", or Normal = surface and Kind = body"));
}

/// Refuses axes of friction that are told twice.
void check_first_axis(const FrictionOptions &friction)
{
  if (friction.first_axis && (friction.angle != 0 || friction.varying_angle))
    throw InputError("Friction/First axis with Friction/Orthotropy angle = " +
                     (friction.varying_angle ? friction.varying_angle->text() : to_text(friction.angle)) +
                     ": allowed is one of both, because each says where the axes of friction are");
}
/// Refuses jumps that do not follow friction with memory, or follow a friction that has none.
void check_jumps_of_friction(const FrictionOptions &friction, const LoadOptions &load,
                             const WearOptions &wear)
{
  const std::string with = " with Friction/Factor = " + friction.factor.text() + ": allowed is ";
  const std::string follows = "Load program/Jump change of friction";
  const double change = load.jump_change_of_friction;
  const bool has_memory = friction.has_factor() && friction.factor.remembers();
  if (change > 0 && !has_memory)
    throw InputError(follows + " = " + to_text(change) + with +
                     "0, because no slip, energy or cycle changes this friction");
  if (load.jump_when_periodic > 0 && has_memory)
    throw InputError("Load program/Jump when periodic = " + to_text(load.jump_when_periodic) + with +
                     "0, because friction that changes from cycle to cycle is not periodic (" + follows +
                     " jumps cycles)");
  const bool wear_jumps = wear.wears() && wear.largest_jump > 0;
  if (has_memory && wear_jumps && change == 0)
    throw InputError("Wear/Largest depth of a jump = " + to_text(wear.largest_jump) + with + "0, or a " +
                     follows + " > 0, which bounds what friction changes in a jump");
  if (change > 0 && wear.wears() && !wear_jumps)
    throw InputError(follows + " = " + to_text(change) + " with " + wear.law_entry() +
                     ": allowed is 0, or a Wear/Largest depth of a jump > 0, which bounds what a jump wears");
}

/// Refuses a factor of friction that cannot begin, or knows no times.
void check_factor(const FrictionOptions &friction, const LoadOptions &load)
{
  if (!friction.has_factor())
    return;
  const std::string entry = "Friction/Factor = " + friction.factor.text();
  if (friction.factor.has_speed() && (load.rows.empty() || !load.rows.front().row->time))
    throw InputError(entry +
                     " contains v, the speed of slip, but the load program has no times: allowed is a "
                     "Load program/Program file with a column 'time', or an expression without v");
  const unsigned int cycle = load.first_cycle();
  if (const double first = friction.factor.at_start(cycle); !FrictionFactor::is_fine(first))
    throw InputError(entry + " is " + value_text(first) +
                     " at the start, where s, w, p and v are 0 and n is " + std::to_string(cycle) +
                     ": allowed is a finite number > 0 there, as 1 + s/(0.1 + s) has it");
}
} // namespace

void check_parameters(const Parameters &parameters)
{
  check_plane_strain(parameters);
  check_mesh_choice(parameters);
  check_backend(parameters);
  check_half_space(parameters);
  check_law(parameters);
  check_load(parameters.load, parameters.wear);
  check_loads(parameters);
  check_wear(parameters.wear, parameters.load);
  check_compression(parameters.load, parameters.geometry);
  check_body(parameters);
  check_guided(parameters);
  check_free_top(parameters);
  check_problem_files(parameters);
  check_probes(parameters.geometry, parameters.output.probes);
  check_lower_body(parameters);
  check_obstacle(parameters.obstacle);
  check_first_axis(parameters.friction);
  check_factor(parameters.friction, parameters.load);
  check_jumps_of_friction(parameters.friction, parameters.load, parameters.wear);
}
} // namespace orthocone
