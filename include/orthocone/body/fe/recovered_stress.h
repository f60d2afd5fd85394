// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/deformation.h>
#include <orthocone/body/fe/cell_fields.h>

#include <memory>

namespace orthocone
{
/// The stress of a displacement, recovered from the points of the cells where it is most accurate.
template<int dim>
class RecoveredStress
{
public:
  using Cell = typename DisplacementSpace<dim>::Cell;

  /// The arguments must outlive this object. `space` belongs to one process.
  RecoveredStress(const DisplacementSpace<dim> &space, const Materials &materials,
                  const Deformation &deformation);
  ~RecoveredStress();
  RecoveredStress(const RecoveredStress &) = delete;
  RecoveredStress &operator=(const RecoveredStress &) = delete;

  /// Puts the recovered stress, with the tractions that are known, in the place of that of the cell, as far
  /// as the stress is smooth, and how far both differ. `points` are where `fields` are, in the unit cell.
  /// Patches are solved when they are first asked for.
  void enter(const Cell &cell, const std::vector<dealii::Point<dim>> &points,
             std::vector<PointFields> &fields);

private:
  class Patches;
  std::unique_ptr<Patches> patches_;
};
} // namespace orthocone
