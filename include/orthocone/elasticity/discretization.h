// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/body_unknowns.h>
#include <orthocone/elasticity/mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

namespace orthocone
{
/// Displacement space on a body mesh: isoparametric FE_Q.
class Discretization : public BodyUnknowns
{
public:
  Discretization(const dealii::Triangulation<3> &triangulation, const MeshOptions &options, TopFace top_face);

  const dealii::DoFHandler<3> &dof_handler() const { return dof_handler_; }
  const dealii::FESystem<3> &fe() const { return fe_; }
  const dealii::FE_Q<3> &scalar_fe() const { return scalar_fe_; }
  const dealii::MappingQ<3> &mapping() const { return mapping_; }
  unsigned int n_quadrature_points() const { return n_quadrature_points_; }
  VolumetricQuadrature volumetric_quadrature() const { return volumetric_quadrature_; }

private:
  std::vector<bool> held_dofs(TopFace top_face) const;
  void find_contact_surface();
  void add_contact_face(const dealii::DoFHandler<3>::active_cell_iterator &cell, unsigned int face,
                        std::vector<unsigned int> &node_of_dof);
  void lump_areas();

  dealii::FE_Q<3> scalar_fe_;
  dealii::FESystem<3> fe_;
  dealii::MappingQ<3> mapping_;
  dealii::DoFHandler<3> dof_handler_;
  unsigned int n_quadrature_points_;
  VolumetricQuadrature volumetric_quadrature_;
};
} // namespace orthocone
