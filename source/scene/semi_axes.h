// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/elliptic_cone.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
/// The semi-axes that Coefficients and Slip potential give at a place (mm), also for laws that are no
/// ellipses. Throws InputError unless both numbers of each are finite and > 0, or mu is 0, 0.
OrthotropicFriction semi_axes_at(const FrictionOptions &friction, const Eigen::Vector3d &place);
} // namespace orthocone
