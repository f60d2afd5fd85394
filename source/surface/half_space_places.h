// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "half_space_patches.h"

#include <orthocone/surface/half_space.h>

#include <Eigen/Sparse>

#include <vector>

namespace orthocone
{
/// The places of a model on a half-space, which are contact nodes and then hanging nodes: their patches and
/// the images of these.
class HalfSpacePlaces
{
public:
  /// `n_points`: HalfSpace::n_points.
  HalfSpacePlaces(const ContactSurface &surface, const ModelSymmetry &symmetry, unsigned int n_points);

  std::size_t n() const { return images_.size(); }

  /// Area of the patch within the model, mm^2.
  double area(const std::size_t place) const { return share(place) * own(place).area; }

  /// Displacement of a place (mm) by unit forces (N) of the model at another place, which are the columns, in
  /// global axes. They stand for the forces at all its images.
  Eigen::Matrix3d displacements(const HalfSpace &half_space, std::size_t place, std::size_t source) const;

  /// How forces on contact nodes are divided among places, 3 n() x 3 n_nodes. Tractions at hanging places are
  /// sums over contact nodes, so that a node stands for parts of their patches, too: its force is divided
  /// among places, and its displacement is the mean over these, the transposed of this.
  Eigen::SparseMatrix<double> division(const ContactSurface &surface) const;

private:
  double share(const std::size_t place) const
  {
    return static_cast<double>(images_[place].size()) / n_copies_;
  }

  /// The patch of the place itself: its first image, since the model comes first.
  const SurfacePatch &own(const std::size_t place) const { return patches_[images_[place].front()]; }

  WholeSurface whole_;
  std::vector<SurfacePatch> patches_; ///< of the whole surface
  std::vector<std::vector<std::size_t>> images_;
  unsigned int n_copies_;
};
} // namespace orthocone
