// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/body_unknowns.h>
#include <orthocone/elasticity/mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <Eigen/Dense>

namespace orthocone
{
/// The cylinder's section (r, z) in rectangles: the cells that the o-grid of a BodyMesh with the same options
/// has along the x axis, in the same layers. Of an odd number of core cells, half of the one on the axis is a
/// whole cell here.
class SectionMesh
{
public:
  SectionMesh(const GeometryOptions &geometry, const MeshOptions &options);

  const dealii::Triangulation<2> &triangulation() const { return triangulation_; }

private:
  dealii::Triangulation<2> triangulation_;
};

/// Displacement space (u_r, u_z) on a section. Forces and areas are those of whole rings.
///
/// Contact nodes stand at the points of FE_Q, but in the face on the axis at those of the
/// Gauss-Lobatto-Jacobi rule of weight r. The nodes of FE_Q have the weights of the Gauss-Lobatto rule times
/// r, for degrees from 2 on: nothing at the axis. The node there could carry no pressure, nor the plane hold
/// it. At the points of the other rule all weights are positive. Only the degrees of freedom within that face
/// change their meaning: they are values at its points.
class SectionDiscretization : public BodyUnknowns
{
public:
  SectionDiscretization(const dealii::Triangulation<2> &triangulation, const MeshOptions &options,
                        TopFace top_face);

  const dealii::DoFHandler<2> &dof_handler() const { return dof_handler_; }
  const dealii::FESystem<2> &fe() const { return fe_; }
  const dealii::FE_Q<2> &scalar_fe() const { return scalar_fe_; }
  const dealii::MappingQ<2> &mapping() const { return mapping_; }
  unsigned int n_quadrature_points() const { return n_quadrature_points_; }
  VolumetricQuadrature volumetric_quadrature() const { return volumetric_quadrature_; }

  using Cell = dealii::DoFHandler<2>::active_cell_iterator;

  /// Whether the cell has the contact face on the axis.
  bool has_axis_face(const Cell &cell) const;

  /// Values of the nodes of FE_Q in such a cell from those of its degrees of freedom, both numbered 2 a + c
  /// by scalar node a and component c.
  const Eigen::MatrixXd &axis_face_basis() const { return axis_face_basis_; }

private:
  void make_axis_face_basis();
  void find_contact_surface();
  void add_contact_face(const Cell &cell);
  unsigned int contact_node(const Cell &cell, unsigned int point, double radius);
  Eigen::VectorXd face_weights(const Cell &cell) const;

  dealii::FE_Q<2> scalar_fe_;
  dealii::FESystem<2> fe_;
  dealii::MappingQ<2> mapping_;
  dealii::DoFHandler<2> dof_handler_;
  unsigned int n_quadrature_points_;
  VolumetricQuadrature volumetric_quadrature_;
  std::vector<unsigned int> hierarchic_; ///< numbers in scalar_fe_ of the nodes in lexicographic order
  std::vector<double> axis_face_points_; ///< 0 to 1
  Eigen::MatrixXd axis_face_values_;     ///< at the face's nodes of FE_Q, of the basis at axis_face_points_
  Eigen::MatrixXd axis_face_basis_;
  std::vector<unsigned int> node_of_dof_; ///< of u_z
};
} // namespace orthocone
