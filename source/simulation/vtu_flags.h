// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/data_out_base.h>

namespace orthocone
{
/// How all VTU files are written: without a date, so that the same run gives the same bytes; compressed fast,
/// because best compression would cost more time than the whole computation; Lagrange cells for curved
/// elements.
inline dealii::DataOutBase::VtkFlags vtu_flags(const unsigned int degree)
{
  dealii::DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.write_higher_order_cells = degree > 1;
  return flags;
}
} // namespace orthocone
