// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// CHOLMOD's orderings, each with its own analysis and factorization: free, or with the contact unknowns last.
#include "sizes.h"

#include <cholmod.h>

#include <algorithm>
#include <numeric>

namespace
{
using namespace orthocone;
using namespace orthocone::benchmarks;

/// The stiffness as CHOLMOD's matrix, whose columns are our rows: the upper triangle.
class Problem
{
public:
  explicit Problem(const Scene &scene)
      : n_(static_cast<int>(scene.discretization.n_free())),
        n_interior_(static_cast<int>(scene.discretization.n_interior()))
  {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    all = copy_of(scene.stiffness.matrix(), n_);
    interior = copy_of(scene.stiffness.matrix(), n_interior_);
  }
  ~Problem()
  {
    cholmod_free_sparse(&all, &common);
    cholmod_free_sparse(&interior, &common);
    cholmod_finish(&common);
  }
  Problem(const Problem &) = delete;
  Problem &operator=(const Problem &) = delete;

  std::vector<int> natural_order() const
  {
    std::vector<int> order(n_);
    std::iota(order.begin(), order.end(), 0);
    return order;
  }

  /// 0 for the unknowns that come first, 1 for those of the contact surface.
  std::vector<int> constraint() const
  {
    std::vector<int> last(n_, 0);
    std::fill(last.begin() + n_interior_, last.end(), 1);
    return last;
  }

  cholmod_common common{};
  cholmod_sparse *all = nullptr;
  cholmod_sparse *interior = nullptr;

private:
  cholmod_sparse *copy_of(const dealii::SparseMatrix<double> &matrix, const int n)
  {
    std::vector<int> rows, starts{0};
    std::vector<double> values;
    for (int row = 0; row < n; ++row)
    {
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
      {
        rows.push_back(static_cast<int>(entry->column()));
        values.push_back(entry->value());
      }
      starts.push_back(static_cast<int>(rows.size()));
    }
    cholmod_sparse *const copy = cholmod_allocate_sparse(n, n, rows.size(), 0, 1, 1, CHOLMOD_REAL, &common);
    std::copy(starts.begin(), starts.end(), static_cast<int *>(copy->p));
    std::copy(rows.begin(), rows.end(), static_cast<int *>(copy->i));
    std::copy(values.begin(), values.end(), static_cast<double *>(copy->x));
    return copy;
  }

  int n_, n_interior_;
};

using Order = std::vector<int> (*)(Problem &);

template<cholmod_sparse *Problem::*matrix>
std::vector<int> metis(Problem &p)
{
  constexpr int postorder = 1;
  auto order = p.natural_order();
  cholmod_metis(p.*matrix, nullptr, 0, postorder, order.data(), &p.common);
  return order;
}

template<cholmod_sparse *Problem::*matrix>
std::vector<int> amd(Problem &p)
{
  auto order = p.natural_order();
  cholmod_amd(p.*matrix, nullptr, 0, order.data(), &p.common);
  return order;
}

/// Minimum degree that knows of the constraint.
std::vector<int> camd_contact_last(Problem &p)
{
  auto order = p.natural_order();
  auto constraint = p.constraint();
  cholmod_camd(p.all, nullptr, 0, constraint.data(), order.data(), &p.common);
  return order;
}

void ordering(benchmark::State &state, const Order make_order)
{
  Problem problem(scene_of(state));
  for (auto _ : state)
  {
    std::vector<int> order = make_order(problem);
    problem.common.method[0].ordering = CHOLMOD_GIVEN;
    cholmod_factor *factor = cholmod_analyze_p(problem.all, order.data(), nullptr, 0, &problem.common);
    cholmod_factorize(problem.all, factor, &problem.common);
    state.counters["gigaflops"] = problem.common.fl / 1e9;
    state.counters["factor_gigabytes"] = 8 * static_cast<double>(factor->xsize) / 1e9;
    cholmod_free_factor(&factor, &problem.common);
  }
  if (problem.common.status != CHOLMOD_OK)
    state.SkipWithError("CHOLMOD fails");
}
BENCHMARK_CAPTURE(ordering, metis, metis<&Problem::all>)->Apply(all_sizes);
BENCHMARK_CAPTURE(ordering, amd, amd<&Problem::all>)->Apply(all_sizes);
BENCHMARK_CAPTURE(ordering, metis_contact_last, metis<&Problem::interior>)->Apply(all_sizes);
BENCHMARK_CAPTURE(ordering, amd_contact_last, amd<&Problem::interior>)->Apply(all_sizes);
BENCHMARK_CAPTURE(ordering, camd_contact_last, camd_contact_last)->Apply(all_sizes);
} // namespace
