// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/half_space.h>

namespace orthocone
{
/// half_space_compliance() of a section in plane strain: lines as long as the section is thick press on a
/// half-plane. The solutions are Flamant's, and for forces along y that of antiplane shear
/// (Johnson, Contact Mechanics, 1985, 2.2 and 2.3; u_y = -Q ln r / (pi G)).
///
/// The displacement of a half-plane grows without bounds with the distance: it has a datum only by choice.
/// Here a line force moves nothing at the distance from it by which the contact surface of the whole body
/// is long. Whatever depends on this must be driven by forces. Throws std::logic_error for a model that is no
/// section in plane strain.
Eigen::MatrixXd half_plane_compliance(const HalfSpace &half_space, const ContactSurface &surface,
                                      const ModelSymmetry &symmetry, const LocalAxes &axes);
} // namespace orthocone
