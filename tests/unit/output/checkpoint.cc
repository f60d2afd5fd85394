// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "output/scratch_folder.h"
#include "results/scenes.h"

#include <orthocone/base/errors.h>
#include <orthocone/output/checkpoint.h>
#include <orthocone/parameters/parameters.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include <cstring>
#include <limits>
#include <sstream>

namespace orthocone::test
{
namespace
{
CycleMemory cycles_after(const ContactState &state)
{
  CycleMemory cycles(state.n_nodes());
  cycles.start = state;
  cycles.start_dissipation = 1. / 3;
  cycles.largest_nodal_force = 2. / 7;
  cycles.largest_force = 3. / 7;
  cycles.row.cycle = 3;
  cycles.row.work = 0.1;
  cycles.n_completed = 2;
  cycles.change = 1. / 9;
  cycles.periodic_since = 1;
  cycles.jumped = {{16, 30}, {46, 60}};
  return cycles;
}

/// The checkpoint that a run of a scene would write after its step `number`.
Checkpoint checkpoint_after(const unsigned int number, const Parameters &parameters = small_scene())
{
  TestScene scene(parameters);
  StepSolver solver(scene.scene);
  Checkpoint checkpoint;
  for (const LoadStep &step : load_steps(parameters.load))
    if (step.number <= number)
    {
      const ContactState before = scene.state;
      const Totals totals = scene.totals();
      const SolverReport report = solver.solve(scene.state, step);
      EXPECT_TRUE(report.converged);
      solver.accept(before, scene.state, step);
      checkpoint.record.add_step(step.number, totals, scene.totals(), report, {});
    }
  checkpoint.parameters = entry_values(parameters);
  checkpoint.chosen = entry_values(parameters);
  checkpoint.record.accuracy =
      AccuracyEstimate{1, {{1, 2, 3, 4, 5}}, {{0.1, 0.2, 0.3, 0.4, 0.5}}, {{0, 0, 0.1}}};
  checkpoint.record.steps = StepAccuracy{{2, {{5, 4, 3, 2, 1}}, {{0.5}}, {}}, {{1e-6, 1e-7}}};
  checkpoint.program = "1.2.3 (abc)";
  checkpoint.tables = {{"history.csv", {1234, 0xfedcba98}}, {"probe-P.csv", {5, 7}}};
  checkpoint.fields = {{1, 2, 3, 5, 10, 15, 16}, {}};
  checkpoint.state = scene.state;
  checkpoint.starts = solver.memory();
  checkpoint.cycles = cycles_after(scene.state);
  checkpoint.record.energy_defect = {0.7, 2};
  checkpoint.record.missing = 1. / 11;
  checkpoint.record.seconds.contact = 0.1;
  checkpoint.record.total_seconds = 2. / 3;
  return checkpoint;
}

/// Content behind a header that fits.
std::string with_header(const std::string &content)
{
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return "orthocone-checkpoint " + std::to_string(checkpoint_format) + " " + std::to_string(content.size()) +
         " " + std::to_string(crc.checksum()) + "\n" + content;
}

std::string complaint(const std::string &bytes)
{
  try
  {
    decode(bytes);
    return "none";
  }
  catch (const CheckpointError &error)
  {
    return error.what();
  }
}
} // namespace

// A search for a mesh marches through the first cycle before the run begins.
TEST(Checkpoint, OfNoStepYetMayKnowStartForces)
{
  Checkpoint before = checkpoint_after(0);
  EXPECT_EQ(decode(encode(before)).starts.change.size(), 0);
  before.starts.change = NodeVector::LinSpaced(3 * before.state.n_nodes() + n_rigid_components, 0, 1);
  before.starts.of_phase[2] = before.starts.change;
  const StartMemory after = decode(encode(before)).starts;
  EXPECT_EQ(after.change, before.starts.change);
  EXPECT_EQ(after.of_phase, before.starts.of_phase);
}

TEST(Checkpoint, KeepsBodiesAndCoarserMarches)
{
  Checkpoint before = checkpoint_after(7);
  before.starts.bodies = {NodeVector::LinSpaced(5, 0, 1. / 7), NodeVector::LinSpaced(5, 1, 1. / 9)};
  before.starts.coarser = {{before.state, before.starts}};
  const Checkpoint after = decode(encode(before));
  EXPECT_EQ(after.starts.bodies, before.starts.bodies);
  ASSERT_EQ(after.starts.coarser.size(), 1u);
  EXPECT_EQ(after.starts.coarser.front().state.force, before.state.force);
  EXPECT_EQ(after.starts.coarser.front().starts.bodies, before.starts.bodies);
  EXPECT_TRUE(after.starts.coarser.front().starts.coarser.empty());
}

TEST(Checkpoint, KeepsEverythingToTheLastBit)
{
  Checkpoint before = checkpoint_after(7);
  before.starts.drift[3] = NodeVector::LinSpaced(3 * before.state.n_nodes() + n_rigid_components, -1, 1. / 3);
  const Checkpoint after = decode(encode(before));
  EXPECT_EQ(after.parameters, before.parameters);
  EXPECT_EQ(after.program, before.program);
  EXPECT_EQ(after.tables, before.tables);
  EXPECT_EQ(after.fields.contact, before.fields.contact);
  EXPECT_EQ(after.fields.volume, before.fields.volume);
  EXPECT_EQ(after.record.missing, before.record.missing);
  EXPECT_EQ(after.state.step, 7u);
  EXPECT_EQ(after.state.motion, before.state.motion);
  EXPECT_EQ(after.state.force, before.state.force);
  EXPECT_EQ(after.state.displacement, before.state.displacement);
  EXPECT_EQ(after.state.accumulated_slip, before.state.accumulated_slip);
  EXPECT_EQ(after.state.dissipated_energy, before.state.dissipated_energy);
  EXPECT_EQ(after.state.status, before.state.status);
  EXPECT_EQ(after.starts.change, before.starts.change);
  EXPECT_EQ(after.starts.of_phase, before.starts.of_phase);
  EXPECT_EQ(after.starts.drift, before.starts.drift);
  EXPECT_EQ(after.cycles.start.accumulated_slip, before.cycles.start.accumulated_slip);
  EXPECT_EQ(after.cycles.start_dissipation, before.cycles.start_dissipation);
  EXPECT_EQ(after.cycles.largest_nodal_force, before.cycles.largest_nodal_force);
  EXPECT_EQ(after.cycles.largest_force, before.cycles.largest_force);
  EXPECT_EQ(after.cycles.row.cycle, before.cycles.row.cycle);
  EXPECT_EQ(after.cycles.row.work, before.cycles.row.work);
  EXPECT_EQ(after.cycles.n_completed, before.cycles.n_completed);
  EXPECT_EQ(after.cycles.change, before.cycles.change);
  EXPECT_EQ(after.cycles.periodic_since, before.cycles.periodic_since);
  EXPECT_EQ(after.cycles.jumped, before.cycles.jumped);
  EXPECT_EQ(after.record.n_iterations, before.record.n_iterations);
  EXPECT_EQ(after.record.largest_residual, before.record.largest_residual);
  EXPECT_EQ(after.record.largest_energy, before.record.largest_energy);
  EXPECT_EQ(after.record.peaks.pressure, before.record.peaks.pressure);
  EXPECT_EQ(after.record.energy_defect, before.record.energy_defect);
  EXPECT_EQ(after.record.seconds.contact, before.record.seconds.contact);
  EXPECT_EQ(after.record.total_seconds, before.record.total_seconds);
  EXPECT_EQ(encode(after), encode(before));
  EXPECT_EQ(decode(encode(checkpoint_after(0))).state.step, 0u);
}

TEST(Checkpoint, IsRefusedIfAnythingIsMissingOrChanged)
{
  const std::string bytes = encode(checkpoint_after(2));
  ASSERT_EQ(complaint(bytes), "none");
  const std::size_t header = bytes.find('\n') + 1;
  for (std::size_t size = 0; size < bytes.size(); size += size < 2 * header ? 1 : 97)
  {
    const std::string text = complaint(bytes.substr(0, size));
    EXPECT_TRUE(text == "is not a checkpoint" || text.find("is cut off") == 0) << size << " " << text;
  }
  EXPECT_EQ(complaint(bytes + "x").find("is cut off"), 0u);
  for (std::size_t place = 0; place < bytes.size(); place += place < header ? 1 : 53)
    for (const char flip : {1, 64})
    {
      std::string changed = bytes;
      changed[place] = static_cast<char>(changed[place] ^ flip);
      EXPECT_NE(complaint(changed), "none") << place;
    }
  EXPECT_EQ(complaint(""), "is not a checkpoint");
  EXPECT_EQ(complaint("subsection Mesh\n"), "is not a checkpoint");
}

namespace
{
/// A checkpoint whose content is `json`, with the checksum that belongs to it.
std::string with_content(const nlohmann::json &json)
{
  std::string content;
  nlohmann::json::to_cbor(json, content);
  return with_header(content);
}

nlohmann::json content_of(const std::string &bytes)
{
  return nlohmann::json::from_cbor(bytes.substr(bytes.find('\n') + 1));
}
} // namespace

// A checksum can be right although the content is not.
TEST(Checkpoint, ContentIsBoundedAndChecked)
{
  const nlohmann::json good = content_of(encode(checkpoint_after(2)));
  ASSERT_EQ(complaint(with_content(good)), "none");
  for (const nlohmann::json &step : {nlohmann::json(-1), nlohmann::json(1ULL << 40), nlohmann::json(2.5),
                                     nlohmann::json("two"), nlohmann::json()})
    for (const char *const place : {"/state/step", "/state/n_nodes", "/cycles/n_completed",
                                    "/cycles/row/cycle", "/record/n_iterations"})
    {
      nlohmann::json bad = good;
      bad[nlohmann::json::json_pointer(place)] = step;
      EXPECT_EQ(complaint(with_content(bad)).find("is damaged"), 0u) << place << " " << step;
    }
  nlohmann::json bad = good;
  bad["cycles"]["change"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(with_content(bad)).find("is damaged"), 0u);
  bad = good;
  std::vector<std::uint8_t> &force = bad["state"]["force"].get_binary();
  const double infinity = std::numeric_limits<double>::infinity();
  std::memcpy(force.data(), &infinity, sizeof(infinity));
  EXPECT_EQ(complaint(with_content(bad)), "is damaged (a number is not finite)");
  bad = good;
  bad["fields"][0] = {{1, 1, 4000000000U}};
  EXPECT_EQ(complaint(with_content(bad)).find("is damaged"), 0u);
}

TEST(Checkpoint, NestedContentDoesNotOverflowTheStack)
{
  constexpr char array_of_one = '\x81';
  EXPECT_EQ(complaint(with_header(std::string(200000, array_of_one) + '\0')),
            "is damaged (its content is not understood)");
}

TEST(Checkpoint, OfAnotherFormatIsRefused)
{
  std::string bytes = encode(checkpoint_after(1));
  const std::size_t place = bytes.find(' ') + 1;
  ASSERT_EQ(bytes.substr(place, 2), std::to_string(checkpoint_format) + " ");
  bytes[place] = '9';
  EXPECT_EQ(complaint(bytes),
            "has format version 9, and this program reads version " + std::to_string(checkpoint_format));
}

TEST(Checkpoint, KeepsTheChecksumOfTheGapFile)
{
  Checkpoint before = checkpoint_after(1);
  before.gap_file = 0xfedcba97;
  EXPECT_EQ(decode(encode(before)).gap_file, before.gap_file);
}

TEST(Checkpoint, IsFoundByTheSameParametersOnly)
{
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path);
  const Parameters parameters = small_scene();
  EXPECT_FALSE(find_checkpoint(folder, parameters, "x.prm"));
  folder.append("history.csv", "one\n");
  Checkpoint checkpoint = checkpoint_after(3);
  checkpoint.tables = folder.tables();
  checkpoint.fields = {};
  write_checkpoint(folder, checkpoint);
  EXPECT_EQ(find_checkpoint(folder, parameters, "x.prm")->state.step, 3u);

