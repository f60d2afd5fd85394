// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/grid/manifold.h>

namespace orthocone
{
/// Geometry of one of the four outer blocks of the o-grid: lines from a side of the core square to the rim.
/// The chart coordinates are (s, t, z): depth s from core (0) to rim (1), and place t along the side, from -1
/// to 1. A ring between two depths has the same thickness everywhere, which chords between its vertices would
/// not give.
class RingManifold : public dealii::ChartManifold<3, 3>
{
public:
  /// `block`: quarter turns from the block around the positive x axis.
  RingManifold(double radius, double half_side, unsigned int block);

  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override;
  dealii::Point<3> pull_back(const dealii::Point<3> &point) const override;
  dealii::Point<3> push_forward(const dealii::Point<3> &chart) const override;

private:
  /// A point turned by quarter turns.
  static dealii::Point<3> turned(const dealii::Point<3> &point, unsigned int n_quarters);

  double radius_;
  double half_side_;
  unsigned int block_;
};
} // namespace orthocone
