// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/data_out_base.h>

namespace orthocone
{
/// How deal.II writes VTU files: without a date, so that the same run gives the same bytes; compressed fast,
/// because best compression would cost more time than the whole computation; linear cells between all points,
/// because VTK does not find the place in a curved Lagrange cell where a sample is asked for: it interpolates
/// elsewhere, or finds nothing.
inline dealii::DataOutBase::VtkFlags vtu_flags()
{
  dealii::DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  return flags;
}

/// For cells that are parallelograms, where VTK's Lagrange cells interpolate the polynomials exactly.
inline dealii::DataOutBase::VtkFlags lagrange_vtu_flags(const unsigned int degree)
{
  dealii::DataOutBase::VtkFlags flags = vtu_flags();
  flags.write_higher_order_cells = degree > 1;
  return flags;
}
} // namespace orthocone
