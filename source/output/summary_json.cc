// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/numbers.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/version.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/output/answers.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/parameters.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace orthocone
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

OrderedJson peak_json(const std::pair<double, unsigned int> &peak)
{
  return {{"value", peak.first}, {"step", peak.second}};
}

OrderedJson model_json(const Summary &summary)
{
  const BodyUnknowns &unknowns = summary.unknowns;
  OrderedJson planes = OrderedJson::array();
  const ModelSymmetry &symmetry = summary.model.symmetry;
  if (symmetry.planes().normal_to_x)
    planes.push_back("x = 0");
  if (symmetry.planes().normal_to_y)
    planes.push_back("y = 0");
  return {{"kind", symmetry.is_plane_strain() ? "plane strain" : symmetry.name()},
          {"reason", summary.model.reason},
          {"symmetry_planes", planes},
          {"backend", !kind_of(summary.parameters.geometry).is_meshed()           ? "half-space"
                      : summary.parameters.mesh.backend == BodyBackend::multigrid ? "multigrid"
                                                                                  : "condensed"},
          {"cells", unknowns.size().cells},
          {"degree", summary.parameters.mesh.degree},
          {"dofs", unknowns.size().dofs},
          {"free_dofs", unknowns.size().free_dofs},
          {"contact_nodes", unknowns.contact_surface().nodes.size()}};
}

OrderedJson seconds_json(const RunRecord &record)
{
  OrderedJson json;
  for (const auto &[name, phase] : phases)
    json[name] = record.seconds.*phase;
  json["total"] = record.total_seconds;
  return json;
}

OrderedJson cycles_summary(const CycleMemory &cycles)
{
  OrderedJson json{{"completed", cycles.n_completed}, {"jumped_steps", cycles.n_jumped_steps()}};
  json["change"] = cycles.n_completed > 0 ? OrderedJson(cycles.change) : OrderedJson();
  json["periodic_since_cycle"] =
      cycles.periodic_since > 0 ? OrderedJson(cycles.periodic_since) : OrderedJson();
  return json;
}

OrderedJson accuracy_json(const AccuracyEstimate &accuracy)
{
  OrderedJson json{{"wanted_percent", accuracy.wanted},
                   {"of", counted_text(accuracy.counted)},
                   {"reached", accuracy.is_reached()}};
  for (unsigned int i = 0; i < n_quantities; ++i)
    json[quantity_names[i]] = {{"value", accuracy.values[i]},
                               {"estimated_error_percent", accuracy.errors[i]}};
  return json;
}

/// Errors of each quantity, by their causes; null where nothing is known.
OrderedJson errors_json(const RunRecord &record)
{
  OrderedJson json;
  for (unsigned int i = 0; i < n_quantities; ++i)
  {
    OrderedJson &errors = json[quantity_names[i]];
    errors["mesh"] = record.accuracy ? OrderedJson(record.accuracy->errors[i]) : OrderedJson();
    errors["steps"] = record.steps ? OrderedJson(record.steps->estimate.errors[i]) : OrderedJson();
    errors["solver"] = record.steps ? OrderedJson(record.steps->solver[i]) : OrderedJson();
  }
  return json;
}

std::string entry_of(const Parameters &parameters, const std::string &name)
{
  for (const auto &[entry, value] : entry_values(parameters))
    if (entry == name)
      return value;
  return {};
}

/// Units of the entries that have one, which is what a page shows behind their numbers.
OrderedJson units_json()
{
  OrderedJson json;
  const DeclaredParameters declared;
  for (const Entry &entry : declared.list.entries())
    if (!entry.unit().empty())
      json[entry.name()] = entry.unit();
  return json;
}

/// Where friction varies, the numbers are those at the centre, and the expressions are beside them. A law
/// that is no ellipse has no such numbers.
OrderedJson friction_json(const Parameters &parameters)
{
  const FrictionOptions &friction = parameters.friction;
  OrderedJson json{{"law", friction.law.word()},
                   {"mu", friction.mu},
                   {"p", friction.p()},
                   {"associated", friction.is_associated()},
                   {"collinear", friction.is_collinear()},
                   {"angle_degrees", friction.angle}};
  if (!friction.has_ellipses())
    for (const char *const key : {"mu", "p", "associated", "collinear"})
      json.erase(key);
  else if (friction.varies())
    for (const char *const entry : {"Coefficients", "Slip potential", "Orthotropy angle"})
      json["expressions"][entry] = entry_of(parameters, std::string("Friction/") + entry);
  if (friction.has_factor())
    json["factor"] = friction.factor.text();
  return json;
}

OrderedJson outline_json(const GeometryOptions &geometry)
{
  if (geometry.is_from_file())
    return {{"shape", "file"}, {"mesh_file", geometry.mesh_file}};
  if (geometry.shape == BodyShape::box || geometry.shape == BodyShape::half_space)
    return {{"shape", "rectangle"}, {"sizes_mm", {geometry.sizes[0], geometry.sizes[1]}}};
  return {{"shape", "disc"}, {"radius_mm", geometry.radius}};
}

OrderedJson counterface_json(const Parameters &parameters)
{
  const auto &kind = parameters.obstacle.kind;
  OrderedJson json{{"kind", to_word(kind)}};
  if (kind.chosen().gives_way())
  {
    const MaterialOptions material = kind.chosen().material().value_or(parameters.lower.material).isotropic();
    json["young_modulus_MPa"] = material.young_modulus;
    json["poisson_ratio"] = material.poisson_ratio;
  }
  if (kind == ObstacleKind::body)
  {
    json["outline"] = outline_json(parameters.lower.geometry);
    if (!parameters.lower.geometry.is_from_file())
      json["height_mm"] = parameters.lower.geometry.held_height();
  }
  return json;
}

