// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>
#include <orthocone/parameters/options.h>

#include <string>

namespace orthocone
{
/// The scene with the lower body in the place of the upper one, on a rigid plane. Its entries have the names
/// of the upper body's entries. Throws nothing.
Parameters lower_parameters(const Parameters &parameters);

/// Turns a sentence about the entries of a body into one about the entries of the lower body.
std::string with_lower_sections(const std::string &sentence);

/// Returns what `use` returns. Rethrows its InputError with the names of the lower body's entries.
template<typename Use>
auto of_lower_body(const Use &use)
{
  try
  {
    return use();
  }
  catch (const InputError &error)
  {
    throw InputError(with_lower_sections(error.what()));
  }
}

/// Throws InputError where the lower body's entries contradict each other, or `Obstacle/Kind = body`
/// contradicts other entries.
void check_lower_body(const Parameters &parameters);
} // namespace orthocone
