// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "output/checkpoints.h"
#include "output/scratch_folder.h"

#include <orthocone/base/errors.h>

#include <sstream>

namespace orthocone::test
{
TEST(Checkpoint, IsFoundByTheSameParametersOnly)
{
  const ScratchFolder scratch;
  RunFolder folder(scratch.path);
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

/// An accuracy that was looked for without a cycle says nothing of its steps.
TEST(Checkpoint, HasNoCyclesAddedThatASearchHasNotSeen)
{
  const ScratchFolder scratch;
  RunFolder folder(scratch.path);
  Parameters parameters = small_scene();
  parameters.load.preload = {move_to(0, 0, -0.1, 2)};
  parameters.load.cycles = 0;
  parameters.load.accuracy = 1;
  Checkpoint checkpoint = checkpoint_after(1, parameters);
  checkpoint.tables = folder.tables();
  checkpoint.fields = {};
  write_checkpoint(folder, checkpoint);
  EXPECT_TRUE(find_checkpoint(folder, parameters, "x.prm"));
  parameters.load.cycles = 1;
  EXPECT_THROW(find_checkpoint(folder, parameters, "x.prm"), InputError);
}

TEST(Checkpoint, GivesBackThePartsThatWereChosen)
{
  Parameters given = small_scene(), chosen = given;
  given.load.accuracy = 1;
  chosen.load.legs[1].parts = 4;
  Checkpoint checkpoint;
  checkpoint.chosen = entry_values(chosen);
  given.load.cycles = 7; // may change
  const Parameters parameters = chosen_by(checkpoint, given);
  EXPECT_EQ(parameters.load.legs, chosen.load.legs);
  EXPECT_EQ(parameters.load.accuracy, 0);
  EXPECT_EQ(parameters.load.cycles, 7u);
}

TEST(Checkpoint, WithoutOneTheFolderMustHaveNothingToLose)
{
  const ScratchFolder scratch;
  RunFolder folder(scratch.path);
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
