// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>
#include <orthocone/surface/half_space.h>

#include <memory>
#include <optional>

namespace orthocone
{
class WaveSymbols;

/// A regular grid of rectangular patches on a plane, each with a contact node at its centre. Node i + n_x j
/// is the i-th along x and the j-th along y.
struct SurfaceGrid
{
  Eigen::Index n_x, n_y;
  double width, height;     ///< of a patch, along x and y, mm
  bool is_periodic = false; ///< whether the plane repeats the grid for ever along x and y

  Eigen::Index n_nodes() const { return n_x * n_y; }

  /// The patches that have this distance in whole patches have the same compliance.
  Eigen::Vector2d distance(const Eigen::Index along_x, const Eigen::Index along_y) const
  {
    return {static_cast<double>(along_x) * width, static_cast<double>(along_y) * height};
  }
};

/// Compliance of an elastic half-space above a plane, or of two that meet there, on a regular grid: no
/// matrix, but products by fast Fourier transforms of the grid, padded with zeros to twice its size (Hockney,
/// Meth. Comput. Phys. 9 (1970) 135; for contact Liu, Wang and Liu, Wear 243 (2000) 101). A force on a node
/// is spread evenly over its patch, and a displacement is the mean over the patch, as in
/// half_space_compliance(): the products are those of a symmetric, positive definite matrix.
///
/// A periodic grid is not padded. Its symbol is that of the plane (Johnson, Contact Mechanics, 1985, 13.2),
/// summed over the waves that are alike on the grid, each with the means over patches. Mean tractions would
/// move a half-space without end against its far field: here they strain a layer as thick as the longer
/// period, so that motions count from a rigid plane at that depth, which the other waves hardly reach. Only
/// one thread at a time may use it, and no condition solver but the last one.
class GridHalfSpace : public Compliance
{
public:
  /// `body` lies above the plane, so that the normals of the nodes point into it, and `counterface` below,
  /// whose compliance is added. Throws std::invalid_argument unless the grid has nodes, and patches with a
  /// size.
  GridHalfSpace(const SurfaceGrid &grid, const HalfSpace &body,
                const std::optional<HalfSpace> &counterface = std::nullopt);
  ~GridHalfSpace() override;

  const SurfaceGrid &grid() const { return grid_; }

  /// The 3 x 3 block of W of a node by the force on another one, which lies so many patches away (mm/N), on a
  /// periodic grid with all its images.
  Eigen::Matrix3d block(Eigen::Index along_x, Eigen::Index along_y) const;

  Eigen::Index n_nodes() const override { return grid_.n_nodes(); }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;

  /// By the sum of what the loaded patches do, without a transform.
  Eigen::Vector3d displacement_at(Eigen::Index node, const NodeVector &force) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
  unsigned long n_gmres_iterations() const override;

private:
  Eigen::Matrix3d block_of_patches(Eigen::Index along_x, Eigen::Index along_y) const;
  WaveSymbols waves() const;

  SurfaceGrid grid_;
  HalfSpace body_;
  std::optional<HalfSpace> counterface_;
  class Products;
  std::unique_ptr<Products> products_;
};
} // namespace orthocone
