// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "load_forces.h"

#include "../fe/strain_terms.h"

#include <orthocone/body/fe/cell_dofs.h>
#include <orthocone/body/hanging_dofs.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
template<int dim>
class LoadAssembly
{
public:
  LoadAssembly(const DisplacementSpace<dim> &space, const BodyOptions &options, const Materials &materials)
      : space_(space),
        options_(options),
        materials_(materials),
        values_(space.mapping(), space.scalar_fe(), dealii::QGauss<dim>(space.n_quadrature_points()),
                dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                    dealii::update_JxW_values),
        face_values_(space.mapping(), space.scalar_fe(), dealii::QGauss<dim - 1>(space.n_quadrature_points()),
                     dealii::update_values | dealii::update_quadrature_points |
                         dealii::update_normal_vectors | dealii::update_JxW_values),
        n_loads_(static_cast<Index>(options.geometry.loads.size())),
        forces_{MatrixXd::Zero(space.n_dofs(), n_loads_), MatrixXd::Zero(space.n_dofs(), n_loads_),
                MatrixXd::Zero(n_loads_, n_loads_), VectorXd::Zero(n_loads_)}
  {
    for (Index k = 0; k < n_loads_; ++k)
      for (const std::string &surface : load(k).surfaces)
        if (options.geometry.has(load(k)))
          boundaries_.emplace_back(boundary_of_marked(options.geometry, surface), k);
  }

  LoadForces run()
  {
    for (const auto &cell : space_.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        add_cell(cell);
    forces_.on_free = summed(space_, forces_.on_free);
    return std::move(forces_);
  }

private:
  using Cell = typename DisplacementSpace<dim>::Cell;
  using MeshCell = typename dealii::Triangulation<dim>::active_cell_iterator;

  const Load &load(const Index k) const { return options_.geometry.loads[static_cast<std::size_t>(k)]; }

  /// Forces on the nodes of a cell, numbered n_components a + c.
  void add_cell(const Cell &cell)
  {
    MatrixXd of_cell = MatrixXd::Zero(space_.n_components() * space_.scalar_fe().n_dofs_per_cell(), n_loads_);
    for (Index k = 0; k < n_loads_; ++k)
      if (options_.geometry.has(load(k)) && !load(k).kind->has_surface())
        add_free_strain(cell, k, of_cell);
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        for (const auto &[boundary, k] : boundaries_)
          if (cell->face(face)->boundary_id() == boundary)
            add_traction(cell, face, k, of_cell);
    if (!of_cell.isZero(0))
      add_to_all(cell, of_cell);
  }

  void add_traction(const Cell &cell, const unsigned int face, const Index k, MatrixXd &of_cell)
  {
    face_values_.reinit(MeshCell(cell), face);
    Vector3d direction = load(k).direction;
    direction[2] *= options_.geometry.is_mirrored() ? -1 : 1;
    for (const unsigned int q : face_values_.quadrature_point_indices())
    {
      const auto &normal = face_values_.normal_vector(q);
      Vector3d out(normal[0], 0, normal[dim - 1]);
      double area = face_values_.JxW(q);
      if constexpr (dim == 3)
        out[1] = normal[1];
      else
        area *= space_.section().length_at(face_values_.quadrature_point(q)[0]);
      const Vector3d traction = load(k).kind->traction(out, direction);
      forces_.areas[k] += area;
      for (unsigned int a = 0; a < face_values_.dofs_per_cell; ++a)
        for (unsigned int c = 0; c < space_.n_components(); ++c)
          of_cell(space_.n_components() * a + c, k) +=
              face_values_.shape_value(a, q) * traction[space_.direction_of(c)] * area;
    }
  }

  void add_free_strain(const Cell &cell, const Index k, MatrixXd &of_cell)
  {
    const StrainTerms<dim> terms(space_.section());
    const Strain strain = load(k).kind->free_strain(options_.material);
    const Stress stress = materials_.of(cell->material_id()).stress(strain);
    values_.reinit(MeshCell(cell));
    for (const unsigned int q : values_.quadrature_point_indices())
    {
      const double volume = terms.volume(values_, q);
      for (Index l = 0; l < n_loads_; ++l)
        if (options_.geometry.has(load(l)))
          forces_.hindered(k, l) += volume * (stress * load(l).kind->free_strain(options_.material));
      for (unsigned int a = 0; a < values_.dofs_per_cell; ++a)
      {
        const Vector3d of_node = terms.of(values_, a, q);
        for (unsigned int c = 0; c < space_.n_components(); ++c)
          for (unsigned int m = 0; m < 3; ++m)
            if (const auto place = terms.place(c, m))
              of_cell(space_.n_components() * a + c, k) +=
                  place->sign * of_node[m] * stress[place->row][place->column] * volume;
      }
    }
  }

  void add_to_all(const Cell &cell, MatrixXd of_cell)
  {
    if (space_.has_axis_face(cell))
      of_cell = (space_.axis_face_basis().transpose() * of_cell).eval();
    const auto dofs = dofs_by_node(space_, cell);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      forces_.nodal.row(static_cast<Index>(dofs[i])) += of_cell.row(static_cast<Index>(i));
    const CellBasis moving(space_.hanging(), dofs);
    if (moving.basis.size() > 0)
      of_cell = (moving.basis.transpose() * of_cell).eval();
    for (std::size_t i = 0; i < moving.dofs.size(); ++i)
      forces_.on_free.row(static_cast<Index>(moving.dofs[i])) += of_cell.row(static_cast<Index>(i));
  }

  const DisplacementSpace<dim> &space_;
  const BodyOptions &options_;
  const Materials &materials_;
  dealii::FEValues<dim> values_;
  dealii::FEFaceValues<dim> face_values_;
  const Index n_loads_;
  LoadForces forces_;
  std::vector<std::pair<dealii::types::boundary_id, Index>> boundaries_; ///< and the loads on them
};
} // namespace

template<int dim>
LoadForces load_forces(const DisplacementSpace<dim> &space, const BodyOptions &options,
                       const Materials &materials)
{
  return LoadAssembly<dim>(space, options, materials).run();
}

template<int dim>
MatrixXd summed(const DisplacementSpace<dim> &space, const MatrixXd &rows)
{
  MatrixXd free = rows.topRows(space.n_free());
  if (!space.is_shared())
    return free;
  dealii::LinearAlgebra::distributed::Vector<double> sums(space.partitioner());
  for (Index j = 0; j < rows.cols(); ++j)
  {
    sums = 0;
    std::copy(rows.col(j).begin(), rows.col(j).end(), sums.begin());
    sums.compress(dealii::VectorOperation::add);
    free.col(j) = Eigen::Map<const VectorXd>(sums.begin(), free.rows());
  }
  return free;
}

template LoadForces load_forces(const DisplacementSpace<2> &, const BodyOptions &, const Materials &);
template LoadForces load_forces(const DisplacementSpace<3> &, const BodyOptions &, const Materials &);
template MatrixXd summed(const DisplacementSpace<2> &, const MatrixXd &);
template MatrixXd summed(const DisplacementSpace<3> &, const MatrixXd &);
} // namespace orthocone
