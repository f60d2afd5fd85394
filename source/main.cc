// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "command_line.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/text.h>
#include <orthocone/simulation/estimate.h>
#include <orthocone/simulation/interrupt.h>
#include <orthocone/simulation/mesh_ladder.h>
#include <orthocone/simulation/quasi_static_problem.h>
#include <orthocone/simulation/version.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace orthocone;

namespace
{
int exit_code(const ExitCode code)
{
  return static_cast<int>(code);
}

int fail(const ExitCode code, const std::string &message)
{
  std::cerr << "orthocone: " << message << std::endl;
  return exit_code(code);
}

void print_warnings(const Parameters &parameters)
{
  for (const std::string &warning : parameter_warnings(parameters))
    std::cout << "warning: " << warning << "\n";
  if (!std::cout.flush())
    throw FileError("standard output: cannot be written");
}

int print_model_of_unknown_mesh(const Parameters &parameters, const ModelChoice &model)
{
  std::cout << "model          " << model.symmetry.name() << " (" << model.reason << ")\n"
            << "mesh           is chosen by the run, for errors of " << to_text(parameters.mesh.accuracy)
            << " %\n"
            << "load steps     " << load_steps(parameters.load).size() << "\n";
  print_warnings(parameters);
  return exit_code(ExitCode::done);
}

int print_model(const Parameters &given, const ModelChoice &model)
{
  if (given.mesh.accuracy != 0)
    return print_model_of_unknown_mesh(given, model);
  Parameters parameters = given;
  parameters.mesh = resolved_mesh(given.geometry, given.mesh, model.symmetry.is_axisymmetric());
  // The mesh of more unknowns takes longer than somebody who checks waits.
  constexpr double largest_meshed = 3e6;
  const unsigned int n_steps = load_steps(parameters.load).size();
  const ModelSize size = model_size(parameters.mesh, model.symmetry);
  if (size.dofs > largest_meshed)
    std::cout << "model          " << model.symmetry.name() << " (" << model.reason << ")\n"
              << describe(size) << "\n";
  else
  {
    const Body body(parameters, model.symmetry);
    std::cout << describe_model(parameters, model, body.unknowns(), n_steps) << "\n"
              << describe(estimate(parameters, body, model.symmetry), n_steps) << "\n";
  }
  print_warnings(parameters);
  return exit_code(ExitCode::done);
}

/// Puts the parameters into the run folder: as the user wrote them, and complete.
void keep_parameters(const RunFolder &folder, const CommandLine &line, const Parameters &parameters)
{
  std::ostringstream verbatim;
  verbatim << std::ifstream(line.parameter_file, std::ios::binary).rdbuf();
  std::ostringstream complete;
  write_parameters(parameters, complete);
  folder.start_anew(complete.str());
  folder.write(is_json(line.parameter_file) ? "input.json" : "input.prm", verbatim.str());
}

std::filesystem::path run_folder_of(const CommandLine &line)
{
  return line.output_folder.empty() ? "output" / std::filesystem::path(line.parameter_file).stem()
                                    : std::filesystem::path(line.output_folder);
}

/// Checks what entries have to do with each other; faults are told with the name of the file.
ModelChoice resolve(const CommandLine &line, const Parameters &parameters)
{
  try
  {
    check_parameters(parameters);
    return choose_model(parameters);
  }
  catch (const InputError &error)
  {
    throw InputError(line.parameter_file + ": " + error.what());
  }
}

int run(const CommandLine &line)
{
  const Parameters given = read_parameters(line.parameter_file, line.overrides);
  const ModelChoice model = resolve(line, given);
  if (line.check)
    return print_model(given, model);
  catch_signals();
  const RunFolder folder(run_folder_of(line));
  const auto checkpoint = line.resume ? find_checkpoint(folder, given, line.parameter_file) : std::nullopt;
  std::string lines; // log.txt begins when it is known that the run does
  const auto tell = [&](const std::string &text)
  {
    lines += text + "\n";
    if (!line.quiet)
      std::cout << text << std::endl;
  };
  // A search for a mesh may take minutes: what is wrong with the folder is told before, and an older run in
  // it is no longer there to be resumed.
  if (given.mesh.accuracy != 0 && !line.resume)
    keep_parameters(folder, line, given);
  ChosenMesh chosen = checkpoint ? mesh_of(*checkpoint, given) : choose_mesh(given, model, tell);
  Parameters parameters = given;
  parameters.mesh = chosen.mesh;
  if (line.resume && !checkpoint)
    require_nothing_to_lose(folder, parameters);
  if (!checkpoint)
    keep_parameters(folder, line, parameters);
  Log log(folder, line.quiet);
  if (line.resume && !checkpoint)
    log.line("no checkpoint in " + folder.path() + ": starts with the first load step");
  if (!lines.empty())
    folder.append("log.txt", lines);
  const auto outcome = QuasiStaticProblem(parameters, model, folder, log, std::move(chosen)).run(checkpoint);
  return outcome.code == ExitCode::done ? exit_code(ExitCode::done) : fail(outcome.code, outcome.message);
}

void print_defaults()
{
  std::ostringstream text; // deal.II has a sentence of its own for a stream that fails
  write_parameters(Parameters(), text);
  std::cout << text.str();
}

int dispatch(const int argc, const char *const *const argv)
{
  const CommandLine line = parse_command_line(argc, argv);
  if (line.help)
    std::cout << usage();
  else if (line.version)
    for (const auto &[name, version] : versions())
      std::cout << name << " " << version << "\n";
  else if (line.defaults)
    print_defaults();
  else
    return run(line);
  if (!std::cout.flush())
    throw FileError("standard output: cannot be written");
  return exit_code(ExitCode::done);
}
} // namespace

int main(const int argc, const char *const *const argv)
{
  try
  {
    return dispatch(argc, argv);
  }
  catch (const InputError &error)
  {
    return fail(ExitCode::wrong_input, error.what());
  }
  catch (const FileError &error)
  {
    return fail(ExitCode::file_error, error.what());
  }
  catch (const std::filesystem::filesystem_error &error)
  {
    return fail(ExitCode::file_error, error.path1().string() + ": " + error.code().message());
  }
  catch (const dealii::ExceptionBase &error)
  {
    std::ostringstream text;
    error.print_info(text);
    return fail(ExitCode::unsolved_step, trimmed(text.str()));
  }
  catch (const std::bad_alloc &)
  {
    return fail(ExitCode::unsolved_step,
                "memory runs out; a coarser mesh or a reduced Mesh/Model needs less");
  }
  catch (const std::exception &error)
  {
    return fail(ExitCode::unsolved_step, error.what());
  }
}