  Parameters other = parameters;
  other.mesh.degree = 2;
  try
  {
    find_checkpoint(folder, other, "x.prm");
    FAIL() << "another degree was accepted";
  }
  catch (const InputError &error)
  {
    EXPECT_EQ(std::string(error.what()).find("x.prm: Mesh/Degree = 2, but the run in "), 0u) << error.what();
  }
  // Entries that change how a step is solved, watched or kept, not what is computed.
  other = parameters;
  other.contact_solver.method = "gauss-seidel";
  other.contact_solver.maximum_iterations = 7;
  other.output.checkpoint_seconds = 100;
  other.checks.energy_defect = 0.5;
  EXPECT_TRUE(find_checkpoint(folder, other, "x.prm"));
}

TEST(Checkpoint, WithoutOneTheFolderMustHaveNothingToLose)
{
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path);
  std::ostringstream text;
  write_parameters(small_scene(), text);
  folder.write("parameters.prm", text.str());
  EXPECT_FALSE(find_checkpoint(folder, small_scene(), "x.prm"));
  EXPECT_NO_THROW(require_nothing_to_lose(folder, small_scene()));
  EXPECT_NO_THROW(require_nothing_to_lose(folder, small_scene(2))); // there are no results yet
  folder.append("history.csv", "one\n");
  EXPECT_NO_THROW(require_nothing_to_lose(folder, small_scene()));
  EXPECT_THROW(require_nothing_to_lose(folder, small_scene(2)), FileError);
}
} // namespace orthocone::test
