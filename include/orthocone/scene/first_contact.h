// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/obstacle.h>

namespace orthocone
{
/// Throws InputError for a load program in which a force begins to press while nothing touches: the motion
/// until contact would not be determined. `sample` is of the whole body.
void require_contact_before_force(const Parameters &parameters, const Obstacle &obstacle,
                                  const SurfaceSample &sample);

/// Throws InputError where a counterface that fits the body overlaps it and no interference drives that, or
/// where an interference has nothing to drive. Of two bodies it knows nothing.
void require_driven_overlap(const Parameters &parameters, const Obstacle &obstacle,
                            const std::vector<SurfacePoint> &points);

/// Throws InputError where a body begins inside a counterface with normals of its own, deeper than its cells
/// are wide: that is no small overlap, and the distance most likely has the wrong sign.
void require_shallow_overlap(const Obstacle &obstacle, const ContactSurface &surface);

/// The same of the parameters, whose mesh it makes; and normals that multigrid can take, if it is chosen.
void require_fitting_surface(const Parameters &parameters, const ModelSymmetry &symmetry);
} // namespace orthocone
