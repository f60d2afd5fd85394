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
  std::vector<std::pair<std::string, std::string>> chosen;     ///< those with the mesh and the parts of steps
                                                               ///< that were chosen
  std::uint32_t gap_file = 0;                                  ///< input_files_checksum()
  std::string program;                                         ///< version and revision that wrote it
  TableMarks tables;                                           ///< the CSV files
  FieldSteps fields;                                           ///< that have a field file
  ContactState state{0};
  StartMemory starts;
  CycleMemory cycles;
  RunRecord record;
  unsigned int n_ranks = 1; ///< whose bodies `starts` has, one behind the other
};

/// What is wrong with the bytes of a checkpoint: not one, of another version, cut off, damaged.
struct CheckpointError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Version of the bytes; another one is refused.
constexpr unsigned int checkpoint_format = 10;

/// Checksum of the gaps and of the mesh in the files that the parameters name; 0 if they name none. Throws as
/// read_gap_file() and read_gmsh_file().
std::uint32_t input_files_checksum(const Parameters &parameters);

/// The bytes of a checkpoint: a line with format version, length and checksum, then CBOR.
std::string encode(const Checkpoint &checkpoint);

/// Throws CheckpointError.
Checkpoint decode(const std::string &bytes);

/// `given`, which are those of the checkpoint as far as they must be, with the mesh and the parts of the
/// steps that were chosen.
Parameters chosen_by(const Checkpoint &checkpoint, const Parameters &given);

/// Replaces the run folder's checkpoint. Before it, all other files of the run are brought to the disk.
void write_checkpoint(const RunFolder &folder, const Checkpoint &checkpoint);

/// Throws FileError if the folder holds results, but not those of a run with these parameters (its mesh
/// chosen): without a checkpoint a run starts anew, and a resumed one must not lose what it does not make
/// again.
void require_nothing_to_lose(const RunFolder &folder, const Parameters &parameters);

/// The checkpoint from which a run with these parameters goes on; nothing if it has to start from the
/// beginning because the earlier run had not come to its first. Throws InputError (which names `file`, the
/// parameter file) if the earlier run had parameters that lead to other steps, FileError for a checkpoint
/// that cannot be used. Only reads.
std::optional<Checkpoint> find_checkpoint(const RunFolder &folder, const Parameters &parameters,
                                          const std::string &file);
} // namespace orthocone
