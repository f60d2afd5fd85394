// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "output/checkpoints.h"

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include <cstring>
#include <limits>
#include <sstream>

namespace orthocone::test
{
namespace
{
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
  before.starts.body_of_phase[4] = NodeVector::LinSpaced(5, 2, 1. / 11);
  before.starts.coarser = {{before.state, before.starts}};
  const Checkpoint after = decode(encode(before));
  EXPECT_EQ(after.starts.bodies, before.starts.bodies);
  EXPECT_EQ(after.starts.body_of_phase, before.starts.body_of_phase);
  ASSERT_EQ(after.starts.coarser.size(), 1u);
  EXPECT_EQ(after.starts.coarser.front().state.force, before.state.force);
  EXPECT_EQ(after.starts.coarser.front().starts.bodies, before.starts.bodies);
  EXPECT_TRUE(after.starts.coarser.front().starts.coarser.empty());
}

// A mesh with seven refinements and seven rounds of halved cells has fourteen coarser ones.
TEST(Checkpoint, KeepsManyLevels)
{
  constexpr unsigned int n_levels = 14;
  Checkpoint before = checkpoint_after(7);
  for (unsigned int level = 1; level <= n_levels; ++level)
  {
    StartMemory starts = std::move(before.starts);
    starts.bodies = {NodeVector::Constant(level, 1. / level)};
    before.starts = checkpoint_after(7).starts;
    before.starts.coarser = {{before.state, std::move(starts)}};
  }
  const Checkpoint after = decode(encode(before));
  const std::vector<MarchMemory> *coarser = &after.starts.coarser;
  for (unsigned int level = n_levels; level > 0; --level)
  {
    ASSERT_EQ(coarser->size(), 1u);
    const StartMemory &starts = coarser->front().starts;
    EXPECT_EQ(starts.bodies, std::vector<Eigen::VectorXd>{NodeVector::Constant(level, 1. / level)});
    coarser = &starts.coarser;
  }
  EXPECT_TRUE(coarser->empty());
}

TEST(Checkpoint, KeepsTheStepsOfLines)
{
  const Checkpoint before = checkpoint_after(1);
  EXPECT_EQ(decode(encode(before)).fields.lines, before.fields.lines);
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
  const std::string format = std::to_string(checkpoint_format);
  ASSERT_EQ(bytes.substr(place, format.size() + 1), format + " ");
  bytes.replace(place, format.size(), "7");
  EXPECT_EQ(complaint(bytes), "has format version 7, and this program reads version " + format);
}

TEST(Checkpoint, KeepsWhatSearchesAndThreadsAre)
{
  Checkpoint before = checkpoint_after(1);
  before.record.threads = {3, "--threads"};
  before.record.flattening = {0.06, 4};
  before.record.slide_of_face = {1.5, 5};
  before.record.border = {0.02, 6};
  before.record.zones.contact = std::numeric_limits<double>::infinity();
  before.record.zones.is_stick_resolved = true;
  before.record.zones.narrow = {3, 6};
  EXPECT_NE(before.state.work, 0);
  const Checkpoint after = decode(encode(before));
  EXPECT_EQ(after.state.work, before.state.work);
  EXPECT_EQ(after.chosen, before.chosen);
  EXPECT_EQ(after.record.threads.number, 3u);
  EXPECT_EQ(after.record.flattening, before.record.flattening);
  EXPECT_EQ(after.record.slide_of_face, before.record.slide_of_face);
  EXPECT_EQ(after.record.border, before.record.border);
  EXPECT_EQ(after.record.zones.contact, before.record.zones.contact);
  EXPECT_TRUE(after.record.zones.is_stick_resolved);
  EXPECT_EQ(after.record.zones.narrow, before.record.zones.narrow);
  EXPECT_EQ(after.record.accuracy->errors, before.record.accuracy->errors);
  EXPECT_EQ(after.record.accuracy->steps_share, before.record.accuracy->steps_share);
  EXPECT_EQ(after.record.steps->estimate.wanted, 2);
  EXPECT_EQ(after.record.steps->estimate.values, before.record.steps->estimate.values);
  EXPECT_EQ(after.record.steps->solver, before.record.steps->solver);
}

TEST(Checkpoint, KeepsTheChecksumOfTheGapFile)
{
  Checkpoint before = checkpoint_after(1);
  before.gap_file = 0xfedcba97;
  EXPECT_EQ(decode(encode(before)).gap_file, before.gap_file);
}
} // namespace orthocone::test
