// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "matrix_free_stiffness.h"

#include <orthocone/body/backends/contact_frame.h>

namespace orthocone
{
/// Forces (N) and displacements (mm) of the contact nodes under a displacement of the body with the forces K
/// u = `forces`. Before, the body lacked `residual` of its equilibrium (free degrees of freedom, or empty).
/// The contact forces are those that K u requires, so that only the rest of the body lacks equilibrium.
ContactChange contact_change(const ContactFrame &frame, const BodyVector<double> &displacement,
                             const BodyVector<double> &forces, const Eigen::VectorXd &residual);
} // namespace orthocone
