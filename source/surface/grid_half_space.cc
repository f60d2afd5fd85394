// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/grid_half_space.h>

#include "condition_system.h"
#include "grid_transform.h"
#include "rectangle_kernel.h"
#include "wave_symbols.h"

#include <orthocone/base/threads.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::VectorXf;

namespace
{
/// Displacements x, y, z (columns: of forces x, y, z) as those of the local axes (normal = z, x, y). In a
/// body above the plane everything is turned upside down.
Matrix3d local(const Matrix3d &columns, const bool is_above)
{
  const double up = is_above ? -1 : 1;
  Matrix3d result;
  result << columns(2, 2), up * columns(2, 0), up * columns(2, 1), //
      up * columns(0, 2), columns(0, 0), columns(0, 1),            //
      up * columns(1, 2), columns(1, 0), columns(1, 1);
  return result;
}

template<typename Real>
GridSymbols<Real> scaled(const GridSymbols<double> &symbols, const double factor)
{
  GridSymbols<Real> result;
  result.reserve(symbols.size());
  for (const GridSymbol<double> &symbol : symbols)
    result.push_back({static_cast<Real>(factor * symbol.nn), static_cast<Real>(factor * symbol.xx),
                      static_cast<Real>(factor * symbol.xy), static_cast<Real>(factor * symbol.yy),
                      static_cast<Real>(factor * symbol.nx), static_cast<Real>(factor * symbol.ny)});
  return result;
}

} // namespace

/// What GMRES wants of the half-space. Its preconditioner is the stiffness of the whole plane, whose symbol
/// is |k|: forces where nothing touches are dropped, as if the surface were held there (measured: the
/// iterations do not grow with the grid).
class InnerHalfSpace : public InnerOperator
{
public:
  InnerHalfSpace(const GridHalfSpace &half_space, const GridSymbols<double> &compliance,
                 const WaveSymbols &waves, const double scale, const unsigned int n_threads)
      : transform_(half_space.grid(), n_threads),
        scale_(scale),
        own_(half_space.diagonal_block(0)),
        compliance_(scaled<float>(compliance, 1 / scale))
  {
    const SurfaceGrid &grid = half_space.grid();
    const double area = grid.width * grid.height;
    const Vector2d longest =
        transform_.least_wave_numbers() / 2; // in place of the mean, which has no stiffness
    const auto symbol_at = [&](const Vector2d &k)
    {
      if (!k.isZero(0))
        return waves.stiffness(k);
      return grid.is_periodic ? waves.stiffness_of_layer(layer_below(grid)) : waves.stiffness(longest);
    };
    stiffness_ = scaled<float>(transform_.symbols_at(symbol_at), scale * area);
  }

  double scale() const override { return scale_; }
  Matrix3d own(Index) const override { return own_; }
  VectorXf multiply(const VectorXf &vector) const override { return transform_.product(compliance_, vector); }
  VectorXf multiply_stiffness(const VectorXf &vector) const override
  {
    return transform_.product(stiffness_, vector);
  }

private:
  GridTransform<float> transform_;
  double scale_;
  Matrix3d own_;
  GridSymbols<float> compliance_, stiffness_{};
};

namespace
{
void require_sizes(const SurfaceGrid &grid)
{
  const bool is_good = grid.n_x > 0 && grid.n_y > 0 && std::isfinite(grid.width) && grid.width > 0 &&
                       std::isfinite(grid.height) && grid.height > 0;
  if (!is_good)
    throw std::invalid_argument(
        "a grid needs nodes in both directions, and patches with a width and a height > 0");
}
} // namespace

/// The transform and the symbols of the compliance, and what GMRES makes of them, once for all steps. They
/// are made with as many threads as BLAS has then.
class GridHalfSpace::Products
{
public:
  explicit Products(const GridHalfSpace &half_space)
      : n_threads(blas_threads()),
        transform(half_space.grid(), n_threads),
        symbols(half_space.grid().is_periodic
                    ? transform.symbols_at([&, waves = half_space.waves()](const Vector2d &k)
                                           { return waves.compliance_of_patches(half_space.grid(), k); })
                    : transform.symbols([&](const Index i, const Index j)
                                        { return half_space.block_of_patches(i, j); }))
  {
    if (half_space.grid().is_periodic)
      kernel = transform.kernel(symbols);
  }

  const InnerHalfSpace &inner(const GridHalfSpace &half_space, const double scale)
  {
    if (!inner_ || inner_->scale() != scale)
      inner_ =
          std::make_unique<const InnerHalfSpace>(half_space, symbols, half_space.waves(), scale, n_threads);
    return *inner_;
  }

  unsigned int n_threads;
  unsigned long n_iterations = 0; ///< of GMRES
  GridTransform<double> transform;
  GridSymbols<double> symbols;
  GridSymbols<double> kernel; ///< of a periodic grid

private:
  std::unique_ptr<const InnerHalfSpace> inner_;
};

GridHalfSpace::GridHalfSpace(const SurfaceGrid &grid, const HalfSpace &body,
                             const std::optional<HalfSpace> &counterface)
    : grid_(grid),
      body_(body),
      counterface_(counterface)
{
  require_sizes(grid);
  products_ = std::make_unique<Products>(*this);
}

GridHalfSpace::~GridHalfSpace() = default;

WaveSymbols GridHalfSpace::waves() const
{
  return {body_, counterface_};
}

Matrix3d GridHalfSpace::block(const Index along_x, const Index along_y) const
{
  if (!grid_.is_periodic)
    return block_of_patches(along_x, along_y);
  const auto within = [](const Index i, const Index n) { return (i % n + n) % n; };
  const GridSymbol<double> &at =
      products_->kernel[within(along_y, grid_.n_y) * grid_.n_x + within(along_x, grid_.n_x)];
  Matrix3d block;
  block << at.nn, at.nx, at.ny, -at.nx, at.xx, at.xy, -at.ny, at.xy, at.yy;
  return block;
}

/// Without images.
Matrix3d GridHalfSpace::block_of_patches(const Index along_x, const Index along_y) const
{
  const Vector2d distance = grid_.distance(along_x, along_y);
  const HalfSpaceKernel kernel = mean_over_rectangles(grid_.width, grid_.height, distance[0], distance[1]);
  Matrix3d sum = local(kernel.displacements(body_), true);
  if (counterface_)
    sum += local(kernel.displacements(*counterface_), false);
  return sum;
}

void GridHalfSpace::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = products_->transform.product(products_->symbols, force);
}

Matrix3d GridHalfSpace::diagonal_block(Index) const
{
  return block(0, 0);
}

Eigen::Vector3d GridHalfSpace::displacement_at(const Index node, const NodeVector &force) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index other = 0; other < n_nodes(); ++other)
    if (const auto of_other = force.segment<3>(3 * other); !of_other.isZero(0))
      sum += block(node % grid_.n_x - other % grid_.n_x, node / grid_.n_x - other / grid_.n_x) * of_other;
  return sum;
}

std::unique_ptr<ConditionSolver> GridHalfSpace::condition_solver(const double softness) const
{
  // Newton's steps with less change the status of few nodes at a time: on 128 x 128 patches five times as
  // many.
  constexpr double least_accuracy = 1e-2;
  return std::make_unique<GmresConditions>(products_->inner(*this, softness), least_accuracy,
                                           products_->n_iterations);
}

unsigned long GridHalfSpace::n_gmres_iterations() const
{
  return products_->n_iterations;
}
} // namespace orthocone
