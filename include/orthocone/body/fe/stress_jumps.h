// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>

namespace orthocone
{
/// Jumps of the derivatives of a displacement (mm, size n_dofs()) between cells: for each active cell its
/// share of the squared error, as Kelly, Gago, Zienkiewicz and Babuska estimate it (1983, Int. J. Num. Meth.
/// Eng. 19), up to a factor that all cells have in common. Zero in cells of other processes. All processes
/// must call it.
template<int dim>
Eigen::VectorXd squared_jumps(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement);
} // namespace orthocone
