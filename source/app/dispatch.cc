// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dispatch.h"

#include "batch.h"
#include "body_preparation.h"
#include "check_command.h"
#include "commands.h"
#include "interrupt.h"
#include "run_command.h"
#include "shipped_scenes.h"

#include <orthocone/base/machine.h>
#include <orthocone/base/text.h>
#include <orthocone/base/version.h>
#include <orthocone/entries/json_schema.h>
#include <orthocone/results/tables.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace orthocone
{
namespace
{
void print_text(const CommandLine &line)
{
  if (line.help)
    std::cout << usage();
  else if (line.version)
    for (const auto &[name, version] : versions())
      std::cout << name << " " << version << "\n";
  else if (line.list)
    std::cout << shipped_scenes(folder_of_shipped_scenes());
  else if (line.schema)
    std::cout << json_schema(DeclaredParameters().list, "Parameter file of orthocone");
  else if (line.columns)
    std::cout << described_columns();
  else
    write_parameters(Parameters(), std::cout);
  if (!std::cout.flush())
    throw FileError("standard output: cannot be written");
}

/// Runs a command line of --batch, in a process of its own.
int run_words(const std::vector<std::string> &words)
{
  std::vector<const char *> argv{"orthocone"};
  for (const std::string &word : words)
    argv.push_back(word.c_str());
  return guarded_dispatch(static_cast<int>(argv.size()), argv.data());
}

int run_lines(const unsigned int jobs)
{
  BodyPreparation bodies(std::max(1U, jobs));
  const auto prepare = [&](const std::vector<std::string> &words) { bodies.prepare(words); };
  return static_cast<int>(run_batch({run_words, can_prepare_bodies, prepare}, jobs, std::cout)
                              ? ExitCode::done
                              : ExitCode::interrupted);
}

int dispatch(const int argc, const char *const *const argv)
{
  const CommandLine line = parse_command_line(argc, argv);
  if (line.batch)
    return run_lines(line.jobs);
  if (line.prints())
  {
    print_text(line);
    return static_cast<int>(ExitCode::done);
  }
  if (!line.rig.empty())
  {
    copy_rig(line.rig, line.parameter_file);
    return static_cast<int>(ExitCode::done);
  }
  require_address_space();
  catch_signals();
  require_file_for_all(line.parameter_file);
  const ParameterFile file = read_parameter_file(line.parameter_file, line.overrides);
  require_same_for_all(line, file.parameters);
  return line.check ? check(line, file.parameters) : run(line, file);
}
} // namespace

int guarded_dispatch(const int argc, const char *const *const argv)
{
  try
  {
    return dispatch(argc, argv);
  }
  catch (...)
  {
    return fail(ending_of_exception());
  }
}
} // namespace orthocone
