// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/held_face.h>

#include <orthocone/scene/load_program.h>

#include <algorithm>

namespace orthocone
{
double reach_of(const BodyUnknowns &unknowns)
{
  double reach = 0;
  for (const ContactNode &node : unknowns.contact_surface().nodes)
    reach = std::max(reach, unknowns.arm(node).norm());
  return reach;
}

double largest_way(const RigidMotion &motion, const double reach)
{
  return std::max(motion.translation().cwiseAbs().maxCoeff(), reach * motion.rotation().norm());
}

double largest_way(const LoadOptions &load, const double reach)
{
  double largest = 0;
  for (const LoadStep &step : LoadProgram(load).first_cycle().steps())
    largest = std::max(largest, largest_way(step.motion, reach));
  return largest;
}
} // namespace orthocone
