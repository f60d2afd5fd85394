// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/recovered_stress.h>

#include "known_tractions.h"
#include "stress_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

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

/// Row of the components of a stress, as an image has it.
template<int dim>
Eigen::Matrix<double, 1, n_stresses> row_of(const Stress &stress, const PatchCell<dim> &of)
{
  Eigen::Matrix<double, 1, n_stresses> row;
  for (unsigned int k = 0; k < n_stresses; ++k)
  {
    const auto at = Stress::unrolled_to_component_indices(k);
    row[k] = of.sign(at[0]) * of.sign(at[1]) * stress[at];
  }
  return row;
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
  std::shared_ptr<const typename StressPatches<dim>::Patch> patch;
  Eigen::Matrix<double, Eigen::Dynamic, n_stresses> coefficients; ///< a row for each polynomial
};

/// The stress of a cell at its samples, and the products of its change of volume there with the polynomials
/// of the cell.
struct CellSamples
{
  std::vector<PointFields> points;
  VectorXd volume_moments;
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
  static constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
  using Polynomials = std::array<const StressPolynomial<dim> *, n_vertices>;

  Patches(const DisplacementSpace<dim> &space, const Materials &materials, const Deformation &deformation)
      : space_(space),
        patches_(space.stress_patches()),
        fields_(space, materials, patches_.samples(), deformation.displacement, deformation.free_strain),
        tractions_(space, deformation.tractions),
        materials_(materials)
  {
  }

  /// Those of the vertices of a cell.
  Polynomials polynomials_of(const Cell &cell)
  {
    Polynomials all;
    for (unsigned int i = 0; i < n_vertices; ++i)
      all[i] = &polynomial_of(cell->vertex_index(i), cell->material_id());
    return all;
  }

  /// `unit` and `place` are the same point, in the unit cell and in space.
  Stress at(const Cell &cell, const Polynomials &polynomials, const dealii::Point<dim> &unit,
            const dealii::Point<dim> &place) const
  {
    Eigen::Matrix<double, 1, n_stresses> sum = Eigen::Matrix<double, 1, n_stresses>::Zero();
    for (unsigned int i = 0; i < n_vertices; ++i)
      if (const double share = dealii::GeometryInfo<dim>::d_linear_shape_function(unit, i); share != 0)
        sum += share *
               (patches_.values(*polynomials[i]->patch, place).transpose() * polynomials[i]->coefficients);
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
      for (const Cell &near : patches_.cells().cells_at(cell->vertex_index(i)))
        if (near->material_id() == cell->material_id())
          most = std::max(most, misfit_in(near));
    return most;
  }

  KnownTractions<dim> &tractions() { return tractions_; }
  const Material &material_of(const Cell &cell) const { return materials_.of(cell->material_id()); }

private:
  double misfit_in(const Cell &cell)
  {
    const auto [found, is_new] = misfits_.try_emplace(cell->active_cell_index(), 0);
    if (is_new)
    {
      const Polynomials polynomials = polynomials_of(cell);
      const std::vector<PointFields> &points = samples_of(cell).points;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Stress recovered = at(cell, polynomials, patches_.samples().point(i), place_of<dim>(points[i]));
        found->second = std::max(found->second, deviator(recovered - points[i].stress).norm());
      }
    }
    return found->second;
  }

  const CellSamples &samples_of(const Cell &cell)
  {
    const auto [found, is_new] = samples_.try_emplace(cell->active_cell_index());
    CellSamples &samples = found->second;
    if (is_new)
    {
      samples.points = fields_.in(cell);
      for (const PointFields &point : samples.points)
      {
        const VectorXd product = point.volume_change * patches_.values_in(cell, place_of<dim>(point));
        samples.volume_moments =
            samples.volume_moments.size() == 0 ? product : VectorXd(samples.volume_moments + product);
      }
    }
    return samples;
  }

  const StressPolynomial<dim> &polynomial_of(const unsigned int vertex,
                                             const dealii::types::material_id material)
  {
    StressPolynomial<dim> &found = of_vertices_[{vertex, material}];
    if (!found.patch)
      found = fitted(patches_.patch(vertex, material), material);
    return found;
  }

  StressPolynomial<dim> fitted(std::shared_ptr<const typename StressPatches<dim>::Patch> patch,
                               const dealii::types::material_id material)
  {
    const bool is_projected = space_.volumetric_quadrature() == VolumetricQuadrature::projected;
    const Stress of_volume = materials_.of(material).stress(Strain(), 1);
    MatrixXd stresses = MatrixXd::Zero(patches_.n_polynomials(), n_stresses);
    VectorXd volumes = VectorXd::Zero(patches_.n_polynomials());
    for (const auto &[of, projection] : patch->members)
    {
      const CellSamples &samples = samples_of(of.cell);
      for (const PointFields &sample : samples.points)
      {
        const auto values = patches_.values(*patch, StressPatches<dim>::image_of(place_of<dim>(sample), of));
        stresses.noalias() += values * row_of(sample.stress - sample.volume_change * of_volume, of);
        if (!is_projected)
          volumes += sample.volume_change * values;
      }
      if (is_projected)
        volumes += projection.transpose() * samples.volume_moments;
    }
    const MatrixXd &of_change = is_projected ? patch->inverse_of_projected : patch->inverse;
    const auto volumetric = row_of<dim>(of_volume, {});
    StressPolynomial<dim> polynomial{patch, patch->inverse * stresses};
    polynomial.coefficients += (of_change * volumes) * volumetric;
    return polynomial;
  }

  const DisplacementSpace<dim> &space_;
  const StressPatches<dim> &patches_;
  CellFields<dim> fields_;
  KnownTractions<dim> tractions_;
  const Materials &materials_;
  std::unordered_map<unsigned int, CellSamples> samples_; ///< by active cells, as the next ones
  std::unordered_map<unsigned int, double> misfits_;
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
  const auto polynomials = patches_->polynomials_of(cell);
  const auto known = patches_->tractions().at(cell, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Stress change =
        patches_->at(cell, polynomials, points[i], place_of<dim>(fields[i])) - fields[i].stress;
    fields[i].stress_error = std::sqrt(1.5) * deviator(change).norm();
    fields[i].stress += share_of_recovered(misfit, change.norm()) * change;
    if (known[i])
      fields[i].stress = with_traction(fields[i].stress, patches_->material_of(cell), *known[i]);
  }
}

template class RecoveredStress<2>;
template class RecoveredStress<3>;
} // namespace orthocone
