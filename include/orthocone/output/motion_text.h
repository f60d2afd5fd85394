// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/load_program.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Describes the position of the held face by the components that a program moves, and the loads: "ux 0.03
/// mm, uz -0.1 mm, bulk 100 MPa". Rotations are in degrees. Where only u_z moves the name is "u_z": "u_z -0.1
/// mm".
class MotionText
{
public:
  explicit MotionText(const std::vector<LoadStep> &steps = {}, std::vector<Load> loads = {});

  /// The text of a step, with `between` between name and value.
  std::string operator()(const LoadStep &step, const std::string &between = " ") const;

private:
  std::string text_of_face(const LoadStep &step, const std::string &between) const;

  std::vector<unsigned int> moving_; ///< components
  std::vector<Load> loads_;
};
} // namespace orthocone
