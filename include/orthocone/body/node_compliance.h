// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/model_symmetry.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Estimated compliance (mm/N, one number a node) of each node of the model under a force on it alone: (1 -
/// nu^2) / (0.7 E h), the compliance of a half-space under a square of side h (docs/theory.md, section 4,
/// "Dissipation"), divided by the share of the force that the model's node carries. h^2 is the area of a node
/// of the whole body, or h is the width of a ring, so that every model has the same values.
Eigen::VectorXd node_compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                const MaterialOptions &material);
} // namespace orthocone
