// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/load_program.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Describes the position of the held face by the components that a program moves: "ux 0.03 mm, uz -0.1 mm".
/// Rotations are in degrees. Where only u_z moves the name is "u_z": "u_z -0.1 mm".
class MotionText
{
public:
  explicit MotionText(const std::vector<LoadStep> &steps = {});

  /// The text of a step, with `between` between name and value.
  std::string operator()(const LoadStep &step, const std::string &between = " ") const;

private:
  std::vector<unsigned int> moving_; ///< components
};
} // namespace orthocone
