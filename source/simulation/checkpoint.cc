// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/checkpoint.h>

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/parameters.h>

#include <algorithm>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr const char *file_name = "checkpoint/state";

/// Whether a run may go on with another value of an entry: those that change what is written or how a step is
/// solved and judged, but not what is computed.
bool may_change(const std::string &entry)
{
  static const std::array<const char *, 5> free_entries{
      {"Output/Checkpoint", "Contact solver/Maximum iterations", "Contact solver/Method",
       "Contact solver/Relaxation", "Contact solver/Rho factor"}};
  return entry.compare(0, 7, "Checks/") == 0 ||
         std::find(free_entries.begin(), free_entries.end(), entry) != free_entries.end();
}

void require_same_parameters(const Checkpoint &checkpoint, const Parameters &parameters,
                             const RunFolder &folder, const std::string &file)
{
  std::map<std::string, std::string> earlier(checkpoint.parameters.begin(), checkpoint.parameters.end());
  for (const auto &[entry, value] : entry_values(parameters))
    if (!may_change(entry) && earlier[entry] != value)
      throw InputError(file + ": " + entry + " = " + value + ", but the run in " + folder.path() +
                       " was started with " + earlier[entry] +
                       "; allowed for --resume is the same value (or start anew, with another --output DIR)");
}
} // namespace

void require_nothing_to_lose(const RunFolder &folder, const Parameters &parameters)
{
  std::ostringstream text;
  write_parameters(parameters, text);
  if (folder.has("history.csv") && folder.has("parameters.prm") &&
      folder.read("parameters.prm") != text.str())
    throw FileError(
        folder.path(file_name) +
        ": is missing, and the folder holds results of other parameters; without --resume the run "
        "starts anew");
}

void write_checkpoint(const RunFolder &folder, const Checkpoint &checkpoint)
{
  folder.write_durably(file_name, encode(checkpoint));
}

std::optional<Checkpoint> find_checkpoint(const RunFolder &folder, const Parameters &parameters,
                                          const std::string &file)
{
  if (!folder.has(file_name))
    return std::nullopt;
  const std::string bytes = folder.read(file_name);
  try
  {
    const Checkpoint checkpoint = decode(bytes);
    require_same_parameters(checkpoint, parameters, folder, file);
    folder.require_tables(checkpoint.table_sizes);
    return checkpoint;
  }
  catch (const CheckpointError &error)
  {
    throw FileError(folder.path(file_name) + ": " + error.what() + "; without --resume the run starts anew");
  }
}
} // namespace orthocone
