// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "stress_patches.h"

#include "strain_terms.h"

namespace orthocone
{
using Eigen::MatrixXd;

namespace
{
/// Products of Legendre's polynomials in coordinates from 0 to 1, of this total degree at most, by a
/// recursion that takes a tenth of the time of dealii::FE_DGP.
template<int dim>
typename StressPatches<dim>::Values polynomials_at(const unsigned int degree,
                                                   const dealii::Point<dim> &coordinates)
{
  constexpr int most_degree = 4;
  Eigen::Matrix<double, dim, Eigen::Dynamic, 0, dim, most_degree + 1> of_one(dim, degree + 1);
  of_one.col(0).setOnes();
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int n = 1; n <= degree; ++n)
      of_one(d, n) = ((2 * n - 1) * (2 * coordinates[d] - 1) * of_one(d, n - 1) -
                      (n > 1 ? (n - 1) * of_one(d, n - 2) : 0)) /
                     n;
  typename StressPatches<dim>::Values all(dim == 2 ? (degree + 1) * (degree + 2) / 2
                                                   : (degree + 1) * (degree + 2) * (degree + 3) / 6);
  Eigen::Index number = 0;
  for (unsigned int k = 0; k <= (dim == 3 ? degree : 0); ++k)
    for (unsigned int j = 0; j + k <= degree; ++j)
      for (unsigned int i = 0; i + j + k <= degree; ++i)
        all[number++] = of_one(0, i) * of_one(1, j) * (dim == 3 ? of_one(dim - 1, k) : 1);
  return all;
}

/// (B^T B)^+ of values B at samples (rows). Polynomials that vanish in all samples, as across a body that is
/// one cell thick, are left out.
MatrixXd inverse_of_normal(const MatrixXd &basis)
{
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> fit;
  fit.setThreshold(1e-8);
  const MatrixXd inverse = fit.compute(basis).pseudoInverse();
  return inverse * inverse.transpose();
}

template<int dim>
std::size_t bytes_of(const typename StressPatches<dim>::Patch &patch)
{
  Eigen::Index numbers = patch.inverse.size() + patch.inverse_of_projected.size();
  for (const auto &member : patch.members)
    numbers += member.projection.size();
  return sizeof(double) * static_cast<std::size_t>(numbers) +
         sizeof(typename StressPatches<dim>::Member) * patch.members.size();
}
} // namespace

template<int dim>
StressPatches<dim>::StressPatches(const DisplacementSpace<dim> &space, const std::size_t most_bytes)
    : space_(space),
      cells_(space),
      samples_(space.scalar_fe().degree),
      n_polynomials_(polynomials_at<dim>(space.scalar_fe().degree, {}).size()),
      most_bytes_(most_bytes)
{
}

/// In coordinates that run from 0 to 1 over about three cells, so that the polynomials are nearly orthogonal
/// on a patch.
template<int dim>
typename StressPatches<dim>::Values StressPatches<dim>::values(const Patch &patch,
                                                               const dealii::Point<dim> &place) const
{
  constexpr double middle = 0.5, n_cells = 3;
  dealii::Point<dim> coordinates = patch.frame.coordinates(place);
  for (unsigned int d = 0; d < dim; ++d)
    coordinates[d] = middle + (coordinates[d] - middle) / n_cells;
  return polynomials_at<dim>(space_.scalar_fe().degree, coordinates);
}

template<int dim>
typename StressPatches<dim>::Values StressPatches<dim>::values_in(const Cell &cell,
                                                                  const dealii::Point<dim> &place) const
{
  return polynomials_at<dim>(space_.scalar_fe().degree - 1, Parallelepiped<dim>(cell).coordinates(place));
}

/// Least squares in the cell, as ProjectedDivergence. `volumes` is at the cell.
template<int dim>
MatrixXd StressPatches<dim>::projection(const Patch &patch, const PatchCell<dim> &of,
                                        const dealii::FEValues<dim> &volumes) const
{
  MatrixXd mass, moments;
  for (const unsigned int q : volumes.quadrature_point_indices())
  {
    const Values own = values_in(of.cell, volumes.quadrature_point(q)),
                 others = values(patch, image_of(volumes.quadrature_point(q), of));
    if (q == 0)
    {
      mass.setZero(own.size(), own.size());
      moments.setZero(own.size(), others.size());
    }
    const Values weighted = StrainTerms<dim>(space_.section()).volume(volumes, q) * own;
    mass.noalias() += weighted * own.transpose();
    moments.noalias() += weighted * others.transpose();
  }
  return mass.llt().solve(moments);
}

template<int dim>
typename StressPatches<dim>::Patch StressPatches<dim>::made(const std::vector<PatchCell<dim>> &cells) const
{
  const bool is_projected = space_.volumetric_quadrature() == VolumetricQuadrature::projected;
  const dealii::UpdateFlags flags = dealii::update_quadrature_points | dealii::update_JxW_values;
  dealii::FEValues<dim> places(space_.mapping(), space_.scalar_fe(), samples_,
                               dealii::update_quadrature_points),
      volumes(space_.mapping(), space_.scalar_fe(), dealii::QGauss<dim>(space_.n_quadrature_points()), flags);
  Patch patch{Parallelepiped<dim>(cells.front().cell), {}, {}, {}};
  MatrixXd basis(cells.size() * samples_.size(), n_polynomials_),
      projected(is_projected ? basis.rows() : 0, n_polynomials_);
  Eigen::Index row = 0;
  for (const PatchCell<dim> &of : cells)
  {
    const typename dealii::Triangulation<dim>::active_cell_iterator cell(of.cell);
    places.reinit(cell);
    MatrixXd projection;
    if (is_projected)
    {
      volumes.reinit(cell);
      projection = this->projection(patch, of, volumes);
    }
    for (const dealii::Point<dim> &place : places.get_quadrature_points())
    {
      basis.row(row) = values(patch, image_of(place, of));
      if (is_projected)
        projected.row(row) = values_in(of.cell, place).transpose() * projection;
      ++row;
    }
    patch.members.push_back({of, std::move(projection)});
  }
  patch.inverse = inverse_of_normal(basis);
  if (is_projected)
    patch.inverse_of_projected = inverse_of_normal(projected);
  return patch;
}

template<int dim>
std::shared_ptr<const typename StressPatches<dim>::Patch>
StressPatches<dim>::patch(const unsigned int vertex, const dealii::types::material_id material) const
{
  const std::pair key(vertex, material);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = kept_.find(key); found != kept_.end())
      return found->second;
  }
  auto patch = std::make_shared<const Patch>(made(cells_.around(vertex, material)));
  const std::lock_guard lock(mutex_);
  if (const std::size_t bytes = bytes_of<dim>(*patch); bytes_ + bytes <= most_bytes_)
    if (kept_.emplace(key, patch).second)
      bytes_ += bytes;
  return patch;
}

template class StressPatches<2>;
template class StressPatches<3>;
} // namespace orthocone
