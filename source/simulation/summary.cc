// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/summary.h>

#include <orthocone/contact/law_errors.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/text.h>
#include <orthocone/simulation/load_program.h>
#include <orthocone/simulation/version.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

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
  const BodyUnknowns &unknowns = summary.unknowns;
  return {{"kind", summary.model.symmetry.name()},
          {"reason", summary.model.reason},
          {"cells", unknowns.n_cells()},
          {"degree", summary.parameters.mesh.degree},
          {"dofs", unknowns.n_dofs()},
          {"free_dofs", unknowns.n_free()},
          {"contact_nodes", unknowns.contact_surface().nodes.size()}};
}

Json seconds_json(const RunRecord &record)
{
  Json json;
  for (const auto &[name, phase] : phases)
    json[name] = record.seconds.*phase;
  json["total"] = record.total_seconds;
  return json;
}

Json cycles_json(const CycleMemory &cycles)
{
  Json json{{"completed", cycles.n_completed}, {"jumped_steps", cycles.n_jumped_steps()}};
  json["change"] = cycles.n_completed > 0 ? Json(cycles.change) : Json();
  json["periodic_since_cycle"] = cycles.periodic_since > 0 ? Json(cycles.periodic_since) : Json();
  return json;
}

Json accuracy_json(const AccuracyEstimate &accuracy)
{
  Json json{{"wanted_percent", accuracy.wanted}, {"reached", accuracy.is_reached()}};
  for (unsigned int i = 0; i < n_quantities; ++i)
    json[quantity_names[i]] = {{"value", accuracy.values[i]},
                               {"estimated_error_percent", accuracy.errors[i]}};
  return json;
}

Json friction_json(const FrictionOptions &friction)
{
  return {{"mu", friction.mu},
          {"p", friction.p()},
          {"associated", friction.is_associated()},
          {"collinear", friction.is_collinear()},
          {"angle_degrees", friction.angle}};
}

Json energy_json(const RunRecord &record)
{
  return {{"work_Nmm", record.work},
          {"dissipation_Nmm", record.dissipation},
          {"missing_Nmm", record.missing},
          {"missing_percent_of_dissipation", 100 * relative(record.missing, record.dissipation)}};
}

Json critical_friction_json(const CriticalFrictionRecord &critical)
{
  if (!std::isfinite(critical.factor))
    return {};
  return {{"factor", critical.factor}, {"node_mm", critical.position}};
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

void PhaseSeconds::add(const PhaseSeconds &other)
{
  for (const auto &[name, phase] : phases)
    this->*phase += other.*phase;
}

double PhaseSeconds::sum() const
{
  double sum = 0;
  for (const auto &[name, phase] : phases)
    sum += this->*phase;
  return sum;
}

void RunRecord::add_step(const unsigned int step, const Totals &before, const Totals &totals,
                         const SolverReport &report, const StepChecks &checks)
{
  work += checks.work;
  dissipation += totals.total_dissipation - before.total_dissipation;
  missing += checks.energy_defect * checks.energy;
  n_iterations += report.iterations;
  largest_residual = std::max(largest_residual, report.residual);
  largest_energy = checks.energy;
  peaks.consider(step, totals);
  consider(energy_defect, checks.energy_defect, step);
}

std::string describe(const CriticalFrictionRecord &critical)
{
  std::ostringstream text;
  text << std::setprecision(3) << "critical friction ";
  if (!std::isfinite(critical.factor))
    text << "none: there is no friction, or normal and tangential directions are not coupled";
  else
    text << critical.factor << " times the given one, at (" << critical.position[0] << ", "
         << critical.position[1] << ") mm";
  return text.str();
}

std::vector<std::string> model_warnings(const RunRecord &record)
{
  if (record.critical_friction.factor > 1)
    return {};
  return {
      describe(record.critical_friction) +
      ": a node can wedge there, and a load step may have several solutions, or none that a solver finds; "
      "compare runs with other steps and methods before a result is trusted"};
}

std::vector<std::string> all_warnings(const Parameters &parameters, const RunRecord &record)
{
  constexpr double large = 0.05;
  constexpr double percent = 100;
  std::vector<std::string> warnings = parameter_warnings(parameters);
  for (std::string &warning : model_warnings(record))
    warnings.push_back(std::move(warning));
  if (record.energy_defect.first > large)
    warnings.push_back("load step " + std::to_string(record.energy_defect.second) +
                       ": the energy balance misses " +
                       to_text(std::round(percent * record.energy_defect.first)) +
                       " % of the largest energy; loops and dissipation need more steps in this leg");
  if (record.accuracy && !record.accuracy->is_reached())
    warnings.push_back("Mesh/Accuracy = " + to_text(record.accuracy->wanted) +
                       " % is not reached on the finest mesh: " + describe(*record.accuracy));
  return warnings;
}

std::string describe_seconds(const RunRecord &record)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "seconds: ";
  for (const auto &[name, phase] : phases)
    text << name << " " << record.seconds.*phase << ", ";
  text << "total " << record.total_seconds;
  return text.str();
}

