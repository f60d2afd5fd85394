// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "run_command.h"

#include "commands.h"
#include "quasi_static_problem.h"

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/cost_model.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/march/rank_memory.h>
#include <orthocone/output/line_files.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/line_points.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// The task of a run, and its messages before it has a log.
struct Assignment
{
  const CommandLine &line;
  const ParameterFile &file;
  const ModelChoice model;
  ThreadChooser threads;
  std::string lines{}; ///< for log.txt, which begins when the run is known to begin

  void report(const std::string &text)
  {
    lines += text + "\n";
    if (!line.quiet)
      std::cout << text << std::endl;
  }
};

std::string complete_text(const Parameters &parameters)
{
  std::ostringstream text;
  write_parameters(parameters, text);
  return text.str();
}

std::string input_name(const CommandLine &line)
{
  return is_json(line.parameter_file) ? "input.json" : "input.prm";
}

/// A path without detours such as a/../b, which would create the folder a.
fs::path without_detours(const fs::path &path)
{
  const auto goes_back = [](const fs::path &part, const fs::path &next)
  { return part != ".." && next == ".."; };
  if (std::adjacent_find(path.begin(), path.end(), goes_back) == path.end())
    return path;
  std::error_code code;
  const fs::path direct = fs::weakly_canonical(path, code);
  return code ? path : direct;
}

/// Path of the parameter file, which distinguishes it from others of the same name.
std::string path_of(const CommandLine &line)
{
  return shown_path(fs::absolute(line.parameter_file).lexically_normal().string());
}

/// The folder of the results.
fs::path run_folder_of(const CommandLine &line)
{
  if (!line.output_folder.empty())
    return without_detours(line.output_folder);
  const fs::path stem = fs::path(line.parameter_file).stem();
  return "output" / (stem == "." || stem == ".." ? fs::path(line.parameter_file).filename() : stem);
}

/// Writes the parameters into the run folder: as the user wrote them, and complete. Throws FileError.
void keep_parameters(RunFolder &folder, Assignment &task, const Parameters &parameters)
{
  const std::string path = path_of(task.line);
  if (const auto earlier = folder.start_anew(complete_text(parameters), path, named_files(parameters.output)))
    task.report("warning: " + folder.path() + " held the results of another file, " + *earlier +
                "; the results of this run take their place (--output DIR keeps both)");
  folder.write(input_name(task.line), task.file.text);
}

/// The same for a run that goes on, perhaps with more cycles, probes, lines or fields than it began with.
void update_parameters(RunFolder &folder, const Assignment &task, const Parameters &parameters)
{
  const std::string text = complete_text(parameters);
  if (folder.has(input_name(task.line)) && folder.has("parameters.prm") &&
      folder.read("parameters.prm") == text)
    return;
  folder.write("parameters.prm", text);
  folder.write(input_name(task.line), task.file.text);
}

/// Refuses a model for which there is not enough memory, before anything is touched.
void require_memory_for(const Assignment &task, const Parameters &parameters)
{
  MemoryLimit limit = memory_limit();
  limit.gigabytes = of_first_rank(limit.gigabytes); // all must find the same
  Parameters chosen = parameters;
  chosen.mesh.backend = choose_backend(parameters, task.model.symmetry, limit.gigabytes).backend;
  naming_file(task.line, [&] { require_memory(chosen, task.model.symmetry, limit); });
}

/// Refuses what can be known of a model without long work, before anything is touched.
void require_model_of(const Assignment &task)
{
  Parameters parameters = task.file.parameters;
  const ModelSymmetry &symmetry = task.model.symmetry;
  if (parameters.mesh.accuracy != 0) // a search finds out the rest
    return naming_file(task.line, [&] { require_lines_inside(parameters, symmetry); });
  parameters.mesh = resolved_mesh(parameters, symmetry.is_axisymmetric());
  if (!task.line.insist)
    require_memory_for(task, parameters);
  require_bodies_that_meet(task.line, parameters, symmetry);
}

/// Unknowns of the finest mesh that a search usually reaches.
double unknowns_of_search(const Assignment &task)
{
  constexpr unsigned int level = 2;
  Parameters parameters = task.file.parameters;
  const bool is_axisymmetric = task.model.symmetry.is_axisymmetric();
  parameters.mesh = parameters.mesh.accuracy != 0 ? ladder_mesh(parameters, is_axisymmetric, level)
                                                  : resolved_mesh(parameters, is_axisymmetric);
  return model_size(parameters, task.model.symmetry).dofs;
}

