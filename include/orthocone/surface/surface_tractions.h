// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/local_axes.h>

namespace orthocone
{
/// The tractions (MPa, global axes) on a body that forces on its contact nodes are: `forces` has three
/// numbers for each node in its local axes, N, of the model.
std::vector<Eigen::Vector3d> surface_tractions(const ContactSurface &surface, const LocalAxes &axes,
                                               const Eigen::VectorXd &forces);
} // namespace orthocone
