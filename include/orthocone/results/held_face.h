// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/rigid_motion.h>

namespace orthocone
{
/// Largest distance of a contact node from the centre of the held face, mm: a rotation of 1 rad moves no
/// node further.
double reach_of(const BodyUnknowns &unknowns);

/// Largest component of a motion, mm: of the translation, or of the rotation times `reach` (mm).
double largest_way(const RigidMotion &motion, double reach);

/// The same for the largest motions of the held face in a load program, mm.
double largest_way(const LoadOptions &load, double reach);
} // namespace orthocone
