// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body.h>
#include <orthocone/body/deformation.h>
#include <orthocone/body/fe/cell_fields.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace orthocone
{
/// Points of the modelled part of a body: the cells that they lie in, found once, and the fields there. A
/// point where several cells meet has the mean of their fields, because stress jumps between cells, and no
/// cell has the right to it. A half-space has the closed forms of its tractions. Where several processes
/// share the body, all must make this object and ask it, and all get the same.
class BodyPoints
{
public:
  /// `points` (x, y, z) are in mm; of a section (r, z) or (x, z) the second coordinate means nothing. `body`
  /// must outlive this object.
  BodyPoints(const Body &body, const std::vector<Eigen::Vector3d> &points);

  /// Whether point i lies in a cell, or on its boundary but for rounding.
  bool is_inside(const std::size_t i) const { return n_cells_[i] > 0; }

  /// The face of the contact surface on which point i lies, if it does; of several one that all processes
  /// know.
  std::optional<unsigned int> contact_face(const std::size_t i) const
  {
    return faces_[i] < 0 ? std::nullopt : std::optional(static_cast<unsigned int>(faces_[i]));
  }

  /// The fields at the points, with their places zero.
  std::vector<PointFields> fields(const Deformation &deformation) const;

private:
  /// A cell of this process and the points in it.
  struct InCell
  {
    int level = 0, index = 0;                   ///< of the cell
    std::vector<std::size_t> points{};          ///< numbers
    std::vector<Eigen::Vector3d> unit_points{}; ///< of a section the first two coordinates
  };
  void find_in_half_space(const std::vector<Eigen::Vector3d> &points);
  std::vector<PointFields> fields_in_half_space(const Deformation &deformation) const;
  template<int dim>
  void find(const DisplacementSpace<dim> &space, const std::vector<Eigen::Vector3d> &points);
  template<int dim>
  void add_fields(const DisplacementSpace<dim> &space, const Deformation &deformation,
                  Eigen::MatrixXd &sums) const;

  const Body &body_;
  std::vector<InCell> cells_;
  std::vector<double> n_cells_;           ///< of all processes, of each point
  std::vector<double> faces_;             ///< of each point, -1 where it is on none
  std::vector<Eigen::Vector3d> places_{}; ///< of the points of a half-space
};
} // namespace orthocone