std::string summary_json(const Summary &summary)
{
  Json json;
  json["status"] = summary.status;
  json["model"] = model_json(summary);
  json["steps"] = {{"planned", summary.n_steps}, {"solved", summary.n_solved}};
  json["cycles"] = cycles_json(summary.cycles);
  json["contact_solver"] = {{"method", to_word(summary.parameters.contact_solver.method)},
                            {"tolerance", summary.parameters.contact_solver.tolerance},
                            {"iterations", summary.record.n_iterations},
                            {"largest_residual", summary.record.largest_residual},
                            {"verdict", to_word(summary.record.verdict)}};
  json["peaks"] = {{"slip_mm", peak_json(summary.record.peaks.slip)},
                   {"pressure_MPa", peak_json(summary.record.peaks.pressure)},
                   {"force_z_N", peak_json(summary.record.peaks.force_z)}};
  json["friction"] = friction_json(summary.parameters.friction);
  json["energy"] = energy_json(summary.record);
  json["critical_friction"] = critical_friction_json(summary.record.critical_friction);
  if (summary.record.accuracy)
    json["accuracy"] = accuracy_json(*summary.record.accuracy);
  json["warnings"] = all_warnings(summary.parameters, summary.record);
  json["total_dissipation_Nmm"] = summary.total_dissipation;
  for (const auto &[name, version] : versions())
    json["versions"][name] = version;
  json["seconds"] = seconds_json(summary.record);
  // Names of folders need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_json_before_steps(const std::string &status, const Parameters &parameters)
{
  Json json;
  json["status"] = status;
  json["steps"] = {{"planned", load_steps(parameters.load).size()}, {"solved", 0}};
  json["friction"] = friction_json(parameters.friction);
  json["warnings"] = parameter_warnings(parameters);
  for (const auto &[name, version] : versions())
    json["versions"][name] = version;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string describe_energy(const RunRecord &record)
{
  std::ostringstream text;
  text << std::setprecision(4) << "energy: work of the upper face " << record.work << " N mm, dissipated "
       << record.dissipation << " N mm, missing " << record.missing << " N mm";
  if (record.dissipation > 0)
    text << " (" << std::setprecision(2) << 100 * record.missing / record.dissipation
         << " % of the dissipated)";
  return text.str();
}

std::string describe_model(const ModelChoice &model)
{
  return "model          " + model.symmetry.name() + " (" + model.reason + ")\n";
}

std::string describe_friction(const FrictionOptions &friction)
{
  const std::string line = "friction       ";
  if (friction.is_frictionless())
    return line + "none\n";
  const std::array<double, 2> p = friction.p();
  return line + "mu " + to_text(friction.mu[0]) + ", " + to_text(friction.mu[1]) +
         (friction.is_associated() ? "; associated"
                                   : "; not associated, p " + to_text(p[0]) + ", " + to_text(p[1])) +
         (friction.is_collinear() ? ", slip collinear with the force"
                                  : ", slip not collinear with the force") +
         "; axes turned by " + to_text(friction.angle) + " degrees\n";
}

std::string describe_model(const Parameters &parameters, const ModelChoice &model,
                           const BodyUnknowns &unknowns, const unsigned int n_steps)
{
  const ContactSolverOptions &solver = parameters.contact_solver;
  std::ostringstream text;
  text << describe_model(model) << "mesh           " << unknowns.n_cells()
       << (model.symmetry.is_axisymmetric() ? " quadrilaterals" : " hexahedra") << " of degree "
       << parameters.mesh.degree << ", " << parameters.mesh.n_quadrature_points()
       << " Gauss points per direction"
       << (parameters.mesh.volumetric_quadrature == VolumetricQuadrature::reduced
               ? ", volumetric part reduced\n"
               : "\n")
       << "unknowns       " << unknowns.n_free() << " of " << unknowns.n_dofs() << " degrees of freedom\n"
       << "contact nodes  " << unknowns.contact_surface().nodes.size()
       << (model.symmetry.is_axisymmetric() ? " (rings)" : "") << "\n"
       << describe_friction(parameters.friction) << "load steps     " << n_steps << "\n"
       << "contact solver " << to_word(solver.method) << ", tolerance " << to_text(solver.tolerance);
  return text.str();
}
} // namespace orthocone
