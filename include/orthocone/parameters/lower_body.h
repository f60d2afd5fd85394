// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>
#include <orthocone/parameters/options.h>

#include <string>

namespace orthocone
{
/// The scene with the lower body in the place of the other one, on a rigid plane. Its entries have the names
/// of the other's.
Parameters lower_parameters(const Parameters &parameters);

/// A sentence about the entries of a body, as one about those of the lower body.
std::string with_lower_sections(const std::string &sentence);

/// What `use` returns, and its InputError with the names of the lower body's entries.
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

/// Throws InputError where the lower body's entries contradict each other, or `Obstacle/Kind = body` others.
void check_lower_body(const Parameters &parameters);
} // namespace orthocone
