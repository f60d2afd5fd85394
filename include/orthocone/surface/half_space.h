// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/local_axes.h>
#include <orthocone/surface/model_symmetry.h>

#include <Eigen/Dense>

namespace orthocone
{
/// An elastic, isotropic half-space below the plane z = 0.
struct HalfSpace
{
  double young_modulus; ///< MPa
  double poisson_ratio;
  unsigned int n_points = 2; ///< Gauss points per direction and part of a patch, for forces on near patches
};

/// Compliance of the surface of a half-space at the contact nodes of a model: forces r that it puts on a body
/// (N) move its own nodes by -W r (mm). The matrix is 3 n x 3 n (mm/N) in the local axes of the nodes,
/// symmetric and positive definite; directions that symmetry holds have a compliance of their own, coupled
/// with nothing.
///
/// A node's force is spread evenly over the node's patch, the part of the surface that its quadrature weight
/// stands for, and its displacement is the mean over the patch. So a uniform pressure is uniform, forces that
/// press everywhere make no tension anywhere, and W is symmetric as the solutions of Boussinesq and Cerruti
/// are (Johnson, Contact Mechanics, 1985, 3.2 and 3.6). docs/theory.md, section 2, has the formulas. Images
/// of the model are forces of their own.
///
/// Throws std::logic_error for a section: it would need the kernels of rings or strips.
Eigen::MatrixXd half_space_compliance(const HalfSpace &half_space, const ContactSurface &surface,
                                      const ModelSymmetry &symmetry, const LocalAxes &axes);
} // namespace orthocone
