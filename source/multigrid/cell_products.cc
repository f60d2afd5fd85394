// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Sum factorization: values at the nodes are interpolated to the Gauss points direction by direction, and
// differentiated there as polynomials through these (Kronbichler and Kormann 2012, Computers & Fluids 63).
#include "cell_products.h"

#include "point_law.h"
#include "projection.h"

#include <orthocone/base/every_processor.h>

#include <algorithm>

namespace orthocone
{
namespace
{
/// A matrix stored by rows, or its transpose.
template<typename Number>
struct LineMatrix
{
  const Number *entries;
  unsigned int row_step, column_step;
};

template<typename Number>
ORTHOCONE_INLINE LineMatrix<Number> by_rows(const Number *entries, const unsigned int n_columns)
{
  return {entries, n_columns, 1};
}

template<typename Number>
ORTHOCONE_INLINE LineMatrix<Number> transposed(const Number *entries, const unsigned int n_columns)
{
  return {entries, 1, n_columns};
}

/// out(k, a, j) = sum over i of matrix(a, i) in(k, i, j), or adds it: j < n_before, k < n_behind.
template<bool adds, typename Number>
ORTHOCONE_INLINE void contract(const LineMatrix<Number> matrix, const unsigned int n_rows,
                               const unsigned int n_columns, const Lanes<Number> *__restrict in,
                               Lanes<Number> *__restrict out, const unsigned int n_before,
                               const unsigned int n_behind)
{
#pragma GCC unroll 1
  for (unsigned int k = 0; k < n_behind; ++k)
#pragma GCC unroll 1
    for (unsigned int j = 0; j < n_before; ++j)
      for (unsigned int a = 0; a < n_rows; ++a)
      {
        const Lanes<Number> *const line = in + k * n_columns * n_before + j;
        auto sum = matrix.entries[a * matrix.row_step] * line[0].values;
        for (unsigned int i = 1; i < n_columns; ++i)
          sum += matrix.entries[a * matrix.row_step + i * matrix.column_step] * line[i * n_before].values;
        Lanes<Number> &to = out[(k * n_rows + a) * n_before + j];
        to.values = adds ? to.values + sum : sum;
      }
}

/// Workspace for the products of a batch.
template<typename Number>
struct Workspace
{
  explicit Workspace(const CellBatches<Number> &cells)
      : cell(3 * cells.n_nodes * cells.n_nodes * cells.n_nodes),
        first(cells.n_points * cells.n_points * cells.n_points),
        second(first.size()),
        gradients(9 * first.size())
  {
  }

