// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>
#include <orthocone/scene/scene.h>

#include <optional>
#include <string>

namespace orthocone
{
/// How far a state is from the small strains and small slides that the program computes with.
struct MotionChecks
{
  /// Largest elastic displacement of a node in contact relative to the height of its body: a mean strain.
  double flattening = 0;
  double crushing = 0;            ///< the same of displacements along the normal
  double pressure_of_modulus = 0; ///< mean pressure of the contact / Young's modulus
  double slide_of_face = 0;       ///< largest slip in contact / mean size of a face of the lower body
  double cover = 1;               ///< part of the contact that still lies on the lower body
  double border = 0;              ///< share of the normal force on the outermost patches of a half-space
};

/// Judges a state. `elastic` and `given_way` (3 n, mm) are the displacements of the body's contact nodes
/// against its rigid motion, and those of the obstacle.
MotionChecks motion_checks(const Scene &scene, const ContactState &state, const NodeVector &elastic,
                           const NodeVector &given_way);

/// The sentence on a motion that no body can follow, or that takes one off the other; or nothing.
std::optional<std::string> violation(const MotionChecks &checks);
} // namespace orthocone
