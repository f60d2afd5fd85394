// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/contact_frame.h>
#include <orthocone/body/body.h>
#include <orthocone/body/driven_field.h>
#include <orthocone/surface/compliance.h>
#include <orthocone/surface/rigid_motion.h>

#include <memory>
#include <stdexcept>

namespace orthocone
{
/// How far a whole body and its compliance differ under contact forces.
struct BodyMismatch
{
  double unbalanced;      ///< ||K u - r|| / ||r|| over all free unknowns, with u = K^-1 r
  double displacement;    ///< largest difference between u and W r on the contact surface, mm
  Eigen::VectorXd volume; ///< u, of the free degrees of freedom, mm
};

/// All that scene, march, results and output know of a body. A new backend is a class derived from this one.
/// Forces (N) and displacements (mm) of the n contact nodes have size 3 n and are in local axes (normal, x,
/// y). A body that is solved iteratively throws SolveError where it cannot be solved.
class ElasticBody
{
public:
  virtual ~ElasticBody() = default;

  /// Mesh and unknowns.
  virtual const Body &mesh() const = 0;
  const BodyUnknowns &unknowns() const { return mesh().unknowns(); }
  const ContactSurface &surface() const { return unknowns().contact_surface(); }

  /// W of the contact nodes, 3 n x 3 n, local axes, mm/N.
  virtual const Compliance &compliance() const = 0;

  /// The compliance of the body and of the elastic half-space below it together, of a body that has its own
  /// way to add both; null where the dense matrices are added.
  virtual std::unique_ptr<const Compliance> compliance_on(const MaterialOptions &counterface) const
  {
    static_cast<void>(counterface);
    return nullptr;
  }

  /// The same of a body without a dense compliance, which adds that of any counterface; null elsewhere. The
  /// counterface must outlive the sum.
  virtual std::unique_ptr<const Compliance> compliance_above(const Compliance &counterface) const
  {
    static_cast<void>(counterface);
    return nullptr;
  }

  /// The contact nodes in their local axes.
  virtual const ContactFrame &frame() const = 0;

  /// What supports add to the rigid motion of the held face, and what loads do; null where the body follows
  /// the face and has no loads.
  virtual const DrivenField *driven() const { return nullptr; }

  // In the next functions `loads` are the m loads of the scene (MPa, mm, K), of which each body takes its
  // own; empty stands for no loads.

  /// Displacement of every contact node (3 n, mm), without contact forces, when the held face moves by
  /// `held`.
  NodeVector moved_with(const RigidMotion &held, const Eigen::VectorXd &loads = {}) const;

  /// Wrench of contact forces (3 n) on the nodes of the model about the centre of the held face, without the
  /// copies of the model: its components are the work of the forces on moved_with() of unit motions.
  Wrench wrench(const NodeVector &force) const;

  /// The wrench on the held face (6), and behind it the conjugates of the m loads, of the model without its
  /// copies, under contact forces (3 n). A body without DrivenField has the wrench alone.
  Eigen::VectorXd conjugates(const NodeVector &force, const RigidMotion &held,
                             const Eigen::VectorXd &loads = {}) const;

  /// Elastic energy of the model, N mm, beyond that of contact forces alone, which is force^T W force / 2:
  /// forces do work on what tractions add to the body, but not on what motions and temperatures add.
  double driven_energy(const NodeVector &force, const RigidMotion &held,
                       const Eigen::VectorXd &loads = {}) const;

  /// Displacements of the free degrees of freedom (mm) under contact forces (3 n, N), and displacements of
  /// all degrees of freedom when the held face moves, too.
  virtual Eigen::VectorXd elastic_displacement(const NodeVector &force) const = 0;
  Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic,
                              const Eigen::VectorXd &loads = {}) const;

  /// A displacement (mm) of the free degrees of freedom of the mesh before the last refinement, interpolated
  /// to the free degrees of freedom of this one. Throws std::logic_error where the body has no such mesh.
  virtual Eigen::VectorXd prolonged(const Eigen::VectorXd &coarser) const
  {
    static_cast<void>(coarser);
    throw std::logic_error("this body has no coarser mesh");
  }

  /// Contact forces (3 n, N, global axes) on a grid of patches twice as long and wide, as forces on this one
  /// (local axes). Throws std::logic_error where the body is no grid.
  virtual NodeVector prolonged_forces(const Eigen::VectorXd &coarser) const
  {
    static_cast<void>(coarser);
    throw std::logic_error("this body is no grid");
  }

  /// The mismatch of forces (3 n) that move the contact nodes by `elastic` (3 n, without the motion of the
  /// held face). Rounding is kept well below `bound`, which is relative.
  virtual BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, double bound) const = 0;

  /// Number of V-cycles on the finest mesh so far, the measure of all work; 0 where the body is factorized.
  virtual unsigned long n_v_cycles() const { return 0; }

private:
  /// The numbers that multiply the columns of driven().
  Eigen::VectorXd driving(const RigidMotion &held, const Eigen::VectorXd &loads) const;

  /// with_motion() of a body that follows its face as a rigid one.
  virtual Eigen::VectorXd with_rigid_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const
  {
    return frame().with_motion(held, elastic);
  }
};
} // namespace orthocone
