// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body_preparation.h"

#include "commands.h"
#include "run_command.h"
#include "thread_chooser.h"

#include <orthocone/accuracy/cost_model.h>
#include <orthocone/accuracy/mesh_search.h>
#include <orthocone/base/machine.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/body_shelf.h>
#include <orthocone/scene/contact_mesh.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>

namespace orthocone
{
namespace
{
CommandLine command_line_of(const std::vector<std::string> &words)
{
  std::vector<const char *> argv{"orthocone"};
  for (const std::string &word : words)
    argv.push_back(word.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

bool has_one_thread(const CommandLine &line)
{
  if (line.threads > 0)
    return line.threads == 1;
  const auto given = threads_of_environment();
  return given && given->number == 1;
}

/// What the bodies of a scene depend on, before its mesh is chosen.
std::string key_of(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  return body_key(parameters, symmetry) +
         (parameters.obstacle.kind == ObstacleKind::body ? body_key(parameters.lower, symmetry) : "");
}

/// Does what the run will do until its scene is made.
void make_bodies(const Parameters &parameters, const ModelChoice &model)
{
  const ChosenModel chosen = choose_mesh_and_steps(parameters, model, [](const std::string &) {});
  if (!chosen.scene && chosen.parameters.mesh.backend != BodyBackend::multigrid &&
      kind_of(parameters.geometry).is_meshed())
    Scene(chosen.parameters, model);
}
} // namespace

bool can_prepare_bodies(const std::vector<std::string> &words)
try
{
  const CommandLine line = command_line_of(words);
  std::error_code code;
  return !line.batch && !line.prints() && line.rig.empty() && !line.check && has_one_thread(line) &&
         !std::isfinite(free_address_space()) && std::filesystem::is_regular_file(line.parameter_file, code);
}
catch (const std::exception &)
{
  return false;
}

void BodyPreparation::prepare(const std::vector<std::string> &words)
{
  try
  {
    const CommandLine line = command_line_of(words);
    ThreadChooser(line).choose(0);
    prepare(line, read_parameter_file(line.parameter_file, line.overrides));
  }
  catch (const std::exception &)
  {
  }
  BodyShelf::of_process().collect("");
}

void BodyPreparation::prepare(const CommandLine &line, const ParameterFile &file)
{
  const Parameters &parameters = file.parameters;
  if (line.resume && searches(parameters))
    return; // its checkpoint has the mesh
  const ModelChoice model = resolve(line, parameters);
  const std::string key = key_of(parameters, model.symmetry);
  if (const auto kept = std::find(kept_.begin(), kept_.end(), key); kept != kept_.end())
    return kept_.splice(kept_.begin(), kept_, kept);
  constexpr unsigned int worth_keeping = 2;
  const std::size_t checksum = std::hash<std::string>()(key); // keys are long, and there may be many
  if (++n_seen_[checksum] != worth_keeping || !has_room(parameters, model.symmetry))
    return;
  n_seen_.erase(checksum);
  kept_.push_front(key);
  BodyShelf::of_process().collect(key);
  make_bodies(parameters, model);
}

/// Each run may need as much as one without a shelf, and the keeper as much as two, while it makes a body and
/// has the smaller ones of a search.
bool BodyPreparation::has_room(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  constexpr unsigned int level = 2, n_of_keeper = 2; // the finest mesh that a search usually reaches
  const bool is_axisymmetric = symmetry.is_axisymmetric();
  Parameters largest = parameters;
  largest.mesh = parameters.mesh.accuracy != 0 ? ladder_mesh(parameters, is_axisymmetric, level)
                                               : resolved_mesh(parameters, is_axisymmetric);
  const auto fits = [&]
  { return !is_too_large(largest, symmetry, free_gigabytes() / (n_runs_ + n_of_keeper)); };
  while (!fits())
  {
    if (kept_.empty())
      return false;
    BodyShelf::of_process().drop(kept_.back());
    kept_.pop_back();
    ::malloc_trim(0);
  }
  return true;
}
} // namespace orthocone
