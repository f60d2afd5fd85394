// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <orthocone/body/shapes/mesh_ladder.h>

#include <stdexcept>

namespace orthocone::studies
{
SceneWords::SceneWords(const Words &words)
{
  if (words.empty())
    throw std::runtime_error("the first word is a parameter file");
  std::vector<std::string> overrides;
  for (std::size_t i = 1; i + 1 < words.size(); i += 2)
    if (words[i] == "--set")
      overrides.push_back(words[i + 1]);
    else if (words[i].rfind("--", 0) == 0)
      options[words[i].substr(2)] = words[i + 1];
    else
      throw std::runtime_error("'" + words[i] + "' is not an option");
  if (words.size() % 2 == 0)
    throw std::runtime_error("'" + words.back() + "' lacks its value");
  parameters = read_parameters(words.front(), overrides);
  check_parameters(parameters);
  parameters.mesh = resolved_mesh(parameters.geometry, parameters.mesh,
                                  choose_model(parameters).symmetry.is_axisymmetric());
}

double SceneWords::number(const std::string &option, const double otherwise) const
{
  const auto found = options.find(option);
  return found == options.end() ? otherwise : std::stod(found->second);
}

March::March(const Scene &scene, const unsigned int number)
    : state(scene.gaps())
{
  struct UntilStep : MarchObserver
  {
    bool goes_on(const LoadStep &step) override { return (next = step).number != number; }
    unsigned int number = 0;
    LoadStep next{};
  } until;
  until.number = number;
  StepSolver solver(scene);
  const MarchEnd end = march(LoadProgram(scene.parameters().load).steps(), solver, state, until);
  if (end == MarchEnd::unsolved)
    throw std::runtime_error("step " + std::to_string(until.next.number) + " is not solved");
  if (end == MarchEnd::done)
    throw std::runtime_error("there is no step " + std::to_string(number));
  next = until.next;
}
} // namespace orthocone::studies
