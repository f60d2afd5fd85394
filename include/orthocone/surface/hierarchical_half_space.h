// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>
#include <orthocone/surface/half_space.h>

#include <memory>

namespace orthocone
{
/// The matrix of half_space_compliance() without the matrix: a hierarchical one, whose products are those of
/// the dense one to about 1e-8, with n log n numbers for n contact nodes (docs/performance.md, "A half-space
/// below multigrid"). The nodes need not be a grid. Only one thread at a time may use it.
class HierarchicalHalfSpace : public Compliance
{
public:
  /// Throws std::logic_error for a section, and std::runtime_error where hmat-oss fails.
  HierarchicalHalfSpace(const HalfSpace &half_space, const ContactSurface &surface,
                        const ModelSymmetry &symmetry, const LocalAxes &axes);
  ~HierarchicalHalfSpace() override;

  Eigen::Index n_nodes() const override;
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
  unsigned long n_gmres_iterations() const override;

  /// Memory that the products take, in bytes.
  double bytes() const;

private:
  class Products;
  std::unique_ptr<Products> products_;
};
} // namespace orthocone
