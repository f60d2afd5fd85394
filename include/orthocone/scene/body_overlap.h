// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Throws InputError where two bodies with normals of their own, whose contact nodes have these gaps (mm),
/// overlap by more than their meshes can miss of one surface while no interference drives that; where they
/// overlap by more than a cell; or where an interference has nothing to drive. Other scenes pass.
void require_driven_overlap(const Parameters &parameters, const Eigen::VectorXd &gaps,
                            const ContactSurface &surface);

/// The same of the parameters, whose meshes it makes. Throws InputError, too, where the lower body does not
/// lie under all of the upper one.
void require_bodies_side_by_side(const Parameters &parameters, const ModelSymmetry &symmetry);

/// Warnings of an overlap that no interference drives, so that the first step presses it apart, and of facets
/// from which nodes are measured. It makes both meshes.
std::vector<std::string> overlap_warnings(const Parameters &parameters, const ModelSymmetry &symmetry);

/// Length of the edge of the largest face around each contact node, mm.
Eigen::VectorXd cell_sizes(const ContactSurface &surface);
} // namespace orthocone
