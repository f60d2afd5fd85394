// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/recovered_stress.h>

#include "cell_patches.h"
#include "known_tractions.h"
#include "strain_terms.h"
#include <orthocone/body/fe/parallelepiped.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace orthocone
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr unsigned int n_stresses = Stress::n_independent_components;

template<int dim>
dealii::Point<dim> place_of(const PointFields &point)
{
  dealii::Point<dim> place;
  for (unsigned int d = 0; d < dim; ++d)
    place[d] = point.place[dim == 2 && d == 1 ? 2 : d];
  return place;
}

/// Products of Legendre's polynomials in coordinates from 0 to 1, of this total degree at most, by a
/// recursion that takes a tenth of the time of dealii::FE_DGP.
template<int dim>
VectorXd polynomials_at(const unsigned int degree, const dealii::Point<dim> &coordinates)
{
  MatrixXd of_one(dim, degree + 1); // a row for each coordinate
  of_one.col(0).setOnes();
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int n = 1; n <= degree; ++n)
      of_one(d, n) = ((2 * n - 1) * (2 * coordinates[d] - 1) * of_one(d, n - 1) -
                      (n > 1 ? (n - 1) * of_one(d, n - 2) : 0)) /
                     n;
  VectorXd all(dim == 2 ? (degree + 1) * (degree + 2) / 2 : (degree + 1) * (degree + 2) * (degree + 3) / 6);
  Eigen::Index number = 0;
  for (unsigned int k = 0; k <= (dim == 3 ? degree : 0); ++k)
    for (unsigned int j = 0; j + k <= degree; ++j)
      for (unsigned int i = 0; i + j + k <= degree; ++i)
        all[number++] = of_one(0, i) * of_one(1, j) * (dim == 3 ? of_one(dim - 1, k) : 1);
  return all;
}

/// Row of the components of a stress, as an image has it.
template<int dim>
Eigen::RowVectorXd row_of(const Stress &stress, const PatchCell<dim> &of)
{
  Eigen::RowVectorXd row(n_stresses);
  for (unsigned int k = 0; k < n_stresses; ++k)
  {
    const auto at = Stress::unrolled_to_component_indices(k);
    row[k] = of.sign(at[0]) * of.sign(at[1]) * stress[at];
  }
  return row;
}

/// Polynomials that vanish in all samples, as across a body that is one cell thick, are left out.
MatrixXd least_squares(const MatrixXd &basis, const MatrixXd &samples)
{
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> fit;
  fit.setThreshold(1e-8);
  return fit.compute(basis).solve(samples);
}

// Where the stress is smooth, the polynomials miss the samples by an order less than the stress of the cell
// misses the truth. At the edge of a contact or of its stick zone they miss both by as much, because no
// polynomial of the patch follows the stress there: it is smeared over the patch, and that of the cell is
// better.
double share_of_recovered(const double misfit, const double change)
{
  constexpr double smooth = 0.15, edged = 0.3;
  return std::clamp((edged * change - misfit) / std::max((edged - smooth) * change, 1e-300), 0., 1.);
}
} // namespace

/// A stress whose components are polynomials in space.
template<int dim>
struct StressPolynomial
{
  Parallelepiped<dim> frame;
  MatrixXd coefficients; ///< a row for each polynomial
};

// Superconvergent patch recovery (Zienkiewicz and Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331-1364). The
// strain of a displacement of degree p is one order more accurate at the p^dim Gauss points of a cell than
// elsewhere. Around each vertex v a stress s_v whose components are polynomials of total degree p is fitted
// by least squares to the stresses at these points of a patch of cells. The stress at a place x of a cell is
// sum_v phi_v(x) s_v(x), with the multilinear shape functions phi_v of the cell's vertices: it is continuous
// where no vertex hangs, and right wherever the stress is a polynomial of degree p.
//
// A projected change of volume Pi theta has lost what is orthogonal to polynomials of degree p - 1 in each
// cell. Its polynomial t_v is therefore fitted by Pi t_v = Pi theta instead of t_v = Pi theta, and the
// stress, which is linear, is put together from both: stress(strain, theta) = stress(strain, 0) + stress(0,
// 1) theta.
template<int dim>
class RecoveredStress<dim>::Patches
{
public:
  Patches(const DisplacementSpace<dim> &space, const Materials &materials, const Deformation &deformation)
      : space_(space),
        cells_(space),
        n_polynomials_(polynomials_at<dim>(space.scalar_fe().degree, {}).size()),
        points_(space.scalar_fe().degree),
        fields_(space, materials, points_, deformation.displacement, deformation.free_strain),
        tractions_(space, deformation.tractions),
        materials_(materials),
        volumes_(space.mapping(), space.scalar_fe(), dealii::QGauss<dim>(space.n_quadrature_points()),
                 dealii::update_quadrature_points | dealii::update_JxW_values),
        projection_(space.scalar_fe().degree)
  {
  }

