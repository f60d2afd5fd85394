// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "quadratic_cell.h"
#include "surface_form.h"

#include <optional>
#include <vector>

namespace orthocone
{
/// The map of a coarse cell with curved edges. It is the map Q(u) of second order through the nodes of the
/// cell, corrected where edges and faces lie in cylinders, spheres and planes that are given.
///
/// With P_e the projection of an edge e onto its surfaces, c_e = P_e(Q) - Q is what it lacks there. Each edge
/// hands c_e to the cell with weights w_e that are bilinear across it and 1 on it, and each face f of a given
/// surface what its own projection P_f still lacks, with a weight w_f that is linear across it:
///
///   x(u) = Q(u) + sum_e w_e(u) c_e + sum_f w_f(u) [P_f(B_f) - B_f],   B_f = Q + sum_{e in f} w_e c_e on f.
///
/// This is transfinite interpolation (W. J. Gordon, C. A. Hall, Int. J. Numer. Methods Eng. 7 (1973)
/// 461-477). The values on a face depend on this face and its edges alone, so that two cells agree there.
template<int dim>
class CurvedCell
{
public:
  /// An edge along `direction`; sides[d] is 0 or 1, and sides[direction] does not count.
  struct Edge
  {
    unsigned int direction;
    std::array<unsigned int, dim> sides;
    std::vector<SurfaceForm> forms; ///< all in which it lies
  };

  /// A face of a solid across `direction`.
  struct Face
  {
    unsigned int direction, side;
    SurfaceForm form;
  };

  CurvedCell(const typename QuadraticCell<dim>::Nodes &nodes, std::vector<Edge> edges,
             std::vector<Face> faces);

  /// Place (mm) of a point of the unit cell.
  dealii::Point<dim> push_forward(const dealii::Point<dim> &unit) const;

  /// The point of the unit cell at a place, or outside of it for a place near the cell; nothing where none is
  /// found.
  std::optional<dealii::Point<dim>> pull_back(const dealii::Point<dim> &place) const;

  /// Distance of a place from the node in the middle, relative to the size of the cell.
  double distance_from_middle(const dealii::Point<dim> &place) const
  {
    return quadratic_.nodes()[QuadraticCell<dim>::n_nodes / 2].distance(place) / size_;
  }

  const QuadraticCell<dim> &quadratic() const { return quadratic_; }

  /// A box that holds the cell.
  dealii::BoundingBox<dim> box() const;

private:
  dealii::Tensor<1, dim> correction(const Edge &edge, dealii::Point<dim> unit) const;
  dealii::Tensor<1, dim> correction(const Face &face, dealii::Point<dim> unit) const;
  std::optional<dealii::Point<dim>> solve(const dealii::Point<dim> &place, dealii::Point<dim> unit) const;

  QuadraticCell<dim> quadratic_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  double size_; ///< diagonal of the box around, mm
};
} // namespace orthocone
