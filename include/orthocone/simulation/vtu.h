// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/stiffness.h>
#include <orthocone/simulation/contact_fields.h>

#include <string>

namespace orthocone
{
/// VTU text of the contact surface of the whole body: the modelled part and its images, so that pictures
/// do not depend on the model. Each contact node of the whole body is one point; faces are cut at their nodes
/// into bilinear quadrilaterals (triangles on the axis).
std::string contact_vtu(const ContactFieldEvaluator &evaluator, const ContactState &state);

/// VTU text of the modelled part of the body: displacement (mm), stress and von Mises stress (MPa). Each
/// element has points of its own, because stress jumps between elements, and trilinear hexahedra between
/// them.
std::string volume_vtu(const Discretization &discretization, const MaterialOptions &material,
                       const Eigen::VectorXd &displacement);

/// VTU text of a section, in the plane y = 0. One Lagrange cell an element.
std::string volume_vtu(const SectionDiscretization &discretization, const MaterialOptions &material,
                       const Eigen::VectorXd &displacement);
} // namespace orthocone
