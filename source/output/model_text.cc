// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/model_text.h>

#include <orthocone/base/text.h>
#include <orthocone/body/grid_surface.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/output/load_ranges.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/parameters.h>

#include <array>
#include <sstream>

namespace orthocone
{
namespace
{
/// What the name of the surface says is held, and how.
std::string held_text(const GeometryOptions &geometry)
{
  const std::vector<std::string> names = kind_of(geometry).surfaces(geometry);
  const std::string name = geometry.is_from_file()          ? shown(geometry.held_surface)
                           : !kind_of(geometry).is_meshed() ? std::string("far field")
                           : names.empty()                  ? std::string("top")
                                                            : names[1];
  if (name.empty() || geometry.top_face == TopFace::free)
    return "none: supports, loads and contact hold the body";
  if (geometry.top_face == TopFace::guided)
    return name + ", guided: " + (geometry.is_lower ? "held" : "moved") + " along z, free sideways";
  return name + ", clamped: " +
         (geometry.is_lower               ? "does not move"
          : kind_of(geometry).is_meshed() ? "moves as a rigid plate"
                                          : "moves as a rigid body");
}

std::string supports_line(const GeometryOptions &geometry, const std::string &heading)
{
  std::string text;
  for (const Support &support : geometry.supports)
  {
    text += (text.empty() ? "" : " ; ") + shown(support.surface) + ":";
    for (unsigned int d = 0; d < 3; ++d)
      text += support.directions[d] ? std::string(" ") + "xyz"[d] : "";
  }
  return text.empty() ? "" : heading + text + "\n";
}
} // namespace

std::string material_text(const MaterialOptions &material)
{
  std::string text = material.is_isotropic() ? "E " + to_text(material.young_modulus) + " MPa, nu " +
                                                   to_text(material.poisson_ratio)
                                             : material.law.word();
  if (!material.regions.empty())
    text += "; regions " + material.regions_text();
  if (material.thermal_expansion != 0)
    text += "; thermal expansion " + to_text(material.thermal_expansion) + " 1/K";
  return text;
}

std::string describe_materials(const Parameters &parameters)
{
  std::string text = "material       " + material_text(parameters.material) + "\n";
  if (parameters.obstacle.kind.chosen().is_body())
    text += "lower material " + material_text(parameters.lower.material) + "\n";
  return text;
}

std::string describe_held(const Parameters &parameters)
{
  std::string text = "held face      " + held_text(parameters.geometry) + "\n" +
                     supports_line(parameters.geometry, "supports       ");
  if (parameters.obstacle.kind.chosen().is_body())
    text += "lower held     " + held_text(parameters.lower.geometry) + "\n" +
            supports_line(parameters.lower.geometry, "lower supports ");
  return text;
}

std::string describe_drive(const LoadOptions &load)
{
  std::string face, loads;
  for (const LoadRange &range : load_ranges(load))
    if (range.number < n_rigid_components)
      face += (face.empty() ? "driven by      " : ", ") + range.name + " " + range.text();
    else
      loads += (loads.empty() ? "loads          " : "               ") +
               load.loads[range.number - n_rigid_components].text() + ", " + range.text() + "\n";
  return (face.empty() ? "" : face + "\n") + loads;
}

/// The line on an obstacle that deforms; empty for a rigid one.
static std::string describe_counterbody(const Parameters &parameters)
{
  const auto &kind = parameters.obstacle.kind;
  if (const auto material = kind.chosen().material())
    return "elastic " + kind.word() + ", " + material_text(*material);
  if (kind.chosen().is_body())
    return "elastic body (" + kind_of(parameters.lower.geometry).describe(parameters.lower.geometry) + "), " +
           material_text(parameters.lower.material);
  return kind == ObstacleKind::rigid ? "" : kind.word();
}

/// The line is empty for the rigid plane z = 0.
std::string describe_obstacle(const Parameters &parameters)
{
  const ObstacleOptions &obstacle = parameters.obstacle;
  const std::string below = describe_counterbody(parameters);
  const std::string file = obstacle.gap_file.empty() ? "" : " and that of " + shown_path(obstacle.gap_file);
  const bool is_of_bodies = obstacle.normal == ObstacleNormal::surface && obstacle.kind.chosen().is_body();
  const std::string along = is_of_bodies ? " more than the distance of both surfaces along the normals"
                            : obstacle.normal == ObstacleNormal::surface ? " along the normals of the body"
                                                                         : "";
  const std::string gap = !obstacle.distance.empty() ? "distance " + obstacle.distance
                          : obstacle.is_plane()      ? ""
                                                     : "gap " + obstacle.gap + file + along;
  if (below.empty() && gap.empty())
    return {};
  return "obstacle       " + below + (below.empty() || gap.empty() ? "" : "; ") + gap + "\n";
}

std::string describe_lower_mesh(const Parameters &parameters, const BodyUnknowns &unknowns)
{
  return "lower mesh     " + std::to_string(unknowns.size().cells) +
         (parameters.lower.geometry.is_plane_strain() ? " quadrilaterals" : " hexahedra") + " of degree " +
         std::to_string(parameters.lower.mesh.degree) + ", " + std::to_string(unknowns.size().free_dofs) +
         " unknowns, " + std::to_string(unknowns.contact_surface().nodes.size()) + " contact nodes";
}

std::string describe_steps(const LoadOptions &load)
{
  const std::size_t n_steps = LoadProgram(load).n_steps();
  std::string line = "load steps     " + std::to_string(n_steps);
  if (const auto n_parts = static_cast<std::size_t>(LoadProgram(load).n_solved_parts()); n_parts != n_steps)
    line += " in " + std::to_string(n_parts) + " parts";
  if (!load.program_file.empty())
    line += ", the rows of " + shown_path(load.program_file) + ", which have " +
            std::to_string(load.n_cycles()) + (load.n_cycles() == 1 ? " complete cycle" : " complete cycles");
  if (load.accuracy != 0)
    line += ", divided by the run for errors of " + to_text(load.accuracy) + " %";
  line += "\n";
  return line + describe_drive(load);
}

std::string describe_model(const ModelChoice &model)
{
  return "model          " + model.symmetry.full_name() + " (" + model.reason + ")\n";
}

std::string describe_friction(const Parameters &parameters)
{
  const std::string line = "friction       ";
  const FrictionOptions &friction = parameters.friction;
  if (friction.is_frictionless())
    return line + "none\n";
  const bool same_law = !friction.varying_angle && !friction.law.chosen().varies(friction);
  if (!same_law || !friction.has_ellipses())
  {
    std::string entries;
    const DeclaredParameters declared(parameters);
    for (const Entry &entry : declared.list.entries())
      if (entry.section() == "Friction" && entry.why_ignored().empty() && !entry.text().empty())
        entries += (entries.empty() ? "" : "; ") + entry.own_name() + " = " + entry.text();
    return line + (same_law ? "" : "varies: ") + entries + "\n";
  }
  const std::array<double, 2> p = friction.p();
  return line + "mu " + to_text(friction.mu[0]) + ", " + to_text(friction.mu[1]) +
         (friction.is_associated() ? "; associated"
                                   : "; not associated, p " + to_text(p[0]) + ", " + to_text(p[1])) +
         (friction.is_collinear() ? ", slip collinear with the force"
                                  : ", slip not collinear with the force") +
         (friction.first_axis ? "; first axis along " + friction.first_axis_text()
                              : "; axes turned by " + to_text(friction.angle) + " degrees") +
         (friction.has_factor() ? "; times " + friction.factor.text() + "\n" : "\n");
}

/// The cells, or the patches of a half-space.
static std::string describe_cells(const Parameters &parameters, const ModelSymmetry &symmetry,
                                  const BodyUnknowns &unknowns)
{
  const MeshOptions &mesh = parameters.mesh;
  if (!kind_of(parameters.geometry).is_meshed())
  {
    const SurfaceGrid grid = surface_grid(parameters.geometry, mesh);
    return "grid           " + std::to_string(grid.n_x) + " x " + std::to_string(grid.n_y) + " patches of " +
           to_text(grid.width) + " x " + to_text(grid.height) + " mm on a " +
           (grid.is_periodic ? "periodic half-space\n" : "half-space\n");
  }
  return "mesh           " + std::to_string(unknowns.size().cells) +
         (symmetry.is_section() ? " quadrilaterals" : " hexahedra") + " of degree " +
         std::to_string(mesh.degree) + ", " + std::to_string(mesh.n_quadrature_points()) +
         " Gauss points per direction" +
         (mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected
              ? ", divergence projected\n"
              : "\n");
}

std::string describe_model(const Parameters &parameters, const ModelChoice &model,
                           const BodyUnknowns &unknowns)
{
  const ContactSolverOptions &solver = parameters.contact_solver;
  std::ostringstream text;
  text << describe_model(model) << describe_materials(parameters)
       << describe_cells(parameters, model.symmetry, unknowns) << "unknowns       "
       << unknowns.size().free_dofs << " of " << unknowns.size().dofs << " degrees of freedom\n"
       << describe_obstacle(parameters) << "contact nodes  " << unknowns.contact_surface().nodes.size()
       << (model.symmetry.is_axisymmetric()   ? " (rings)"
           : model.symmetry.is_plane_strain() ? " (lines)"
                                              : "")
       << "\n"
       << describe_held(parameters) << describe_friction(parameters) << describe_steps(parameters.load)
       << (parameters.mesh.backend == BodyBackend::multigrid ? "elastic body   multigrid\n" : "")
       << "contact solver " << solver.method << ", tolerance " << to_text(solver.tolerance);
  return text.str();
}
} // namespace orthocone
