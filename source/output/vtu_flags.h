// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/data_out_base.h>

namespace orthocone
{
/// How deal.II writes VTU files. They have no date, so that the same run gives the same bytes. They are
/// compressed fast, because the best compression would take more time than the whole computation. Cells
/// between all points are linear, because VTK does not find the place of a sample in a curved Lagrange cell:
/// it interpolates elsewhere, or finds nothing.
inline dealii::DataOutBase::VtkFlags vtu_flags()
{
  dealii::DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  return flags;
}

/// The flags for cells that are parallelograms, in which VTK's Lagrange cells interpolate the polynomials
/// exactly.
inline dealii::DataOutBase::VtkFlags lagrange_vtu_flags(const unsigned int degree)
{
  dealii::DataOutBase::VtkFlags flags = vtu_flags();
  flags.write_higher_order_cells = degree > 1;
  return flags;
}
} // namespace orthocone
