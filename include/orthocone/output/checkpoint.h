// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>
#include <orthocone/march/step_solver.h>
#include <orthocone/output/field_list.h>
#include <orthocone/output/run_folder.h>
#include <orthocone/output/summary.h>
#include <orthocone/results/cycles.h>

#include <cstdint>
#include <optional>
#include <stdexcept>

namespace orthocone
{
/// All that a run needs to go on after a step as if it had never stopped.
struct Checkpoint
{
  std::vector<std::pair<std::string, std::string>> parameters; ///< entry_values() as given
  std::vector<std::pair<std::string, std::string>> chosen; ///< these with the chosen mesh and parts of steps
  std::uint32_t gap_file = 0;                              ///< input_files_checksum()
  std::string program;                                     ///< version and revision that wrote it
  TableMarks tables;                                       ///< the CSV files
  FieldSteps fields;                                       ///< steps that have a field file
  ContactState state{0};
  StartMemory starts;
  CycleMemory cycles;
  RunRecord record;
  unsigned int n_ranks = 1; ///< processes, whose bodies `starts` has one behind the other
};

/// The bytes are no checkpoint, or a checkpoint of another version, cut off, or damaged.
struct CheckpointError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Version of the bytes; another one is refused.
constexpr unsigned int checkpoint_format = 22;

/// Checksum of the files that entries name and that count: of their numbers and words, however they are
/// written, without comments; 0 if there is no file. Throws as read_text_file().
std::uint32_t input_files_checksum(const Parameters &parameters);

/// The bytes of a checkpoint: a line with format version, length and checksum, then CBOR.
std::string encode(const Checkpoint &checkpoint);

/// The checkpoint of these bytes. Throws CheckpointError.
Checkpoint decode(const std::string &bytes);

/// The parameters `given`, which agree with the checkpoint's where they must, with the mesh and the parts of
/// steps that were chosen.
Parameters chosen_by(const Checkpoint &checkpoint, const Parameters &given);

/// Replaces the run folder's checkpoint. All other files of the run are brought to the disk before. Throws
/// FileError.
void write_checkpoint(RunFolder &folder, const Checkpoint &checkpoint);

/// Throws FileError if the folder has results of a run with other parameters (with its mesh chosen): without
/// a checkpoint a run starts anew, and a resumed run must not remove what it does not compute again.
void require_nothing_to_lose(const RunFolder &folder, const Parameters &parameters);

/// The checkpoint from which a run with these parameters goes on; nothing if it must start from the beginning
/// because the earlier run had not reached its first checkpoint. Throws InputError (which names `file`, the
/// parameter file) if the earlier run had parameters that lead to other steps, FileError for a checkpoint
/// that cannot be used. Only reads.
std::optional<Checkpoint> find_checkpoint(const RunFolder &folder, const Parameters &parameters,
                                          const std::string &file);
} // namespace orthocone