  Stress at(const Cell &cell, const dealii::Point<dim> &unit)
  {
    const dealii::Point<dim> place = space_.mapping().transform_unit_to_real_cell(cell, unit);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(n_stresses);
    for (const unsigned int i : cell->vertex_indices())
      if (const double share = dealii::GeometryInfo<dim>::d_linear_shape_function(unit, i); share != 0)
      {
        const StressPolynomial<dim> &of = polynomial_of(cell->vertex_index(i), cell->material_id());
        sum += share * (values(of.frame, place).transpose() * of.coefficients);
      }
    Stress stress;
    for (unsigned int k = 0; k < n_stresses; ++k)
      stress.access_raw_entry(k) = sum[k];
    constexpr double rounding = 1e-9; // in sizes of the cell
    if (dim == 2 && space_.section().is_revolved() && place[0] <= rounding * cell->diameter())
      stress[0][0] = stress[1][1] = (stress[0][0] + stress[1][1]) / 2; // one direction on the axis
    return stress;
  }

  /// The most by which the recovered stress misses that of the cells at the samples of a cell and of those
  /// that touch it, MPa. It is measured without the mean stress, of which a projected change of volume has
  /// lost a part.
  double misfit_near(const Cell &cell)
  {
    double most = 0;
    for (const unsigned int i : cell->vertex_indices())
      for (const Cell &near : cells_.cells_at(cell->vertex_index(i)))
        if (near->material_id() == cell->material_id())
          most = std::max(most, misfit_in(near));
    return most;
  }

  Stress with_known_traction(const Stress &stress, const Cell &cell, const dealii::Point<dim> &unit) const
  {
    const auto known = tractions_.at(cell, unit);
    return known ? with_traction(stress, materials_.of(cell->material_id()), *known) : stress;
  }

private:
  double misfit_in(const Cell &cell)
  {
    const auto [found, is_new] = misfits_.try_emplace(cell->active_cell_index(), 0);
    if (is_new)
      for (std::size_t i = 0; i < samples_of(cell).size(); ++i)
        found->second =
            std::max(found->second, deviator(at(cell, points_.point(i)) - samples_of(cell)[i].stress).norm());
    return found->second;
  }

  /// Of the polynomials of a frame at a place.
  VectorXd values(const Parallelepiped<dim> &frame, const dealii::Point<dim> &place) const
  {
    return polynomials_at<dim>(space_.scalar_fe().degree, frame.coordinates(place));
  }

  const std::vector<PointFields> &samples_of(const Cell &cell)
  {
    auto &samples = samples_[cell->active_cell_index()];
    if (samples.empty())
      samples = fields_.in(cell);
    return samples;
  }

  const StressPolynomial<dim> &polynomial_of(const unsigned int vertex,
                                             const dealii::types::material_id material)
  {
    StressPolynomial<dim> &found = of_vertices_[{vertex, material}];
    if (found.coefficients.size() == 0)
      found = fitted(cells_.around(vertex, material));
    return found;
  }

  /// The place of a point in the image of its cell.
  static dealii::Point<dim> image_of(dealii::Point<dim> place, const PatchCell<dim> &of)
  {
    for (unsigned int d = 0; d + 1 < dim; ++d)
      place[d] *= of.sign(d);
    return place;
  }

