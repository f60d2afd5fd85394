// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "curved_cell.h"

#include <deal.II/grid/manifold.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// The geometry of a mesh whose coarse cells have curved edges: a new point is the average of the points
/// around it in the unit cell of a coarse cell that holds all of them. In a face between two coarse cells
/// both give the same point, because their maps agree there. It stays what it is when a mesh is copied,
/// halved, or shared by processes, because it knows the maps and no mesh.
template<int dim>
class CurvedManifold : public dealii::Manifold<dim, dim>
{
public:
  explicit CurvedManifold(std::vector<CurvedCell<dim>> cells);

  std::unique_ptr<dealii::Manifold<dim, dim>> clone() const override;

  /// Throws an exception of deal.II where no coarse cell holds the points.
  dealii::Point<dim> get_new_point(const dealii::ArrayView<const dealii::Point<dim>> &surrounding_points,
                                   const dealii::ArrayView<const double> &weights) const override;

  /// The same for each row of `weights`.
  void get_new_points(const dealii::ArrayView<const dealii::Point<dim>> &surrounding_points,
                      const dealii::Table<2, double> &weights,
                      dealii::ArrayView<dealii::Point<dim>> new_points) const override;

private:
  struct Chart
  {
    const CurvedCell<dim> *cell;
    std::vector<dealii::Point<dim>> units; ///< of the points
  };
  Chart chart_of(const dealii::ArrayView<const dealii::Point<dim>> &points) const;

  struct Cells; ///< with a tree of the boxes around them
  std::shared_ptr<const Cells> cells_;
};
} // namespace orthocone
