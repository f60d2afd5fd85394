// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "grid_transform.h"

#include <orthocone/surface/half_space.h>

#include <optional>

namespace orthocone
{
/// What tractions that vary as a wave with the wave vector k (1/mm) do to half-spaces on each other: the body
/// above, and the counterface below, whose displacements are added.
class WaveSymbols
{
public:
  WaveSymbols(const HalfSpace &body, const std::optional<HalfSpace> &counterface);

  /// Displacements by tractions, mm/MPa; k is not zero.
  GridSymbol<double> compliance(const Eigen::Vector2d &k) const;

  /// Tractions by displacements, MPa/mm, without the coupling between pressure and shear.
  GridSymbol<double> stiffness(const Eigen::Vector2d &k) const;

  /// Of tractions that are the same everywhere on a layer (mm thick), which hold a rigid plane.
  GridSymbol<double> compliance_of_layer(double thickness) const;
  GridSymbol<double> stiffness_of_layer(double thickness) const;

  /// compliance() of the patches of a periodic grid, mm/N: of all waves that are the same at their centres.
  GridSymbol<double> compliance_of_patches(const SurfaceGrid &grid, const Eigen::Vector2d &k) const;

private:
  // mm/MPa times 1/mm, of both bodies
  double in_plane_ = 0;     ///< by pressure, and by shear along k
  double out_of_plane_ = 0; ///< by shear across k
  double coupling_ = 0;     ///< by pressure along k, and back
  double compression_ = 0;  ///< strain of a layer by pressure, 1/MPa
};

/// The thickness of the layer that mean tractions strain below a periodic grid: its longer period, mm.
double layer_below(const SurfaceGrid &grid);
} // namespace orthocone