  /// The polynomials of a frame, projected in a cell as the change of volume is, at places (rows).
  MatrixXd projected_values(const Parallelepiped<dim> &frame, const PatchCell<dim> &of,
                            const std::vector<PointFields> &places)
  {
    volumes_.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(of.cell));
    projection_.reset(of.cell, n_polynomials_);
    for (const unsigned int q : volumes_.quadrature_point_indices())
      projection_.add(volumes_.quadrature_point(q), values(frame, image_of(volumes_.quadrature_point(q), of)),
                      StrainTerms<dim>(space_.section()).volume(volumes_, q));
    const MatrixXd coefficients = projection_.coefficients();
    MatrixXd all(places.size(), coefficients.cols());
    for (std::size_t i = 0; i < places.size(); ++i)
      all.row(static_cast<Eigen::Index>(i)) =
          projection_.polynomials_at(place_of<dim>(places[i])).transpose() * coefficients;
    return all;
  }

  StressPolynomial<dim> fitted(const std::vector<PatchCell<dim>> &patch)
  {
    const bool is_projected = space_.volumetric_quadrature() == VolumetricQuadrature::projected;
    const Parallelepiped<dim> frame(patch.front().cell);
    const Stress of_volume = materials_.of(patch.front().cell->material_id()).stress(Strain(), 1);
    const std::size_t n_in_cell = samples_of(patch.front().cell).size();
    const auto n_rows = static_cast<Eigen::Index>(patch.size() * n_in_cell);
    MatrixXd basis(n_rows, n_polynomials_), projected = basis, stresses(n_rows, n_stresses);
    VectorXd volumes(n_rows);
    Eigen::Index row = 0;
    for (const PatchCell<dim> &of : patch)
    {
      const std::vector<PointFields> &samples = samples_of(of.cell);
      if (is_projected)
        projected.middleRows(row, static_cast<Eigen::Index>(n_in_cell)) =
            projected_values(frame, of, samples);
      for (const PointFields &sample : samples)
      {
        basis.row(row) = values(frame, image_of(place_of<dim>(sample), of));
        stresses.row(row) = row_of(sample.stress - sample.volume_change * of_volume, of);
        volumes[row++] = sample.volume_change;
      }
    }
    if (!is_projected)
      projected = basis;
    const MatrixXd of_stress = least_squares(basis, stresses), of_change = least_squares(projected, volumes);
    const Eigen::RowVectorXd volumetric = row_of<dim>(of_volume, {});
    return {frame, of_stress + of_change * volumetric};
  }

  const DisplacementSpace<dim> &space_;
  const CellPatches<dim> cells_;
  const Eigen::Index n_polynomials_;
  const dealii::QGauss<dim> points_; ///< of the samples, in the unit cell
  CellFields<dim> fields_;
  const KnownTractions<dim> tractions_;
  const Materials &materials_;
  dealii::FEValues<dim> volumes_;
  ProjectedDivergence<dim> projection_;
  std::map<unsigned int, std::vector<PointFields>> samples_; ///< by active cells, as the next ones
  std::map<unsigned int, double> misfits_;
  std::map<std::pair<unsigned int, dealii::types::material_id>, StressPolynomial<dim>> of_vertices_;
};

template<int dim>
RecoveredStress<dim>::RecoveredStress(const DisplacementSpace<dim> &space, const Materials &materials,
                                      const Deformation &deformation)
    : patches_(std::make_unique<Patches>(space, materials, deformation))
{
}

template<int dim>
RecoveredStress<dim>::~RecoveredStress() = default;

template<int dim>
void RecoveredStress<dim>::enter(const Cell &cell, const std::vector<dealii::Point<dim>> &points,
                                 std::vector<PointFields> &fields)
{
  const double misfit = patches_->misfit_near(cell);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Stress change = patches_->at(cell, points[i]) - fields[i].stress;
    fields[i].stress_error = std::sqrt(1.5) * deviator(change).norm();
    fields[i].stress = patches_->with_known_traction(
        fields[i].stress + share_of_recovered(misfit, change.norm()) * change, cell, points[i]);
  }
}

template class RecoveredStress<2>;
template class RecoveredStress<3>;
} // namespace orthocone
