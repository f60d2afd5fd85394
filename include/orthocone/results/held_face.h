// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/rigid_motion.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Where a contact node lies as seen from the centre of the held face, mm. Moments and rotations are about
/// this centre.
Eigen::Vector3d arm_of(const ContactNode &node, const GeometryOptions &geometry);

/// Largest distance of a contact node from the centre of the held face, mm: a rotation of 1 rad moves no
/// node further.
double reach_of(const ContactSurface &surface, const GeometryOptions &geometry);

/// Largest way of a motion, mm: of a component of the translation, or of the rotation times `reach` (mm).
double largest_way(const RigidMotion &motion, double reach);

/// Largest motion of the held face in the program, mm: of a component of the translation, or of the rotation
/// times `reach` (mm).
double largest_way(const LoadOptions &load, double reach);
} // namespace orthocone
