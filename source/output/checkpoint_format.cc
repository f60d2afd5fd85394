// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The bytes of a checkpoint. CBOR keeps doubles to the last bit.
#include "checkpoint_json.h"

#include <boost/crc.hpp>

#include <sstream>

namespace orthocone
{
namespace
{
using Eigen::Index;
using namespace checkpoint_json;

constexpr const char *magic = "orthocone-checkpoint";

std::uint32_t checksum(const std::string &bytes)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

Json row_json(const CycleRow &row)
{
  return {{"cycle", row.cycle},
          {"peak_force_z", row.peak_force_z},
          {"max_slip", row.max_slip},
          {"last_step", row.last_step},
          {"work", row.work},
          {"into_wear", row.into_wear},
          {"missing", row.missing},
          {"iterations", row.iterations},
          {"factor", {row.least_factor, row.mean_factor, row.largest_factor}}};
}

/// The values that add up in a cycle; the rest of the row is known only at its end.
CycleRow row_from(const Json &json)
{
  CycleRow row;
  row.cycle = count_from(json.at("cycle"));
  row.last_step = count_from(json.at("last_step"));
  row.peak_force_z = number_from(json.at("peak_force_z"));
  row.max_slip = number_from(json.at("max_slip"));
  row.work = number_from(json.at("work"));
  row.into_wear = number_from(json.at("into_wear"));
  row.missing = number_from(json.at("missing"));
  row.iterations = count_from(json.at("iterations"));
  const Json &factor = json.at("factor");
  row.least_factor = number_from(factor.at(0));
  row.mean_factor = number_from(factor.at(1));
  row.largest_factor = number_from(factor.at(2));
  return row;
}

Json wear_json(const WearMemory &wear)
{
  return {{"rate", array_json(wear.rate)},
          {"n_jumped", wear.n_jumped},
          {"n_settled", wear.n_settled},
          {"error", wear.error}};
}

WearMemory wear_from(const Json &json, const ContactState &state)
{
  const Index n = json.at("rate").get_binary().empty() ? 0 : state.n_nodes(); // none before the first jump
  return {array_from(json.at("rate"), n), count_from(json.at("n_jumped")), count_from(json.at("n_settled")),
          number_from(json.at("error"))};
}

Json friction_json(const FrictionJumpMemory &friction)
{
  return {{"slip", array_json(friction.slip)},
          {"energy", array_json(friction.energy)},
          {"n_jumped", friction.n_jumped},
          {"n_settled", friction.n_settled},
          {"error", friction.error}};
}

FrictionJumpMemory friction_from(const Json &json, const ContactState &state)
{
  const Index n = json.at("slip").get_binary().empty() ? 0 : state.n_nodes(); // none before the first jump
  return {array_from(json.at("slip"), n), array_from(json.at("energy"), n), count_from(json.at("n_jumped")),
          count_from(json.at("n_settled")), number_from(json.at("error"))};
}

/// A column a point.
Json loop_json(const std::vector<LoopPoint> &loop)
{
  Eigen::MatrixXd numbers(6, loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
    numbers.col(i) << loop[i].motion, loop[i].force, loop[i].normal_force, loop[i].approach;
  return array_json(numbers.reshaped());
}

std::vector<LoopPoint> loop_from(const Json &json)
{
  const auto n = static_cast<Index>(json.get_binary().size() / (6 * sizeof(double)));
  const Eigen::VectorXd numbers = array_from(json, 6 * n);
  std::vector<LoopPoint> loop;
  for (Index first = 0; first < numbers.size(); first += 6)
    loop.push_back(
        {numbers.segment<2>(first), numbers.segment<2>(first + 2), numbers[first + 4], numbers[first + 5]});
  return loop;
}

Json cycles_json(const CycleMemory &cycles)
{
  Json jumped = Json::array();
  for (const StepRange &range : cycles.jumped)
    jumped.push_back({range.first, range.last});
  return {{"start", state_json(cycles.start)},
          {"start_dissipation", cycles.start_dissipation},
          {"largest_nodal_force", cycles.largest_nodal_force},
          {"largest_force", cycles.largest_force},
          {"row", row_json(cycles.row)},
          {"n_completed", cycles.n_completed},
          {"change", cycles.change},
          {"periodic_since", cycles.periodic_since},
          {"jumped", std::move(jumped)},
          {"loop", loop_json(cycles.loop)},
          {"wear", wear_json(cycles.wear)},
          {"friction", friction_json(cycles.friction)}};
}

CycleMemory cycles_from(const Json &json, const ContactState &state)
{
  CycleMemory cycles;
  cycles.start = state_from(json.at("start"));
  if (cycles.start.n_nodes() != state.n_nodes())
    throw CheckpointError("is damaged (an array has the wrong size)");
  cycles.start_dissipation = number_from(json.at("start_dissipation"));
  cycles.largest_nodal_force = number_from(json.at("largest_nodal_force"));
  cycles.largest_force = number_from(json.at("largest_force"));
  cycles.row = row_from(json.at("row"));
  cycles.n_completed = count_from(json.at("n_completed"));
  cycles.change = number_from(json.at("change"));
  cycles.periodic_since = count_from(json.at("periodic_since"));
  for (const Json &range : json.at("jumped"))
    cycles.jumped.push_back({count_from(range.at(0)), count_from(range.at(1))});
  cycles.loop = loop_from(json.at("loop"));
  cycles.wear = wear_from(json.at("wear"), state);
  cycles.friction = friction_from(json.at("friction"), state);
  return cycles;
}

Json accuracy_json(const std::optional<AccuracyEstimate> &accuracy)
{
  return accuracy ? Json{accuracy->wanted, accuracy->values, accuracy->errors, accuracy->steps_share,
                         accuracy->counted}
                  : Json();
}

std::optional<AccuracyEstimate> accuracy_from(const Json &json)
{
  if (json.is_null())
    return std::nullopt;
  return AccuracyEstimate{json.at(0), json.at(1), json.at(2), json.at(3), json.at(4)};
}

Json steps_json(const std::optional<StepAccuracy> &steps)
{
  return steps ? Json{accuracy_json(steps->estimate), steps->solver} : Json();
}

std::optional<StepAccuracy> step_accuracy_from(const Json &json)
{
  if (json.is_null())
    return std::nullopt;
  return StepAccuracy{accuracy_from(json.at(0)).value(), json.at(1)};
}

Json zones_json(const ZoneRecord &zones)
{
  return {zones.contact,           zones.load,   zones.rim_touches, zones.largest_force,
          zones.is_stick_resolved, zones.narrow, zones.grown};
}

ZoneRecord zones_from(const Json &json)
{
  ZoneRecord zones;
  zones.contact = json.at(0); // may be infinite
  zones.load = json.at(1);
  zones.rim_touches = json.at(2);
  zones.largest_force = number_from(json.at(3));
  zones.is_stick_resolved = json.at(4);
  zones.narrow = json.at(5);
  zones.grown = json.at(6);
  return zones;
}

Json peaks_json(Peaks peaks)
{
  Json json = Json::array();
  for (const Peaks::Peak *const peak : peaks.all())
    json.push_back(*peak);
  return json;
}

Json record_json(const RunRecord &record)
{
  Json seconds{{"total", record.total_seconds}};
  for (const auto &[name, phase] : phases)
    seconds[name] = record.seconds.*phase;
  return {{"n_iterations", record.n_iterations},
          {"n_v_cycles", record.n_v_cycles},
          {"n_threads", record.threads.number},
          {"largest_residual", record.largest_residual},
          {"largest_energy", record.largest_energy},
          {"energy_defect", record.energy_defect},
          {"wear_of_flattening", record.wear_of_flattening},
          {"slip_of_change", record.slip_of_change},
          {"factor", {record.change_of_factor, record.largest_factor, record.energy_of_fall}},
          {"motion", {record.flattening, record.pressure_of_modulus, record.slide_of_face, record.border}},
          {"zones", zones_json(record.zones)},
          {"energies", {record.work, record.dissipation, record.missing, record.into_wear, record.stored}},
          {"peaks", peaks_json(record.peaks)},
          {"accuracy", accuracy_json(record.accuracy)},
          {"step_accuracy", steps_json(record.steps)},
          {"seconds", std::move(seconds)}};
}

RunRecord record_from(const Json &json)
{
  RunRecord record;
  record.n_iterations = count_from(json.at("n_iterations"));
  record.n_v_cycles = count_from(json.at("n_v_cycles"));
  record.threads.number = count_from(json.at("n_threads"));
  record.largest_residual = number_from(json.at("largest_residual"));
  record.largest_energy = number_from(json.at("largest_energy"));
  record.energy_defect = json.at("energy_defect");
  record.wear_of_flattening = json.at("wear_of_flattening");
  record.slip_of_change = json.at("slip_of_change");
  record.change_of_factor = json.at("factor").at(0);
  record.largest_factor = json.at("factor").at(1);
  record.energy_of_fall = json.at("factor").at(2);
  const Json &motion = json.at("motion");
  record.flattening = motion.at(0);
  record.pressure_of_modulus = motion.at(1);
  record.slide_of_face = motion.at(2);
  record.border = motion.at(3);
  record.zones = zones_from(json.at("zones"));
  const Json &energies = json.at("energies");
  record.work = number_from(energies.at(0));
  record.dissipation = number_from(energies.at(1));
  record.missing = number_from(energies.at(2));
  record.into_wear = number_from(energies.at(3));
  record.stored = number_from(energies.at(4));
  const Json &peaks = json.at("peaks");
  std::size_t place = 0;
  for (Peaks::Peak *const peak : record.peaks.all())
    *peak = peaks.at(place++).get<Peaks::Peak>();
  record.accuracy = accuracy_from(json.at("accuracy"));
  record.steps = step_accuracy_from(json.at("step_accuracy"));
  const Json &seconds = json.at("seconds");
  for (const auto &[name, phase] : phases)
    record.seconds.*phase = seconds.at(name);
  record.total_seconds = seconds.at("total");
  return record;
}

Checkpoint from_json(const Json &json)
{
  Checkpoint checkpoint;
  json.at("parameters").get_to(checkpoint.parameters);
  json.at("chosen").get_to(checkpoint.chosen);
  checkpoint.gap_file = count_from(json.at("gap_file"));
  json.at("program").get_to(checkpoint.program);
  checkpoint.tables = tables_from(json.at("tables"));
  checkpoint.fields = {steps_from(json.at("fields").at(0)), steps_from(json.at("fields").at(1)),
                       line_steps_from(json.at("fields").at(2))};
  checkpoint.state = state_from(json.at("state"));
  checkpoint.starts = starts_from(json.at("starts"), checkpoint.state);
  checkpoint.cycles = cycles_from(json.at("cycles"), checkpoint.state);
  checkpoint.record = record_from(json.at("record"));
  checkpoint.n_ranks = count_from(json.at("n_ranks"));
  return checkpoint;
}
} // namespace

std::string encode(const Checkpoint &checkpoint)
{
  const Json json{{"parameters", checkpoint.parameters},
                  {"chosen", checkpoint.chosen},
                  {"gap_file", checkpoint.gap_file},
                  {"program", checkpoint.program},
                  {"tables", tables_json(checkpoint.tables)},
                  {"fields",
                   {steps_json(checkpoint.fields.contact), steps_json(checkpoint.fields.volume),
                    line_steps_json(checkpoint.fields.lines)}},
                  {"state", state_json(checkpoint.state)},
                  {"starts", starts_json(checkpoint.starts)},
                  {"cycles", cycles_json(checkpoint.cycles)},
                  {"record", record_json(checkpoint.record)},
                  {"n_ranks", checkpoint.n_ranks}};
  std::string content;
  Json::to_cbor(json, content);
  std::ostringstream bytes;
  bytes << magic << " " << checkpoint_format << " " << content.size() << " " << checksum(content) << "\n"
        << content;
  return bytes.str();
}

Checkpoint decode(const std::string &bytes)
{
  std::istringstream header(bytes.substr(0, bytes.find('\n')));
  std::string word;
  unsigned int version = 0;
  std::size_t size = 0;
  std::uint32_t sum = 0;
  if (!(header >> word >> version >> size >> sum) || word != magic)
    throw CheckpointError("is not a checkpoint");
  if (version != checkpoint_format)
    throw CheckpointError("has format version " + std::to_string(version) +
                          ", and this program reads version " + std::to_string(checkpoint_format));
  const std::string content = bytes.substr(std::min(bytes.size(), bytes.find('\n') + 1));
  if (content.size() != size)
    throw CheckpointError("is cut off: it has " + std::to_string(content.size()) + " bytes of " +
                          std::to_string(size));
  if (checksum(content) != sum)
    throw CheckpointError("is damaged (its checksum is wrong)");
  try
  {
    return from_json(json_from_cbor(content));
  }
  catch (const Json::exception &)
  {
    throw CheckpointError("is damaged (its content is not understood)");
  }
}
} // namespace orthocone
