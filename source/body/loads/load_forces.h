// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/materials/materials.h>
#include <orthocone/body/options.h>

namespace orthocone
{
/// What a unit of each load does to a body whose nodes are fixed: one row or column for each of the m loads.
/// All but `nodal` is of the cells that this process owns.
struct LoadForces
{
  Eigen::MatrixXd nodal;    ///< n_dofs x m, N: of all degrees of freedom as if none hung
  Eigen::MatrixXd on_free;  ///< n_free x m, N: those of hanging ones are with what moves them
  Eigen::MatrixXd hindered; ///< m x m: twice the energy of free strains that no displacement follows, N mm
  Eigen::VectorXd areas;    ///< of the surfaces, mm^2
};

/// Tractions t on the faces s and free strains e_0 in the cells, by Gauss quadrature:
///   f_a = int_s N_a t ds + int B_a^T C e_0 dV,   hindered_kl = int e_0k : C : e_0l dV.
/// Loads that move surfaces, or act on the other body, leave zeros.
template<int dim>
LoadForces load_forces(const DisplacementSpace<dim> &space, const BodyOptions &options,
                       const Materials &materials);

/// Adds up what each process has of the rows of unknowns, and returns those of the free ones of this process.
template<int dim>
Eigen::MatrixXd summed(const DisplacementSpace<dim> &space, const Eigen::MatrixXd &rows);
} // namespace orthocone
