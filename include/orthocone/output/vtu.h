// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body.h>
#include <orthocone/body/deformation.h>
#include <orthocone/results/contact_fields.h>

#include <string>
#include <vector>

namespace orthocone
{
/// VTU text of the contact surface of the whole body: the modelled part and its images, so that pictures
/// do not depend on the model. Each contact node of the whole body is one point; faces are cut at their nodes
/// into bilinear quadrilaterals (triangles on the axis).
std::string contact_vtu(const ContactFieldEvaluator &evaluator, const std::vector<ContactFields> &fields);

/// VTU text of the modelled part of the body: displacement (mm), stress (MPa) and what follows from it. Each
/// element has points of its own, because stress may jump between elements. Between them are trilinear
/// hexahedra. A section lies in the plane y = 0 and has one Lagrange cell an element. Where several processes
/// share the body, the text has only the cells of this process, and is empty if there are none.
/// `is_mirrored`: the text has the image about z = 0.
template<int dim>
std::string volume_vtu(const DisplacementSpace<dim> &space, const Materials &materials,
                       const Deformation &deformation, bool is_mirrored = false);

/// The same for the displacement space of a body.
inline std::string volume_vtu(const Body &body, const Deformation &deformation,
                              const bool is_mirrored = false)
{
  return body.visit([&](const auto &discretization)
                    { return volume_vtu(discretization, body.materials(), deformation, is_mirrored); });
}

/// PVTU text that names the pieces of several processes.
std::string volume_pvtu(const std::vector<std::string> &pieces);
} // namespace orthocone
