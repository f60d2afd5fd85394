// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/hierarchical_half_space.h>

#include "condition_system.h"
#include "half_space_nodes.h"
#include "neighbour_stiffness.h"

#include <stdexcept>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;

namespace
{
using Pivots = HierarchicalMatrix::Pivots;

/// The compliance for GMRES, which wants two digits of a product: fewer numbers make it three times as quick.
class InnerHierarchical : public InnerOperator
{
public:
  InnerHierarchical(const HalfSpaceNodes &nodes, const double scale)
      : nodes_(nodes),
        matrix_(nodes.between_places(accuracy, Pivots::of_some_rows)),
        scale_(scale),
        stiffness_(nodes.n(), scale)
  {
    const auto block = [&](const Index i, const Index j) { return nodes.block(i, j); };
    for (const std::vector<Index> &nearest : nodes.neighbours(NeighbourStiffness::n_held))
    {
      stiffness_.hold(nearest, block);
      own_.push_back(block(nearest.front(), nearest.front()));
    }
  }

  double scale() const override { return scale_; }
  Matrix3d own(const Index node) const override { return own_[static_cast<std::size_t>(node)]; }
  Eigen::VectorXf multiply(const Eigen::VectorXf &vector) const override
  {
    return (nodes_.product(matrix_, vector.cast<double>()) / scale_).cast<float>();
  }
  Eigen::VectorXf multiply_stiffness(const Eigen::VectorXf &vector) const override
  {
    return stiffness_ * vector;
  }

private:
  static constexpr double accuracy = 1e-3;

  const HalfSpaceNodes &nodes_;
  HierarchicalMatrix matrix_;
  double scale_;
  NeighbourStiffness stiffness_;
  std::vector<Matrix3d> own_;
};

const ModelSymmetry &not_of_section(const ModelSymmetry &symmetry)
{
  if (symmetry.is_section())
    throw std::logic_error("a half-space has no compliance of rings or strips");
  return symmetry;
}
} // namespace

class HierarchicalHalfSpace::Products
{
public:
  Products(const HalfSpace &half_space, const ContactSurface &surface, const ModelSymmetry &symmetry,
           const LocalAxes &axes)
      : nodes(half_space, surface, symmetry, axes),
        matrix(nodes.between_places(accuracy, Pivots::of_all_entries))
  {
  }

  const InnerOperator &inner(const double scale)
  {
    if (!inner_ || inner_->scale() != scale)
      inner_ = std::make_unique<const InnerHierarchical>(nodes, scale);
    return *inner_;
  }

  HalfSpaceNodes nodes;
  HierarchicalMatrix matrix;
  unsigned long n_iterations = 0; ///< of GMRES

private:
  static constexpr double accuracy = 1e-9;

  std::unique_ptr<const InnerOperator> inner_; ///< made where it is needed first
};

HierarchicalHalfSpace::HierarchicalHalfSpace(const HalfSpace &half_space, const ContactSurface &surface,
                                             const ModelSymmetry &symmetry, const LocalAxes &axes)
    : products_(std::make_unique<Products>(half_space, surface, not_of_section(symmetry), axes))
{
}

HierarchicalHalfSpace::~HierarchicalHalfSpace() = default;

Index HierarchicalHalfSpace::n_nodes() const
{
  return products_->nodes.n();
}

void HierarchicalHalfSpace::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement = products_->nodes.product(products_->matrix, force);
}

Matrix3d HierarchicalHalfSpace::diagonal_block(const Index node) const
{
  return products_->nodes.block(node, node);
}

std::unique_ptr<ConditionSolver> HierarchicalHalfSpace::condition_solver(const double softness) const
{
  return std::make_unique<GmresConditions>(products_->inner(softness), 1., products_->n_iterations);
}

unsigned long HierarchicalHalfSpace::n_gmres_iterations() const
{
  return products_->n_iterations;
}

double HierarchicalHalfSpace::bytes() const
{
  return sizeof(double) * static_cast<double>(products_->matrix.n_numbers());
}
} // namespace orthocone
