// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Products of the stiffness of cells with their displacements, for many cells at a time: one in each lane of
// a register. Debian's deal.II has kernels for one lane only.
#pragma once

#include <cstddef>
#include <vector>

namespace orthocone
{
constexpr std::size_t bytes_of_lanes = 64; // of the longest registers

/// A number for each of several cells.
template<typename Number>
struct alignas(bytes_of_lanes) Lanes // which the vectors alone are not in a template
{
  static constexpr unsigned int n = bytes_of_lanes / sizeof(Number);
  typedef Number Values __attribute__((vector_size(bytes_of_lanes)));
  Values values;
};

/// Hexahedra of one degree and material. Nodes and points of a cell are in lexicographic order.
template<typename Number>
struct CellBatches
{
  unsigned int n_nodes;             ///< in every direction
  unsigned int n_points;            ///< Gauss points in every direction; not fewer than nodes
  std::vector<Number> values;       ///< n_points x n_nodes: shape functions of a line at its points
  std::vector<Number> derivatives;  ///< n_points x n_points: of the polynomials through the points, there
  Number lambda;                    ///< MPa
  Number mu;                        ///< MPa
  unsigned int n_polynomials;       ///< that the divergence is projected to (make_monomials()); 0: it is not
  std::vector<unsigned int> dofs{}; ///< batches x 3 components x nodes x lanes
  std::vector<Lanes<Number>> geometry{};       ///< batches x points x n_geometry(n_polynomials)
  std::vector<Lanes<Number>> inverse_masses{}; ///< batches x n_in_triangle(n_polynomials)

  /// Numbers of a point: inverse Jacobian (row by row, 1/mm), weight (mm^3), and the three coordinates of the
  /// polynomials, if these need them.
  static constexpr unsigned int n_geometry(const unsigned int n_polynomials)
  {
    return n_polynomials > 1 ? 13 : 10;
  }

  /// Of the inverse of the polynomials' mass matrix in the cell (mm^-3): its lower triangle, by rows.
  static constexpr unsigned int n_in_triangle(const unsigned int n_polynomials)
  {
    return n_polynomials * (n_polynomials + 1) / 2;
  }
};

/// Adds the forces (N) of all cells under displacements (mm) of all degrees of freedom.
void add_products(const CellBatches<float> &cells, const float *displacement, float *forces);
void add_products(const CellBatches<double> &cells, const double *displacement, double *forces);

/// Adds the diagonals of all cells, N/mm.
void add_diagonals(const CellBatches<float> &cells, float *diagonal);
void add_diagonals(const CellBatches<double> &cells, double *diagonal);
} // namespace orthocone