  std::vector<Lanes<Number>> cell; ///< 3 components x nodes: displacements, then forces
  std::vector<Lanes<Number>> first, second, gradients;
};

/// The law at a Gauss point: with the gradient H in space, sigma = lambda tr(H) I + mu (H + H^T), times the
/// weight of the point. Where the divergence is projected, tr(H) is replaced by its projection in the cell to
/// complete polynomials: moments of all points first, then coefficients, then values (Projection).
/// Gradients with respect to the unit cell become those of the forces, at all points. The divergence is
/// projected to m polynomials.
template<typename Number>
ORTHOCONE_INLINE void apply_laws(const CellBatches<Number> &cells, const unsigned int n_points,
                                 const unsigned int m, const Lanes<Number> *geometry,
                                 const Lanes<Number> *inverse_mass, Lanes<Number> *gradients)
{
  const unsigned int n_geometry = CellBatches<Number>::n_geometry(m);
  Projection<Number> projection(m);
#pragma GCC unroll 1
  for (unsigned int p = 0; p < n_points && m > 0; ++p)
    projection.add(geometry + p * n_geometry, gradients + p, n_points);
  projection.solve(inverse_mass);
#pragma GCC unroll 1
  for (unsigned int p = 0; p < n_points; ++p)
  {
    const Lanes<Number> *const here = geometry + p * n_geometry;
    const PointGradient<Number> strain = in_space(here, gradients + p, n_points);
    const auto divergence = m > 0 ? projection.at(here) : strain.trace();
    apply_law(cells.mu, here, strain, cells.lambda * here[9].values * divergence, gradients + p, n_points);
  }
}

/// K u of a cell without its matrix, by sums over one direction after the other: with n nodes and q points a
/// direction a product takes some 12 q^4 multiplications for each component in place of the 3 n^6 of the
/// cell's matrix (Kronbichler and Kormann, Comput. Fluids 63 (2012) 135-147). Values are interpolated to the
/// points first, and differentiated there among the points: that takes six sums a component where derivatives
/// of the shape functions would take nine. Behind the law the same goes back, transposed.
template<typename Number>
ORTHOCONE_INLINE void multiply(const CellBatches<Number> &cells, const unsigned int n, const unsigned int q,
                               const unsigned int m, const Lanes<Number> *geometry,
                               const Lanes<Number> *inverse_mass, Workspace<Number> &work)
{
  const unsigned int n_cell = n * n * n, n_points = q * q * q;
  Lanes<Number> *const first = work.first.data(), *const second = work.second.data();
  const auto values = by_rows(cells.values.data(), n), back = transposed(cells.values.data(), n);
  const auto derivatives = by_rows(cells.derivatives.data(), q);
  const auto derivatives_back = transposed(cells.derivatives.data(), q);
#pragma GCC unroll 1
  for (unsigned int c = 0; c < 3; ++c)
  {
    Lanes<Number> *const gradient = work.gradients.data() + 3 * c * n_points;
    contract<false>(values, q, n, work.cell.data() + c * n_cell, first, 1, n * n);
    contract<false>(values, q, n, first, second, q, n);
    contract<false>(values, q, n, second, first, q * q, 1);
    contract<false>(derivatives, q, q, first, gradient, 1, q * q);
    contract<false>(derivatives, q, q, first, gradient + n_points, q, q);
    contract<false>(derivatives, q, q, first, gradient + 2 * n_points, q * q, 1);
  }
  apply_laws(cells, n_points, m, geometry, inverse_mass, work.gradients.data());
#pragma GCC unroll 1
  for (unsigned int c = 0; c < 3; ++c)
  {
    const Lanes<Number> *const gradient = work.gradients.data() + 3 * c * n_points;
    contract<false>(derivatives_back, q, q, gradient, first, 1, q * q);
    contract<true>(derivatives_back, q, q, gradient + n_points, first, q, q);
    contract<true>(derivatives_back, q, q, gradient + 2 * n_points, first, q * q, 1);
    contract<false>(back, n, q, first, second, q * q, 1);
    contract<false>(back, n, q, second, first, q, n);
    contract<false>(back, n, q, first, work.cell.data() + c * n_cell, 1, n * n);
  }
}

/// Calls `use` with the numbers of nodes n, points q and polynomials m, as constants of the compiler where
/// they are usual.
template<typename Number, typename Use>
ORTHOCONE_INLINE void with_sizes(const CellBatches<Number> &cells, const Use &use)
{
  const unsigned int n = cells.n_nodes, q = cells.n_points, m = cells.n_polynomials;
  if (n == 2 && q == 2 && m == 0)
    use(2U, 2U, 0U);
  else if (n == 3 && q == 3 && m == 0)
    use(3U, 3U, 0U);
  else if (n == 3 && q == 3 && m == 4)
    use(3U, 3U, 4U);
  else if (n == 4 && q == 4 && m == 0)
    use(4U, 4U, 0U);
  else if (n == 4 && q == 4 && m == 10)
    use(4U, 4U, 10U);
  else
    use(n, q, m);
}

/// Calls `use` with the degrees of freedom of each batch, and with the function that turns work.cell from
/// displacements into forces.
template<typename Number, typename Use>
ORTHOCONE_INLINE void for_each_batch(const CellBatches<Number> &cells, const unsigned int n,
                                     const unsigned int q, const unsigned int m, Workspace<Number> &work,
                                     const Use &use)
{
  const std::size_t n_geometry = std::size_t{CellBatches<Number>::n_geometry(m)} * q * q * q;
  const unsigned int *dofs = cells.dofs.data();
  const Lanes<Number> *inverse_mass = cells.inverse_masses.data();
  for (std::size_t at = 0; at < cells.geometry.size(); at += n_geometry)
  {
    use(dofs, [&]() ORTHOCONE_INLINE_LAMBDA
        { multiply(cells, n, q, m, cells.geometry.data() + at, inverse_mass, work); });
    dofs += 3 * n * n * n * Lanes<Number>::n;
    inverse_mass += CellBatches<Number>::n_in_triangle(m);
  }
}

template<typename Number>
ORTHOCONE_INLINE void add_all_products(const CellBatches<Number> &cells, const unsigned int n,
                                       const unsigned int q, const unsigned int m, const Number *displacement,
                                       Number *forces)
{
  constexpr unsigned int lanes = Lanes<Number>::n;
  Workspace<Number> work(cells);
  for_each_batch(cells, n, q, m, work,
                 [&](const unsigned int *dofs, const auto &multiply_batch) ORTHOCONE_INLINE_LAMBDA
                 {
                   for (unsigned int i = 0; i < 3 * n * n * n; ++i)
                     for (unsigned int lane = 0; lane < lanes; ++lane)
                       work.cell[i].values[lane] = displacement[dofs[i * lanes + lane]];
                   multiply_batch();
                   for (unsigned int i = 0; i < 3 * n * n * n; ++i)
                     for (unsigned int lane = 0; lane < lanes; ++lane)
                       forces[dofs[i * lanes + lane]] += work.cell[i].values[lane];
                 });
}

/// The diagonal of a cell, node by node: the force at a node that is the only one to move.
template<typename Number>
ORTHOCONE_INLINE void add_all_diagonals(const CellBatches<Number> &cells, const unsigned int n,
                                        const unsigned int q, const unsigned int m, Number *diagonal)
{
  constexpr unsigned int lanes = Lanes<Number>::n;
  Workspace<Number> work(cells);
  for_each_batch(cells, n, q, m, work,
                 [&](const unsigned int *dofs, const auto &multiply_batch) ORTHOCONE_INLINE_LAMBDA
                 {
                   for (unsigned int i = 0; i < 3 * n * n * n; ++i)
                   {
                     std::fill(work.cell.begin(), work.cell.end(), Lanes<Number>{});
                     work.cell[i].values += 1;
                     multiply_batch();
                     for (unsigned int lane = 0; lane < lanes; ++lane)
                       diagonal[dofs[i * lanes + lane]] += work.cell[i].values[lane];
                   }
                 });
}
} // namespace

ORTHOCONE_FOR_EVERY_PROCESSOR
void add_products(const CellBatches<float> &cells, const float *displacement, float *forces)
{
  with_sizes(cells, [&](const unsigned int n, const unsigned int q, const unsigned int m)
                        ORTHOCONE_INLINE_LAMBDA { add_all_products(cells, n, q, m, displacement, forces); });
}

ORTHOCONE_FOR_EVERY_PROCESSOR
void add_products(const CellBatches<double> &cells, const double *displacement, double *forces)
{
  with_sizes(cells, [&](const unsigned int n, const unsigned int q, const unsigned int m)
                        ORTHOCONE_INLINE_LAMBDA { add_all_products(cells, n, q, m, displacement, forces); });
}

ORTHOCONE_FOR_EVERY_PROCESSOR
void add_diagonals(const CellBatches<float> &cells, float *diagonal)
{
  add_all_diagonals(cells, cells.n_nodes, cells.n_points, cells.n_polynomials, diagonal);
}

ORTHOCONE_FOR_EVERY_PROCESSOR
void add_diagonals(const CellBatches<double> &cells, double *diagonal)
{
  add_all_diagonals(cells, cells.n_nodes, cells.n_points, cells.n_polynomials, diagonal);
}
} // namespace orthocone
