// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "experiments.h"

#include <orthocone/march/march.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/scene.h>

#include <map>

namespace orthocone::studies
{
/// Words of an experiment on a scene: a parameter file, `--set` like those of the program, and further
/// options with one value each.
struct SceneWords
{
  explicit SceneWords(const Words &words);

  Parameters parameters;
  std::map<std::string, std::string> options; ///< without their dashes

  /// The option as a number, or `otherwise`.
  double number(const std::string &option, double otherwise) const;
};

/// Marches with the method of the file, as the program would, until the step `number` is the next one. Throws
/// std::runtime_error if a step before cannot be solved.
struct March
{
  March(const Scene &scene, unsigned int number);

  ContactState state;
  LoadStep next;
};
} // namespace orthocone::studies
