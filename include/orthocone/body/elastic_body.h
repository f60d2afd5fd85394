// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body.h>
#include <orthocone/surface/compliance.h>
#include <orthocone/surface/rigid_motion.h>

#include <stdexcept>

namespace orthocone
{
/// How far a whole body and its compliance differ under contact forces.
struct BodyMismatch
{
  double unbalanced;      ///< ||K u - r|| / ||r|| over all free unknowns, with u = K^-1 r
  double displacement;    ///< largest difference between u and the compliance on the contact surface, mm
  Eigen::VectorXd volume; ///< u
};

/// All that scene, march, results and output know of a body. A new backend is a class of this kind. Forces
/// and displacements of contact nodes are in their local axes (normal, x, y), in N and mm.
class ElasticBody
{
public:
  virtual ~ElasticBody() = default;

  /// Mesh and unknowns.
  virtual const Body &mesh() const = 0;
  const BodyUnknowns &unknowns() const { return mesh().unknowns(); }
  const ContactSurface &surface() const { return unknowns().contact_surface(); }

  virtual const Compliance &compliance() const = 0;

  /// Displacement of every contact node, without contact forces, when the held face moves by `held`.
  virtual NodeVector moved_with(const RigidMotion &held) const = 0;

  /// Wrench of contact forces on the nodes of the model about the centre of the held face, without the copies
  /// of the model: the work of the forces on moved_with().
  virtual Wrench wrench(const NodeVector &force) const = 0;

  /// Displacements of the volume (mm) under contact forces, and the same with a motion of the held face.
  virtual Eigen::VectorXd elastic_displacement(const NodeVector &force) const = 0;
  virtual Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const = 0;

  /// A displacement of the free degrees of freedom of the mesh before the last refinement, on this one (mm).
  /// Throws std::logic_error where the body has no such mesh.
  virtual Eigen::VectorXd prolonged(const Eigen::VectorXd &coarser) const
  {
    static_cast<void>(coarser);
    throw std::logic_error("this body has no coarser mesh");
  }

  /// Of forces that move the contact nodes by `elastic` (without the motion of the held face). Rounding is
  /// kept well below `bound`.
  virtual BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, double bound) const = 0;

  /// V-cycles on the finest mesh so far, the measure of all work; 0 where the body is factorized.
  virtual unsigned long n_v_cycles() const { return 0; }
};
} // namespace orthocone
