// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/body/options.h>
#include <orthocone/body/shapes/supports.h>
#include <orthocone/surface/section_model.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Dense>

#include <memory>
#include <mutex>
#include <vector>

namespace orthocone
{
struct ContactFace;
struct Datum;
struct FaceNode;
template<int dim>
class StressPatches;

/// Displacement space FE_Q on a mesh (mm): isoparametric for a solid (components u_x, u_y, u_z), or of a
/// section: u_r, u_z and perhaps the twist u_theta, whose forces and areas are those of whole rings, or u_x,
/// u_z and perhaps u_y, whose forces and areas are those of the thickness.
///
/// Contact nodes are at the points of FE_Q, except in the face on the axis of a revolved section: there they
/// are at the points of the Gauss-Lobatto-Jacobi rule of weight r (docs/theory.md, section 2, "The node on
/// the axis"). From degree 2 on the weights of FE_Q's nodes would be those of the Gauss-Lobatto rule times r,
/// which is 0 on the axis: the node there could carry no pressure, and the plane could not hold it. At the
/// points of the other rule all weights are positive. Only the degrees of freedom within that face change
/// their meaning: they are values at its points. The constructor throws an exception of deal.II if a contact
/// node has no positive area.
template<int dim>
class DisplacementSpace : public BodyUnknowns
{
public:
  static constexpr int dimension = dim;

  /// `section` means nothing for a solid.
  DisplacementSpace(const dealii::Triangulation<dim> &triangulation, const MeshOptions &options,
                    const HeldSurfaces &held, const SectionModel &section = {});

  const SectionModel &section() const { return section_; }
  unsigned int n_components() const { return dim == 3 ? 3 : section_.n_components(); }

  /// Direction in which a component moves, 0: x (r), 1: y (hoop), 2: z.
  unsigned int direction_of(const unsigned int component) const
  {
    constexpr std::array<unsigned char, 3> of_section{{0, 2, 1}};
    return dim == 3 ? component : of_section[component];
  }

  const dealii::DoFHandler<dim> &dof_handler() const { return dof_handler_; }
  const dealii::FESystem<dim> &fe() const { return fe_; }
  const dealii::FE_Q<dim> &scalar_fe() const { return scalar_fe_; }
  const dealii::MappingQ<dim> &mapping() const { return *mapping_; }
  unsigned int n_quadrature_points() const { return n_quadrature_points_; }
  VolumetricQuadrature volumetric_quadrature() const { return volumetric_quadrature_; }

  /// Which degrees of freedom of the DoFHandler this process owns or works with, and their order here.
  const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &partitioner() const
  {
    return partitioner_;
  }
  unsigned int local_dof(const dealii::types::global_dof_index dof) const
  {
    return partitioner_->global_to_local(dof);
  }

  /// Whether several processes share its cells.
  bool is_shared() const;

  /// Constraints, by the DoFHandler's numbers, of the held degrees of freedom (zero) and of the hanging ones
  /// (moved by others) in all cells that this process knows.
  dealii::AffineConstraints<double> constraints() const;

  /// Degrees of freedom that supports hold and the held face does not, by numbers of this process, which
  /// knows those of its cells.
  const std::vector<unsigned int> &supported() const { return supported_; }

  /// Degrees of freedom on a boundary that move in these directions (x, y, z), by the DoFHandler's numbers.
  dealii::IndexSet dofs_on(dealii::types::boundary_id boundary, const std::array<bool, 3> &directions) const;

  /// For each face of the contact surface the number of its active cell, if this process has it.
  const std::vector<unsigned int> &contact_cells() const { return contact_cells_; }

  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// Whether the cell has the contact face on the axis. Only a cell of a revolved section can have it.
  bool has_axis_face(const Cell &cell) const;

  /// Maps values of the degrees of freedom of such a cell to values at the nodes of FE_Q; both are numbered
  /// n_components a + c by scalar node a and component c.
  const Eigen::MatrixXd &axis_face_basis() const { return axis_face_basis_; }

  /// What RecoveredStress needs of the mesh, which has to belong to one process.
  const StressPatches<dim> &stress_patches() const;

private:
  struct HeldDofs
  {
    dealii::IndexSet all, supported; ///< the others by the held face and by symmetry
  };
  HeldDofs held_dofs(const HeldSurfaces &held, const Datum &datum) const;
  void add_datum(const Datum &datum, dealii::IndexSet &dofs) const;
  void make_axis_face_basis();
  dealii::IndexSet dofs_of_contact(const std::array<bool, 3> &directions) const;
  dealii::IndexSet dofs_along_contact_normals() const;
  void find_contact_surface(const dealii::AffineConstraints<double> &hanging);
  ContactFace contact_face(const Cell &cell, const std::vector<unsigned int> &nodes, Eigen::MatrixX4d weights,
                           const dealii::AffineConstraints<double> &hanging);
  FaceNode face_node(const Cell &cell, unsigned int point);
  Eigen::MatrixX4d face_weights(const dealii::FEFaceValues<dim> &values,
                                const std::vector<unsigned int> &nodes) const;

  SectionModel section_;
  bool contact_faces_down_;
  dealii::FE_Q<dim> scalar_fe_;
  dealii::FESystem<dim> fe_;
  std::shared_ptr<const dealii::MappingQ<dim>> mapping_;
  dealii::DoFHandler<dim> dof_handler_;
  HeldDofs held_; ///< of all cells that this process knows
  std::vector<unsigned int> supported_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  unsigned int n_quadrature_points_;
  VolumetricQuadrature volumetric_quadrature_;
  std::vector<unsigned int> hierarchic_; ///< numbers in scalar_fe_ of the nodes in lexicographic order
  std::vector<unsigned int> contact_cells_;
  // For a revolved section:
  std::vector<double> axis_face_points_; ///< 0 to 1
  Eigen::MatrixXd axis_face_values_;     ///< of the basis for these points, at the face's nodes of FE_Q
  Eigen::MatrixXd axis_face_basis_;
  mutable std::once_flag has_stress_patches_{};
  mutable std::shared_ptr<const StressPatches<dim>> stress_patches_{};
};

using Discretization = DisplacementSpace<3>;
using SectionDiscretization = DisplacementSpace<2>;
} // namespace orthocone
