// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "matrix_free_stiffness.h"

#include <orthocone/body/backends/contact_frame.h>

namespace orthocone
{
/// Forces and displacements of the contact nodes under a displacement of the body, whose own forces are
/// `forces`, where it lacked `rest` (free degrees of freedom, or nothing) of its equilibrium before. Contact
/// forces are what its own forces ask for, so that only the rest of the body lacks equilibrium.
ContactChange contact_change(const ContactFrame &frame, const BodyVector<double> &displacement,
                             const BodyVector<double> &forces, const Eigen::VectorXd &rest);
} // namespace orthocone