/// The body on the plane and its motion, so that nobody need guess them from the other files.
OrderedJson scene_json(const Summary &summary)
{
  const Parameters &parameters = summary.parameters;
  double area = 0;
  for (const ContactNode &node : summary.unknowns.contact_surface().nodes)
    area += summary.model.symmetry.n_copies() * node.area;
  return {
      {"outline", outline_json(parameters.geometry)},
      {"area_mm2", area},
      {"height_mm", parameters.geometry.is_from_file() ? summary.unknowns.held_centre()[2]
                                                       : parameters.geometry.held_height()},
      {"preload", entry_of(parameters, "Load program/Preload")},
      {"legs", entry_of(parameters, "Load program/Legs")},
      {"program_file", entry_of(parameters, "Load program/Program file")},
      {"cycles", parameters.load.cycles},
      {"friction", friction_json(parameters)},
      {"counterface", counterface_json(parameters)},
      {"gap", entry_of(parameters, "Obstacle/Gap")},
      {"gap_file", entry_of(parameters, "Obstacle/Gap file")},
      {"units",
       {{"length", "mm"}, {"force", "N"}, {"traction", "MPa"}, {"energy", "N mm"}, {"angle", "degrees"}}}};
}

OrderedJson energy_json(const RunRecord &record)
{
  return {{"work_Nmm", record.work},
          {"dissipation_Nmm", record.dissipation},
          {"stored_Nmm", record.stored},
          {"into_wear_Nmm", record.into_wear},
          {"missing_Nmm", record.missing},
          {"missing_percent_of_largest_energy", 100 * relative(record.missing, record.energy_scale())},
          {"missing_percent_of_dissipation", 100 * relative(record.missing, record.dissipation)}};
}

OrderedJson answers_json(const Summary &summary)
{
  OrderedJson json = OrderedJson::object();
  for (const Answer &answer : answers(summary))
  {
    json[answer.name] = {{"words", answer.words}, {"value", answer.value}, {"unit", answer.unit}};
    if (answer.step != 0)
      json[answer.name]["step"] = answer.step;
  }
  return json;
}

OrderedJson critical_friction_json(const CriticalFrictionRecord &critical)
{
  if (!std::isfinite(critical.factor))
    return {};
  return {{"factor", critical.factor}, {"node_mm", critical.position}};
}
} // namespace

std::string summary_json(const Summary &summary)
{
  OrderedJson json;
  json["status"] = summary.status;
  json["model"] = model_json(summary);
  json["scene"] = scene_json(summary);
  json["steps"] = {{"planned", summary.n_steps}, {"solved", summary.n_solved}};
  json["cycles"] = cycles_summary(summary.cycles);
  json["contact_solver"] = {{"method", summary.parameters.contact_solver.method},
                            {"tolerance", summary.parameters.contact_solver.tolerance},
                            {"iterations", summary.record.n_iterations},
                            {"largest_residual", summary.record.largest_residual},
                            {"verdict", to_word(summary.record.verdict)}};
  if (summary.record.folds.n > 0)
    json["contact_solver"]["first_fold_of_friction"] = summary.record.folds.first_share;
  if (summary.record.n_v_cycles > 0)
    json["contact_solver"]["v_cycles"] = summary.record.n_v_cycles;
  json["answers"] = answers_json(summary);
  json["peaks"] = {{"slip_mm", peak_json(summary.record.peaks.slip)},
                   {"pressure_MPa", peak_json(summary.record.peaks.pressure)},
                   {"force_z_N", peak_json(summary.record.peaks.force_z)}};
  json["friction"] = friction_json(summary.parameters);
  json["energy"] = energy_json(summary.record);
  json["critical_friction"] = critical_friction_json(summary.record.critical_friction);
  if (summary.record.accuracy)
    json["accuracy"] = accuracy_json(*summary.record.accuracy);
  if (summary.record.steps)
    json["step_accuracy"] = accuracy_json(summary.record.steps->estimate);
  if (summary.record.accuracy || summary.record.steps)
    json["estimated_errors_percent"] = errors_json(summary.record);
  json["warnings"] = all_warnings(summary.parameters, summary.record);
  json["total_dissipation_Nmm"] = summary.totals.total_dissipation;
  for (const auto &[name, version] : versions())
    json["versions"][name] = version;
  json["processes"] = n_ranks();
  json["units"] = units_json();
  json["threads"] = {{"number", summary.record.threads.number}, {"reason", summary.record.threads.reason}};
  json["seconds"] = seconds_json(summary.record);
  // Names of folders need not be UTF-8.
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string summary_json_with_status(const std::string &text, const std::string &status)
{
  OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object())
    return text;
  json["status"] = status;
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string summary_json_before_steps(const std::string &status, const Parameters &parameters)
{
  OrderedJson json;
  json["status"] = status;
  json["steps"] = {{"planned", LoadProgram(parameters.load).n_steps()}, {"solved", 0}};
  json["friction"] = friction_json(parameters);
  json["warnings"] = parameter_warnings(parameters);
  for (const auto &[name, version] : versions())
    json["versions"][name] = version;
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}
} // namespace orthocone
