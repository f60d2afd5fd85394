// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/checkpoint.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/text_file.h>
#include <orthocone/scene/parameters.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>
#include <vector>

namespace orthocone
{
namespace
{
constexpr const char *file_name = "checkpoint/state";

/// Entries and paths of the files that a run reads besides its parameters.
std::vector<std::pair<std::string, std::string>> input_files(const Parameters &parameters)
{
  std::vector<std::pair<std::string, std::string>> files;
  const DeclaredParameters declared(parameters);
  for (const Entry &entry : declared.list.entries())
    if (entry.is_path() && !entry.text().empty() && entry.why_ignored().empty())
      files.emplace_back(entry.name(), entry.text());
  return files;
}

/// Adds what a line says: its numbers, however they are written, and its words, but no comment.
void add_content(const std::string &line, boost::crc_32_type &crc)
{
  std::istringstream words(line.substr(0, line.find('#')));
  for (std::string word; words >> word;)
    if (const auto number = parse_number(word))
      crc.process_bytes(&*number, sizeof *number);
    else
      crc.process_bytes(word.data(), word.size());
}

/// Which file may have changed: one number stands for all.
std::string other_files(const Parameters &parameters)
{
  std::string text;
  for (const auto &[entry, path] : input_files(parameters))
    text += (text.empty() ? "" : ", or ") + entry + " = " + shown_path(path) + ": has other content";
  return text;
}

std::string in_small_letters(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return text;
}

/// Whether all pieces of an earlier list are among those now.
bool has_all_pieces(const std::string &now, const std::string &earlier)
{
  const auto pieces = split(now, ';');
  const auto before = split(earlier, ';');
  return std::all_of(before.begin(), before.end(),
                     [&](const std::string &piece)
                     { return std::find(pieces.begin(), pieces.end(), piece) != pieces.end(); });
}

void require_same_past(const Checkpoint &checkpoint, const Parameters &parameters, const RunFolder &folder,
                       const std::string &file)
{
  std::map<std::string, std::string> earlier(checkpoint.parameters.begin(), checkpoint.parameters.end());
  const auto refuse = [&](const std::string &entry, const std::string &value, const std::string &allowed)
  {
    throw InputError(file + ": " + entry + " = " + value + ", but the run in " + folder.path() +
                     " was started with " + earlier[entry] + "; allowed for --resume is " + allowed +
                     " (or start anew, with another --output DIR)");
  };
  const DeclaredParameters declared(parameters);
  for (const Entry &entry : declared.list.entries())
    if (const std::string value = entry.text(); entry.may_grow())
    {
      if (!has_all_pieces(value, earlier[entry.name()]))
        refuse(entry.name(), value,
               "a value that contains these " + in_small_letters(entry.own_name()) + " and perhaps more");
    }
    else if (!entry.may_change() && earlier[entry.name()] != value)
      refuse(entry.name(), value, "the same value");
  if (input_files_checksum(parameters) != checkpoint.gap_file)
    throw InputError(
        file + ": " + other_files(parameters) + " than when the run in " + folder.path() +
        " was started; allowed for --resume are the same (or start anew, with another --output DIR)");
  const bool has_searched =
      parameters.mesh.accuracy != 0 || parameters.mesh.adaptive != 0 || parameters.load.accuracy != 0;
  if (has_searched && parameters.load.cycles > 0 && earlier["Load program/Cycles"] == "0")
    refuse("Load program/Cycles", std::to_string(parameters.load.cycles),
           "0, because the search for mesh or load steps was made without a cycle");
  if (!parameters.load.program_file.empty() &&
      (parameters.load.cycles == 1) != (earlier["Load program/Cycles"] == "1"))
    refuse("Load program/Cycles", std::to_string(parameters.load.cycles),
           "1 if it was 1, and more than 1 if it was more, because with 1 the cycles are found in the "
           "program file, and with more the whole file is a cycle");
  if (LoadProgram(parameters.load).n_steps() < checkpoint.state.step)
    refuse("Load program/Cycles", std::to_string(parameters.load.cycles),
           "a number of cycles that includes the " + std::to_string(checkpoint.state.step) +
               " load steps that are solved");
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

std::uint32_t input_files_checksum(const Parameters &parameters)
{
  constexpr TextFileKind kind{"a text file", 4000, "it had content"};
  boost::crc_32_type crc;
  for (const auto &[entry, path] : input_files(parameters))
  {
    std::istringstream lines(with_plain_lines(read_text_file(path, "", kind)));
    for (std::string line; std::getline(lines, line);)
      add_content(line, crc);
  }
  return crc.checksum();
}

Parameters chosen_by(const Checkpoint &checkpoint, const Parameters &given)
{
  Parameters chosen = given;
  chosen.mesh = with_section(given, "Mesh", checkpoint.chosen).mesh;
  const LoadOptions load = with_section(given, "Load program", checkpoint.chosen).load;
  chosen.load.preload = load.preload;
  chosen.load.legs = load.legs;
  chosen.load.accuracy = load.accuracy;
  return chosen;
}

void write_checkpoint(RunFolder &folder, const Checkpoint &checkpoint)
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
    require_same_past(checkpoint, parameters, folder, file);
    folder.require_tables(checkpoint.tables);
    require_fields(folder, "contact", checkpoint.fields.contact);
    require_fields(folder, "volume", checkpoint.fields.volume);
    if (parameters.obstacle.kind == ObstacleKind::body)
      require_fields(folder, "lower", checkpoint.fields.volume);
    require_lines(folder, checkpoint.fields.lines);
    return checkpoint;
  }
  catch (const CheckpointError &error)
  {
    throw FileError(folder.path(file_name) + ": " + error.what() + "; without --resume the run starts anew");
  }
}
} // namespace orthocone
