// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "cell_patches.h"

#include <orthocone/body/fe/parallelepiped.h>

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Dense>

#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace orthocone
{
/// What RecoveredStress needs of a mesh and not of its stress: the least-squares fits of the patches. They
/// are made when they are first asked for, and kept for the next steps as far as there is room. Several
/// threads may ask.
template<int dim>
class StressPatches
{
public:
  using Cell = typename DisplacementSpace<dim>::Cell;
  static constexpr int most_polynomials = 35;
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_polynomials, 1>;

  /// A cell of a patch. Its change of volume is a polynomial of the cell; `projection` makes such a one, in
  /// the polynomials of the cell (rows), of each polynomial of the patch (columns).
  struct Member
  {
    PatchCell<dim> of;
    Eigen::MatrixXd projection; ///< empty where changes of volume are not projected
  };

  /// The fits of the polynomials of a patch to values at the samples of its cells, as inverses of the normal
  /// equations: of the polynomials themselves, and of their projections.
  struct Patch
  {
    Parallelepiped<dim> frame;
    std::vector<Member> members;
    Eigen::MatrixXd inverse, inverse_of_projected;
  };

  static constexpr std::size_t usual_bytes = std::size_t{128} << 20U;

  /// Keeps patches of up to `most_bytes` in all. `space` must outlive this object, and belong to one process.
  explicit StressPatches(const DisplacementSpace<dim> &space, std::size_t most_bytes = usual_bytes);

  const CellPatches<dim> &cells() const { return cells_; }
  const dealii::QGauss<dim> &samples() const { return samples_; } ///< in the unit cell
  Eigen::Index n_polynomials() const { return n_polynomials_; }

  /// The patch of a vertex for the cells of one material.
  std::shared_ptr<const Patch> patch(unsigned int vertex, dealii::types::material_id material) const;

  /// The polynomials of a patch at a place (mm): all up to the degree of the displacement.
  Values values(const Patch &patch, const dealii::Point<dim> &place) const;

  /// Those of a cell, of one degree less, to which its change of volume is projected.
  Values values_in(const Cell &cell, const dealii::Point<dim> &place) const;

  /// The place of a point in the image of its cell.
  static dealii::Point<dim> image_of(dealii::Point<dim> place, const PatchCell<dim> &of)
  {
    for (unsigned int d = 0; d + 1 < dim; ++d)
      place[d] *= of.sign(d);
    return place;
  }

private:
  Patch made(const std::vector<PatchCell<dim>> &cells) const;
  Eigen::MatrixXd projection(const Patch &patch, const PatchCell<dim> &of,
                             const dealii::FEValues<dim> &volumes) const;

  const DisplacementSpace<dim> &space_;
  const CellPatches<dim> cells_;
  const dealii::QGauss<dim> samples_;
  const Eigen::Index n_polynomials_;
  const std::size_t most_bytes_;
  mutable std::mutex mutex_{};
  mutable std::map<std::pair<unsigned int, dealii::types::material_id>, std::shared_ptr<const Patch>> kept_{};
  mutable std::size_t bytes_ = 0;
};
} // namespace orthocone
