// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "hierarchical_matrix.h"

#include <hmat/hmat.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// What the library has made, with the function that ends its life.
template<typename Made, typename How>
std::unique_ptr<Made, How> owned(Made *const made, const How how)
{
  return {made, how};
}

/// A part of the matrix that the library asks for, with the numbers of its rows and columns.
struct Request
{
  const HierarchicalMatrix::Block *block;
  const int *rows, *columns;
};

void prepare(const int first_row, int, const int first_column, int, int *const rows, int *,
             int *const columns, int *, void *const block, hmat_block_info_t *const info)
{
  info->block_type = hmat_block_full;
  info->number_of_strata = 1;
  info->release_user_data = [](void *request) { delete static_cast<Request *>(request); };
  info->user_data = new Request{static_cast<const HierarchicalMatrix::Block *>(block), rows + first_row,
                                columns + first_column};
}

/// The blocks of the points of some rows with the point of a column. Rows that follow each other belong to
/// the same point as a rule.
class ColumnOfBlocks
{
public:
  ColumnOfBlocks(const Request &request, const hmat_block_compute_context_t &part)
      : block_(*request.block)
  {
    for (int i = 0; i < part.row_count; ++i)
    {
      const auto row = static_cast<std::size_t>(request.rows[part.row_start + i]);
      if (points_.empty() || points_.back() != row / 3)
        points_.push_back(row / 3);
      places_.push_back({points_.size() - 1, static_cast<Index>(row % 3)});
    }
    blocks_.resize(points_.size());
  }

  void set_point(const std::size_t point)
  {
    if (point == point_)
      return;
    point_ = point;
    for (std::size_t i = 0; i < points_.size(); ++i)
      blocks_[i] = block_(points_[i], point);
  }

  double operator()(const Index row, const Index direction) const
  {
    const auto [place, own] = places_[static_cast<std::size_t>(row)];
    return blocks_[place](own, direction);
  }

private:
  const HierarchicalMatrix::Block &block_;
  std::vector<std::size_t> points_;                   ///< of the rows
  std::vector<std::pair<std::size_t, Index>> places_; ///< of a row: its point among these, its direction
  std::vector<Matrix3d> blocks_;
  std::size_t point_ = std::numeric_limits<std::size_t>::max();
};

/// The entries of some rows by some columns.
void fill(hmat_block_compute_context_t *const part)
{
  const auto &request = *static_cast<const Request *>(part->user_data);
  Eigen::Map<MatrixXd> entries(static_cast<double *>(part->block), part->row_count, part->col_count);
  ColumnOfBlocks blocks(request, *part);
  for (Index j = 0; j < entries.cols(); ++j)
  {
    const auto column = static_cast<std::size_t>(request.columns[part->col_start + j]);
    blocks.set_point(column / 3);
    for (Index i = 0; i < entries.rows(); ++i)
      entries(i, j) = blocks(i, static_cast<Index>(column % 3));
  }
}

/// A tree of clusters in which every row has the place of its point.
hmat_cluster_tree_t *tree_of(const std::vector<Eigen::Vector2d> &points)
{
  MatrixXd places(2, 3 * points.size());
  for (Index row = 0; row < places.cols(); ++row)
    places.col(row) = points[static_cast<std::size_t>(row) / 3];
  const auto clustering = owned(hmat_create_clustering_median(), &hmat_delete_clustering);
  return hmat_create_cluster_tree(places.data(), 2, static_cast<int>(places.cols()), clustering.get());
}

/// Clusters are far apart where the smaller one is no wider than so many distances. Blocks of more rows are
/// divided, because each is dense until it is approximated.
hmat_admissibility_t *far_apart()
{
  hmat_admissibility_param_t how;
  hmat_init_admissibility_param(&how);
  how.eta = 2;
  how.max_width = 5000;
  return hmat_create_admissibility(&how);
}
} // namespace

class HierarchicalMatrix::Matrix
{
public:
  Matrix(const std::vector<Eigen::Vector2d> &points, Block block, const double accuracy, const Pivots pivots)
  {
    hmat_init_default_interface(&library_, HMAT_DOUBLE_PRECISION);
    if (library_.init() != 0)
      throw std::runtime_error("hmat-oss cannot be used");
    const auto admissible = owned(far_apart(), &hmat_delete_admissibility);
    hmat_cluster_tree_t *const tree = tree_of(points);
    matrix_ = library_.create_empty_hmatrix_admissibility(tree, tree, 1, admissible.get());
    library_.own_cluster_trees(matrix_, 1, 0);
    library_.set_low_rank_epsilon(matrix_, accuracy);
    assemble(block, owned(pivots == Pivots::of_all_entries ? hmat_create_compression_aca_full(accuracy)
                                                           : hmat_create_compression_aca_plus(accuracy),
                          &hmat_delete_compression)
                        .get());
  }
  ~Matrix() { library_.destroy(matrix_); }
  Matrix(const Matrix &) = delete;
  Matrix &operator=(const Matrix &) = delete;

  void vmult(VectorXd &result, VectorXd vector) const
  {
    double one = 1, zero = 0;
    result.setZero(vector.size());
    library_.gemv('N', &one, matrix_, vector.data(), &zero, result.data(), 1);
  }

  std::size_t n_numbers() const
  {
    hmat_info_t info{};
    library_.get_info(matrix_, &info);
    return info.compressed_size;
  }

private:
  void assemble(Block &block, const hmat_compression_algorithm_t *const compression)
  {
    hmat_assemble_context_t context;
    hmat_assemble_context_init(&context);
    context.compression = compression;
    context.lower_symmetric = 1;
    context.progress = nullptr;
    context.prepare = &prepare;
    context.advanced_compute = &fill;
    context.user_context = &block;
    if (library_.assemble_generic(matrix_, &context) != 0)
    {
      library_.destroy(matrix_);
      throw std::runtime_error("hmat-oss cannot approximate the matrix");
    }
  }

  hmat_interface_t library_{};
  hmat_matrix_t *matrix_ = nullptr;
};

HierarchicalMatrix::HierarchicalMatrix(const std::vector<Eigen::Vector2d> &points, const Block &block,
                                       const double accuracy, const Pivots pivots)
    : matrix_(std::make_unique<Matrix>(points, block, accuracy, pivots))
{
}

HierarchicalMatrix::~HierarchicalMatrix() = default;
HierarchicalMatrix::HierarchicalMatrix(HierarchicalMatrix &&) noexcept = default;

void HierarchicalMatrix::vmult(VectorXd &result, const VectorXd &vector) const
{
  matrix_->vmult(result, vector);
}

std::size_t HierarchicalMatrix::n_numbers() const
{
  return matrix_->n_numbers();
}
} // namespace orthocone
