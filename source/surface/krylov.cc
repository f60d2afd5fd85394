// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "krylov.h"

#include <Eigen/Sparse>
#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>

// Eigen requires this form of a matrix that has no entries ("Matrix-free solvers" in its manual).
namespace orthocone
{
class EigenOperator;
}

namespace Eigen::internal
{
template<>
struct traits<orthocone::EigenOperator> : public traits<SparseMatrix<float>>
{
};
} // namespace Eigen::internal

namespace orthocone
{
class EigenOperator : public Eigen::EigenBase<EigenOperator>
{
public:
  using Scalar = float;
  using RealScalar = float;
  using StorageIndex = int;
  enum
  {
    ColsAtCompileTime = Eigen::Dynamic,
    MaxColsAtCompileTime = Eigen::Dynamic,
    IsRowMajor = false
  };

  explicit EigenOperator(const LinearMap &map)
      : map_(map)
  {
  }

  Eigen::Index rows() const { return map_.size; }
  Eigen::Index cols() const { return map_.size; }
  const LinearMap &map() const { return map_; }

  template<typename Vector>
  Eigen::Product<EigenOperator, Vector, Eigen::AliasFreeProduct>
  operator*(const Eigen::MatrixBase<Vector> &vector) const
  {
    return {*this, vector.derived()};
  }

private:
  const LinearMap &map_;
};

namespace
{
class EigenPreconditioner
{
public:
  EigenPreconditioner &compute(const EigenOperator &matrix)
  {
    map_ = &matrix.map();
    return *this;
  }
  EigenPreconditioner &analyzePattern(const EigenOperator &matrix) // NOLINT: names are Eigen's
  {
    return compute(matrix);
  }
  EigenPreconditioner &factorize(const EigenOperator &matrix) { return compute(matrix); }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

  template<typename Vector>
  Eigen::VectorXf solve(const Vector &vector) const
  {
    return map_->precondition(vector);
  }

private:
  const LinearMap *map_ = nullptr;
};
} // namespace
} // namespace orthocone

namespace Eigen::internal
{
template<typename Vector>
struct generic_product_impl<orthocone::EigenOperator, Vector, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<orthocone::EigenOperator, Vector,
                                generic_product_impl<orthocone::EigenOperator, Vector>>
{
  using Scalar = float;

  template<typename Destination>
  static void scaleAndAddTo( // NOLINT: names are Eigen's
      Destination &destination, const orthocone::EigenOperator &matrix, const Vector &vector,
      const Scalar &factor)
  {
    destination.noalias() += factor * matrix.map().apply(vector);
  }
};
} // namespace Eigen::internal

namespace orthocone
{
KrylovSolution solve_gmres(const LinearMap &map, const Eigen::VectorXf &right_side, const float tolerance,
                           const Eigen::Index most)
{
  if (map.size == 0)
    return {};
  const EigenOperator matrix(map);
  Eigen::GMRES<EigenOperator, EigenPreconditioner> gmres;
  gmres.set_restart(std::min(most, map.size));
  gmres.setMaxIterations(most);
  gmres.setTolerance(tolerance);
  gmres.compute(matrix);
  KrylovSolution solution{gmres.solve(right_side)};
  solution.converged = gmres.info() == Eigen::Success;
  solution.iterations = gmres.iterations();
  return solution;
}
} // namespace orthocone
