// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "cell_products.h"
#include "hanging_products.h"

#include <orthocone/body/fe/displacement_space.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace orthocone
{
template<typename Number>
using BodyVector = dealii::LinearAlgebra::distributed::Vector<Number>;

/// Products with the stiffness of a body, cell by cell and without its entries. Vectors (mm or N) have all
/// degrees of freedom that this process owns; held and hanging ones are zero.
template<typename Number>
class MatrixFreeStiffness
{
public:
  /// `space` must outlive this object.
  MatrixFreeStiffness(const Discretization &space, const MaterialOptions &material);

  BodyVector<Number> make_vector() const { return BodyVector<Number>(space_.partitioner()); }
  void vmult(BodyVector<Number> &forces, const BodyVector<Number> &displacement) const;

  /// The diagonal, N/mm; 0 at held and at hanging degrees of freedom.
  BodyVector<Number> diagonal() const;

private:
  void clear_held(BodyVector<Number> &vector) const;

  const Discretization &space_;
  MaterialOptions material_;
  CellBatches<Number> cells_;
  HangingProducts<Number> hanging_;
  mutable std::vector<Number> with_hanging_; ///< displacement with hanging nodes, if there are any
};
} // namespace orthocone
