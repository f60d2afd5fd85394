// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/parameters.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/program_file.h>

namespace orthocone
{
void declare_parameters(Parameters &parameters, EntryList &list)
{
  const auto section = [&list](const char *const name, auto declare, auto &options)
  {
    Section of_name(list, name);
    declare(options, of_name);
  };
  section("Geometry", declare_shape, parameters.geometry);
  section("Geometry", declare_top_face, parameters.geometry);
  section("Geometry", declare_kind, parameters.geometry);
  section("Mesh", declare_mesh_choice, parameters.mesh);
  Section mesh(list, "Mesh");
  declare_cells(parameters.mesh, parameters.geometry, mesh);
  declare_backend(parameters.mesh, parameters.geometry, mesh);
  section("Material", declare_material, parameters.material);
  section("Friction", declare_friction, parameters.friction);
  section("Obstacle", declare_obstacle, parameters.obstacle);
  const ObstacleOptions &obstacle = parameters.obstacle;
  const Condition has_lower{[&obstacle] { return obstacle.kind == ObstacleKind::body; },
                            [&obstacle] { return "Obstacle/Kind = " + obstacle.kind.word(); }};
  BodyOptions &lower = parameters.lower;
  Section lower_geometry(list, lower.geometry.section, has_lower),
      lower_mesh(list, lower.mesh.section, has_lower),
      lower_material(list, lower.material.section, has_lower);
  declare_shape(lower.geometry, lower_geometry);
  declare_top_face(lower.geometry, lower_geometry);
  declare_cells(lower.mesh, lower.geometry, lower_mesh);
  declare_material(lower.material, lower_material);
  section("Wear", declare_wear, parameters.wear);
  section("Load program", declare_load, parameters.load);
  section("Contact solver", declare_contact_solver, parameters.contact_solver);
  section("Checks", declare_checks, parameters.checks);
  section("Output", declare_output, parameters.output);
}

void share_among_bodies(Parameters &parameters)
{
  GeometryOptions &upper = parameters.geometry, &lower = parameters.lower.geometry;
  lower.kind = upper.kind;
  lower.thickness = upper.section_thickness();
  upper.loads = lower.loads = parameters.load.loads;
  upper.faces_down = lower.faces_down = parameters.obstacle.has_normal_z();
}

ParameterFile read_parameter_file(const std::string &file_name, const std::vector<std::string> &overrides)
{
  ParameterFile file;
  EntryList list;
  declare_parameters(file.parameters, list);
  file.text = read_entries(file_name, list);
  for (const std::string &assignment : overrides)
    assign_entry(assignment, list);
  try
  {
    read_program_file(file.parameters.load);
  }
  catch (const InputError &error)
  {
    throw InputError(shown_path(file_name) + ": " + error.what());
  }
  share_among_bodies(file.parameters);
  return file;
}

Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides)
{
  return read_parameter_file(file_name, overrides).parameters;
}

void write_parameters(const Parameters &parameters, std::ostream &out)
{
  print_entries(DeclaredParameters(parameters).list, out);
}

std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters)
{
  return DeclaredParameters(parameters).list.values();
}

std::string entry_text(const Parameters &parameters, const std::string &entry)
{
  return entry + " = " + DeclaredParameters(parameters).list.find(entry)->text();
}

Parameters with_section(const Parameters &parameters, const std::string &section,
                        const std::vector<std::pair<std::string, std::string>> &values)
{
  DeclaredParameters changed(parameters);
  for (const auto &[entry, value] : values)
    if (entry.compare(0, section.size() + 1, section + "/") == 0)
      restore_entry(entry, value, changed.list);
  return changed.parameters;
}

Parameters lower_parameters(const Parameters &parameters)
{
  Parameters lower{parameters.lower,          parameters.friction, {},
                   BodyOptions::lower(),      parameters.wear,     parameters.load,
                   parameters.contact_solver, parameters.checks,   parameters.output};
  lower.mesh.backend = BodyBackend::condensed;
  lower.output.probes.clear();
  lower.output.lines.clear();
  return lower;
}
} // namespace orthocone
