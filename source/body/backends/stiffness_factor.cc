// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/stiffness_factor.h>

#include "dense_in_place.h"
#include "metis_order.h"

#include <cholmod.h>
#include <lapacke.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>

namespace orthocone
{
using Eigen::Index;

/// CHOLMOD's objects and their owners. The namespace is not anonymous because they are members of
/// StiffnessFactor::Cholmod, which other files of a group see.
namespace cholmod
{
TooLargeError too_large()
{
  return TooLargeError(
      "the factor of the stiffness has more than 2^31 entries, more than CHOLMOD can count: a coarser "
      "mesh or a reduced Mesh/Model needs less");
}

/// CHOLMOD's settings and memory, with errors as exceptions.
class Session
{
public:
  Session()
  {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    // Wider supernodes than by default: 3 % more entries, and up to a tenth less time (docs/performance.md).
    constexpr std::array<std::size_t, 3> most_columns{{8, 32, 96}};
    constexpr std::array<double, 3> most_zeros{{0.8, 0.2, 0.05}};
    std::copy(most_columns.begin(), most_columns.end(), common.nrelax);
    std::copy(most_zeros.begin(), most_zeros.end(), common.zrelax);
  }
  ~Session() { cholmod_finish(&common); }
  Session(const Session &) = delete;
  Session &operator=(const Session &) = delete;

  void require_success(const char *const task) const
  {
    if (common.status == CHOLMOD_NOT_POSDEF)
      throw std::runtime_error(
          std::string(task) +
          ": the stiffness matrix is not positive definite; a Poisson ratio next to 0.5 or -1, or cells "
          "that are far too flat, make it so");
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    if (common.status == CHOLMOD_TOO_LARGE)
      throw too_large();
    if (common.status < CHOLMOD_OK)
      throw std::runtime_error(std::string(task) + ": CHOLMOD fails with status " +
                               std::to_string(common.status));
  }

  cholmod_common common{};
};

/// Frees an object of CHOLMOD, also when a call throws. The session must outlive the owner.
template<typename Object, int (*free_object)(Object **, cholmod_common *)>
struct Deleter
{
  void operator()(Object *object) const { free_object(&object, common); }

