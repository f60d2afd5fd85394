// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>

namespace orthocone
{
/// How much the derivatives of a displacement (mm, of all degrees of freedom) jump between cells: of every
/// active cell its share of the squared error, as Kelly, Gago, Zienkiewicz and Babuska estimate it (1983,
/// Int. J. Num. Meth. Eng. 19), but for a factor that all have. Zero in cells of other processes, all of
/// which must call it.
template<int dim>
Eigen::VectorXd squared_jumps(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement);
} // namespace orthocone