/// The checkpoint from which the run goes on. The first process reads it for all.
std::optional<Checkpoint> checkpoint_to_resume(const Assignment &task, const RunFolder &folder)
{
  std::optional<Checkpoint> checkpoint;
  if (task.line.resume && is_first_rank())
    checkpoint = find_checkpoint(folder, task.file.parameters, shown_path(task.line.parameter_file));
  if (!task.line.resume || n_ranks() == 1)
    return checkpoint;
  const std::string bytes = of_first_rank(checkpoint ? encode(*checkpoint) : std::string());
  checkpoint = bytes.empty() ? std::nullopt : std::optional(decode(bytes));
  if (checkpoint)
    checkpoint->starts = part_of_this_rank(std::move(checkpoint->starts), checkpoint->n_ranks);
  return checkpoint;
}

/// Prepares the task to go on. Throws InputError for a run of one process that several processes cannot
/// continue.
void go_on(Assignment &task, const Checkpoint &checkpoint)
{
  if (checkpoint.n_ranks == n_ranks())
    task.threads.go_on_with(checkpoint.record.threads.number);
  if (n_ranks() > 1 && chosen_by(checkpoint, task.file.parameters).mesh.backend != BodyBackend::multigrid)
    throw InputError(shown_path(task.line.parameter_file) +
                     ": Mesh/Backend = condensed, as the run has chosen, with " + std::to_string(n_ranks()) +
                     " processes: allowed for --resume is one process");
}

/// Chooses the mesh, prepares the folder, and solves the steps. Throws what the libraries throw.
Ending solve(Assignment &task, RunFolder &folder)
{
  const Parameters &given = task.file.parameters;
  folder.require_own(named_files(given.output));
  const auto checkpoint = checkpoint_to_resume(task, folder);
  if (checkpoint)
    go_on(task, *checkpoint);
  // A search may take minutes: what is wrong with the folder is reported before it, and an older run in the
  // folder can no longer be resumed.
  if (searches(given) && !checkpoint)
  {
    if (!task.line.resume)
      keep_parameters(folder, task, given);
    task.threads.choose(unknowns_of_search(task));
  }
  ChosenModel chosen =
      checkpoint
          ? ChosenModel{given, chosen_by(*checkpoint, given)}
          : choose_mesh_and_steps(given, task.model, [&](const std::string &text) { task.report(text); });
  const Parameters parameters = chosen.parameters;
  if (task.line.resume && !checkpoint)
    require_nothing_to_lose(folder, parameters);
  if (!checkpoint)
    keep_parameters(folder, task, parameters);
  Log log(folder, task.line.quiet);
  if (task.line.resume && !checkpoint)
    log.line("no checkpoint in " + folder.path() + ": starts with the first load step");
  if (!task.lines.empty())
    folder.append("log.txt", task.lines);
  QuasiStaticProblem problem(std::move(chosen), task.model, folder, log, task.threads);
  if (checkpoint)
    folder.mark(path_of(task.line), named_files(parameters.output));
  return problem.run(checkpoint, [&] { update_parameters(folder, task, parameters); });
}

/// Writes the summary of a run that could not reach its first step. A summary of steps before an interruption
/// keeps all but its status.
void keep_failure(RunFolder &folder, const Assignment &task, const std::string &message)
{
  const bool has_summary = folder.has("summary.json");
  if (has_summary && task.line.resume)
    folder.write("summary.json", summary_json_with_status(folder.read("summary.json"), message));
  else if (!has_summary)
    folder.write("summary.json", summary_json_before_steps(message, task.file.parameters));
}

/// Reports what was not done. Where the march has ended, all processes know it, and the first one reports it.
/// Returns the exit code.
int report_end(const Ending &outcome, const RunFolder &folder, const bool is_thrown)
{
  if (outcome.code == ExitCode::done || (!is_thrown && !is_first_rank()))
    return static_cast<int>(outcome.code);
  const bool has_steps = outcome.code == ExitCode::unsolved_step && !is_thrown;
  return fail(
      {outcome.code,
       outcome.message + (has_steps ? "\nIn " + folder.path() +
                                          ": log.txt describes every step, history.csv and contact.pvd "
                                          "contain the solved ones, and summary.json repeats this message."
                                    : "")});
}
} // namespace

bool searches(const Parameters &given)
{
  return given.mesh.accuracy != 0 || given.mesh.adaptive != 0 || given.load.accuracy != 0;
}

int run(const CommandLine &line, const ParameterFile &file)
{
  Assignment task{line, file, resolve(line, file.parameters), ThreadChooser(line)};
  require_model_of(task);
  RunFolder folder(is_first_rank() ? std::optional(run_folder_of(line)) : std::nullopt);
  Ending outcome;
  bool is_thrown = true;
  try
  {
    outcome = solve(task, folder);
    is_thrown = false;
  }
  catch (...)
  {
    outcome = ending_of_exception();
    if (outcome.code != ExitCode::unsolved_step)
      throw; // no step has failed: the folder stays as it is
  }
  if (is_thrown)
    keep_failure(folder, task, outcome.message);
  const int code = report_end(outcome, folder, is_thrown);
  if (!is_thrown)
    wait_for_all_ranks(); // the first one to fail ends all, perhaps while another writes
  return code;
}
} // namespace orthocone
