// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "planes.h"

#include <orthocone/body/backends/condensed_body.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/materials/lame.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <functional>

namespace orthocone::test
{
/// A small graded mesh; nothing in it is uniform or symmetric between top and base. With full quadrature, so
/// that forces are integrals of the stress that the strain gives (internal_forces()).
inline MeshOptions small_mesh(const unsigned int degree)
{
  MeshOptions mesh;
  mesh.core_cells = 2;
  mesh.rings = 2;
  mesh.layers = 3;
  mesh.degree = degree;
  mesh.rim_grading = 0.7;
  mesh.layer_grading = 0.8;
  mesh.volumetric_quadrature = VolumetricQuadrature::full;
  return mesh;
}

inline const GeometryOptions default_geometry;
inline const MaterialOptions default_material;

/// Body with factorized stiffness, ready to be loaded.
struct LoadableBody
{
  LoadableBody(const GeometryOptions &geometry, const MeshOptions &mesh_options,
               const MaterialOptions &material, const SymmetryPlanes &planes,
               const LocalAxes &axes = LocalAxes(0))
      : lame(material),
        mesh(geometry, mesh_options, planes),
        discretization(mesh.triangulation(), mesh_options, geometry.top_face),
        stiffness(discretization, material),
        factor(stiffness.matrix(), discretization.n_interior()),
        condensed(discretization, factor, axes)
  {
  }

  LameParameters lame;
  BodyMesh mesh;
  Discretization discretization;
  Stiffness stiffness;
  StiffnessFactor factor;
  CondensedBody condensed;
};

/// Displacement of all degrees of freedom under a motion of the held face and contact forces.
inline Eigen::VectorXd volume_displacement(const CondensedBody &body, const RigidMotion &held,
                                           const NodeVector &force)
{
  return body.frame().with_motion(held, body.elastic_displacement(force));
}

using Stress = dealii::SymmetricTensor<2, 3>;

inline Stress stress_of(const Stress &strain, const LameParameters &lame)
{
  return lame.lambda * trace(strain) * dealii::unit_symmetric_tensor<3>() + 2 * lame.mu * strain;
}

/// Integrals of stress : strain(phi_i) for all degrees of freedom, the held ones too, written independently
/// of the program's assembly.
inline Eigen::VectorXd
internal_forces(const Discretization &discretization,
                const std::function<Stress(const dealii::FEValues<3> &, unsigned int)> &stress,
                const unsigned int n_points)
{
  dealii::FEValues<3> values(discretization.mapping(), discretization.fe(), dealii::QGauss<3>(n_points),
                             dealii::update_gradients | dealii::update_values |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(discretization.n_dofs());
  std::vector<dealii::types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const Stress s = stress(values, q);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        forces[dofs[i]] +=
            s * values[dealii::FEValuesExtractors::Vector(0)].symmetric_gradient(i, q) * values.JxW(q);
    }
  }
  return forces;
}

/// Strains of a finite element displacement at the quadrature points of the cell on which `values` stand.
inline std::vector<Stress> strains_in_cell(const dealii::FEValues<3> &values,
                                           const dealii::DoFHandler<3> &dof_handler,
                                           const Eigen::VectorXd &displacement)
{
  const dealii::DoFHandler<3>::active_cell_iterator cell(
      &dof_handler.get_triangulation(), values.get_cell()->level(), values.get_cell()->index(), &dof_handler);
  std::vector<dealii::types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  std::vector<double> of_cell;
  for (const auto dof : dofs)
    of_cell.push_back(displacement[static_cast<Eigen::Index>(dof)]);
  std::vector<Stress> strains(values.n_quadrature_points);
  values[dealii::FEValuesExtractors::Vector(0)].get_function_symmetric_gradients_from_local_dof_values(
      of_cell, strains);
  return strains;
}

/// Position of every degree of freedom.
inline std::vector<dealii::Point<3>> dof_positions(const Discretization &discretization)
{
  std::vector<dealii::Point<3>> positions(discretization.n_dofs());
  std::vector<dealii::types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      positions[dofs[i]] = discretization.mapping().transform_unit_to_real_cell(
          cell, discretization.fe().unit_support_point(i));
  }
  return positions;
}

/// Forces that vary from node to node and direction to direction, without any symmetry.
inline NodeVector uneven_forces(const Eigen::Index n_nodes)
{
  NodeVector force(3 * n_nodes);
  for (Eigen::Index i = 0; i < force.size(); ++i)
    force[i] = 1000 * std::sin(1 + 0.7 * static_cast<double>(i * i));
  return force;
}
} // namespace orthocone::test
