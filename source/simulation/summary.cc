// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/summary.h>

#include <orthocone/parameters/text.h>
#include <orthocone/simulation/version.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace orthocone
{
namespace
{
using Json = nlohmann::ordered_json;

Json peak_json(const std::pair<double, unsigned int> &peak)
{
  return {{"value", peak.first}, {"step", peak.second}};
}

Json model_json(const Summary &summary)
{
  const Discretization &discretization = summary.discretization;
  return {{"kind", summary.model.planes.name()},
          {"reason", summary.model.reason},
          {"cells", discretization.dof_handler().get_triangulation().n_active_cells()},
          {"degree", discretization.fe().degree},
          {"dofs", discretization.n_dofs()},
          {"free_dofs", discretization.n_free()},
          {"contact_nodes", discretization.contact_surface().nodes.size()}};
}

Json seconds_json(const Summary &summary)
{
  const PhaseSeconds &seconds = summary.seconds;
  return {{"mesh", seconds.mesh},
          {"assembly", seconds.assembly},
          {"factorization", seconds.factorization},
          {"condensation", seconds.condensation},
          {"contact", seconds.contact},
          {"output", seconds.output},
          {"total", summary.total_seconds}};
}

void consider(std::pair<double, unsigned int> &peak, const double value, const unsigned int step)
{
  if (value > peak.first)
    peak = {value, step};
}
} // namespace

void Peaks::consider(const unsigned int step, const Totals &totals)
{
  orthocone::consider(slip, totals.max_slip, step);
  orthocone::consider(pressure, totals.max_pressure, step);
  orthocone::consider(force_z, totals.force[2], step);
}

std::string summary_json(const Summary &summary)
{
  Json json;
  json["status"] = summary.status;
  json["model"] = model_json(summary);
  json["steps"] = {{"planned", summary.n_steps}, {"solved", summary.n_solved}};
  json["contact_solver"] = {{"method", to_word(summary.parameters.contact_solver.method)},
                            {"tolerance", summary.parameters.contact_solver.tolerance},
                            {"iterations", summary.n_iterations},
                            {"largest_residual", summary.largest_residual}};
  json["peaks"] = {{"slip_mm", peak_json(summary.peaks.slip)},
                   {"pressure_MPa", peak_json(summary.peaks.pressure)},
                   {"force_z_N", peak_json(summary.peaks.force_z)}};
  json["total_dissipation_Nmm"] = summary.total_dissipation;
  for (const auto &[name, version] : versions())
    json["versions"][name] = version;
  json["seconds"] = seconds_json(summary);
  return json.dump(2) + "\n";
}

std::string describe_model(const Parameters &parameters, const ModelChoice &model,
                           const Discretization &discretization, const unsigned int n_steps)
{
  const ContactSolverOptions &solver = parameters.contact_solver;
  std::ostringstream text;
  text << "model          " << model.planes.name() << " (" << model.reason << ")\n"
       << "mesh           " << discretization.dof_handler().get_triangulation().n_active_cells()
       << " hexahedra of degree " << discretization.fe().degree << ", "
       << discretization.n_quadrature_points() << " Gauss points per direction\n"
       << "unknowns       " << discretization.n_free() << " of " << discretization.n_dofs()
       << " degrees of freedom\n"
       << "contact nodes  " << discretization.contact_surface().nodes.size() << "\n"
       << "load steps     " << n_steps << "\n"
       << "contact solver " << to_word(solver.method) << ", tolerance " << to_text(solver.tolerance);
  return text.str();
}
} // namespace orthocone