  cholmod_common *common;
};

template<typename Object, int (*free_object)(Object **, cholmod_common *)>
using Owner = std::unique_ptr<Object, Deleter<Object, free_object>>;

using Sparse = Owner<cholmod_sparse, cholmod_free_sparse>;
using Dense = Owner<cholmod_dense, cholmod_free_dense>;
using Factor = Owner<cholmod_factor, cholmod_free_factor>;
} // namespace cholmod

using namespace cholmod;

namespace
{
/// Leading n x n block of a matrix as CHOLMOD's sparse matrix, without values if `matrix` is null. Its
/// columns are the rows of `matrix`, so that it has the upper triangle.
Sparse leading_block(const dealii::SparsityPattern &pattern, const dealii::SparseMatrix<double> *const matrix,
                     const unsigned int n, Session &session)
{
  std::size_t n_entries = 0;
  for (unsigned int row = 0; row < n; ++row)
    n_entries += pattern.row_length(row);
  if (n_entries > std::numeric_limits<int>::max())
    throw too_large();
  constexpr int sorted = 0, packed = 1, upper = 1;
  Sparse block(cholmod_allocate_sparse(n, n, n_entries, sorted, packed, upper,
                                       matrix != nullptr ? CHOLMOD_REAL : CHOLMOD_PATTERN, &session.common),
               {&session.common});
  session.require_success("copying the stiffness");
  auto *const starts = static_cast<int *>(block->p);
  auto *const rows = static_cast<int *>(block->i);
  auto *const values = static_cast<double *>(block->x);
  int next = 0;
  for (unsigned int row = 0; row < n; ++row)
  {
    starts[row] = next;
    for (auto entry = pattern.begin(row); entry != pattern.end(row); ++entry)
      rows[next++] = entry->column();
    if (matrix != nullptr)
      for (auto entry = matrix->begin(row); entry != matrix->end(row); ++entry)
        values[starts[row] + (entry - matrix->begin(row))] = entry->value();
  }
  starts[n] = next;
  return block;
}

/// The graph of the leading n x n block as METIS requires it: both triangles without the diagonal.
struct Graph
{
  Graph(const dealii::SparsityPattern &pattern, const unsigned int n)
      : starts(n + 1, 0)
  {
    if (2 * pattern.n_nonzero_elements() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw too_large();
    const auto for_each_edge = [&](const auto &visit)
    {
      for (unsigned int row = 0; row < n; ++row)
        for (auto entry = pattern.begin(row); entry != pattern.end(row); ++entry)
          if (entry->column() != row)
            visit(row, static_cast<unsigned int>(entry->column()));
    };
    for_each_edge([this](const unsigned int a, const unsigned int b) { ++starts[a + 1], ++starts[b + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    neighbours.resize(starts.back());
    std::vector<int> next = starts;
    for_each_edge(
        [&](const unsigned int a, const unsigned int b)
        {
          neighbours[next[a]++] = static_cast<int>(b);
          neighbours[next[b]++] = static_cast<int>(a);
        });
  }

  std::vector<int> starts;
  std::vector<int> neighbours;
};

/// Fill-reducing order of the interior unknowns, followed by the others in their own order.
std::vector<int> elimination_order(const dealii::SparsityPattern &pattern, const unsigned int n_interior)
{
  std::vector<int> order(pattern.n_rows());
  std::iota(order.begin(), order.end(), 0);
  if (n_interior > 0)
  {
    Graph graph(pattern, n_interior);
    order_by_metis(graph.starts, graph.neighbours, order);
  }
  return order;
}

/// Symbolic factorization with the contact unknowns last; null if it fails.
Factor analyze(cholmod_sparse &all, const dealii::SparsityPattern &pattern, const unsigned int n_interior,
               Session &session)
{
  std::vector<int> order = elimination_order(pattern, n_interior);
  session.common.nmethods = 1;
  session.common.method[0].ordering = CHOLMOD_GIVEN;
  return {cholmod_analyze_p(&all, order.data(), nullptr, 0, &session.common), {&session.common}};
}
} // namespace

struct StiffnessFactor::Cholmod
{
  Session session;
  Factor factor{nullptr, {&session.common}};
};

StiffnessFactor::StiffnessFactor(const dealii::SparseMatrix<double> &matrix, const unsigned int n_interior)
    : cholmod_(std::make_unique<Cholmod>()),
      n_interior_(n_interior)
{
  Session &session = cholmod_->session;
  const dealii::SparsityPattern &pattern = matrix.get_sparsity_pattern();
  const Sparse all = leading_block(pattern, &matrix, matrix.m(), session);
  cholmod_->factor = analyze(*all, pattern, n_interior, session);
  if (cholmod_->factor != nullptr)
    cholmod_factorize(all.get(), cholmod_->factor.get(), &session.common);
  session.require_success("factorizing the stiffness");
}

FactorizationCost factorization_cost(const dealii::SparsityPattern &pattern, const unsigned int n_interior)
{
  Session session;
  const Sparse all = leading_block(pattern, nullptr, pattern.n_rows(), session);
  const Factor factor = analyze(*all, pattern, n_interior, session);
  session.require_success("analysing the stiffness");
  return {static_cast<double>(factor->xsize), session.common.fl};
}

StiffnessFactor::~StiffnessFactor() = default;

Eigen::VectorXd StiffnessFactor::solve(const Eigen::VectorXd &right_side) const
{
  Session &session = cholmod_->session;
  Eigen::VectorXd copy = right_side;
  cholmod_dense view{};
  view.nrow = view.d = view.nzmax = copy.size();
  view.ncol = 1;
  view.x = copy.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  const Dense solution(cholmod_solve(CHOLMOD_A, cholmod_->factor.get(), &view, &session.common),
                       {&session.common});
  session.require_success("solving with the stiffness");
  copy = Eigen::Map<const Eigen::VectorXd>(static_cast<const double *>(solution->x), copy.size());
  return copy;
}

Index StiffnessFactor::n_trailing() const
{
  return static_cast<Eigen::Index>(cholmod_->factor->n) - n_interior_;
}

/// Copies the rows and columns from n_interior_ on of the supernodal factor, in elimination order.
void StiffnessFactor::copy_trailing_factor(Eigen::MatrixXd &matrix) const
{
  const cholmod_factor &factor = *cholmod_->factor;
  const auto *const first_column = static_cast<const int *>(factor.super);
  const auto *const first_row = static_cast<const int *>(factor.pi);
  const auto *const first_value = static_cast<const int *>(factor.px);
  const auto *const rows = static_cast<const int *>(factor.s);
  const auto *const values = static_cast<const double *>(factor.x);
  const int n_interior = static_cast<int>(n_interior_);
  for (std::size_t s = 0; s < factor.nsuper; ++s)
  {
    const int n_rows = first_row[s + 1] - first_row[s];
    for (int column = std::max(first_column[s], n_interior); column < first_column[s + 1]; ++column)
      for (int i = column - first_column[s]; i < n_rows; ++i)
        matrix(rows[first_row[s] + i] - n_interior, column - n_interior) =
            values[first_value[s] + static_cast<std::ptrdiff_t>(column - first_column[s]) * n_rows + i];
  }
}

/// Where each row in elimination order goes. Rows that belong to no unknown take what is left.
std::vector<Index> StiffnessFactor::targets(const std::vector<Index> &places, const Index size) const
{
  // CHOLMOD may have reordered the last unknowns, but must not have mixed in others.
  const auto *const order = static_cast<const int *>(cholmod_->factor->Perm) + n_interior_;
  std::vector<Index> result;
  std::vector<bool> is_taken(size, false);
  for (Index k = 0; k < n_trailing(); ++k)
  {
    const Index unknown = order[k] - static_cast<Index>(n_interior_);
    if (unknown < 0)
      throw std::logic_error("condensing the stiffness: interior unknowns among the last ones");
    result.push_back(places[unknown]);
    is_taken[places[unknown]] = true;
  }
  for (Index place = 0; place < size; ++place)
    if (!is_taken[place])
      result.push_back(place);
  return result;
}

Eigen::MatrixXd StiffnessFactor::trailing_inverse() const
{
  std::vector<Index> places(n_trailing());
  std::iota(places.begin(), places.end(), 0);
  return trailing_inverse(places, n_trailing());
}

Eigen::MatrixXd StiffnessFactor::trailing_inverse(const std::vector<Index> &places, const Index size) const
{
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  copy_trailing_factor(matrix);
  if (LAPACKE_dpotri(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(n_trailing()), matrix.data(),
                     static_cast<lapack_int>(size)) != 0)
    throw std::runtime_error("condensing the stiffness: the Schur complement is singular");
  mirror_lower_half(matrix);
  move_rows_and_columns(matrix, targets(places, size));
  return matrix;
}
} // namespace orthocone
