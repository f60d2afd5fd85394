// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/phases.h>
#include <orthocone/body/elastic_body.h>
#include <orthocone/contact/problem/contact_system.h>
#include <orthocone/contact/problem/free_face.h>
#include <orthocone/scene/friction_field.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/lower_body.h>
#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/obstacle.h>

#include <functional>
#include <memory>
#include <optional>

namespace orthocone
{
/// Body and obstacle for one choice of parameters: the constructor meshes, factorizes and condenses the body,
/// and makes the contact system on its surface. Nothing in a scene changes from step to step but what its
/// compliance remembers to start from (Compliance::remember), so that several marches can share it one after
/// the other.
class Scene
{
public:
  /// `on_meshed` is called with the meshed body before the long work begins. Throws InputError where gap or
  /// friction are not defined at a contact node, and what the body throws.
  Scene(const Parameters &parameters, const ModelChoice &choice,
        const std::function<void(const Body &)> &on_meshed = {});

  /// A scene on another obstacle than the parameters name; `choice` must be right for it.
  Scene(const Parameters &parameters, const ModelChoice &choice, const Obstacle &obstacle,
        const std::function<void(const Body &)> &on_meshed = {});
  Scene(const Scene &) = delete; // its modules refer to each other
  Scene &operator=(const Scene &) = delete;

  const Parameters &parameters() const { return parameters_; }
  const LoadProgram &program() const { return program_; }
  const ModelChoice &choice() const { return choice_; }
  const ModelSymmetry &symmetry() const { return choice_.symmetry; }
  const ElasticBody &body() const { return *body_; }
  const ContactSurface &surface() const { return body_->surface(); }
  const LocalAxes &axes() const { return axes_; }

  /// ContactNode::pressed_area() of the contact nodes, mm^2.
  const Eigen::VectorXd &pressed_areas() const { return pressed_areas_; }

  /// The second elastic body, or null.
  const LowerBody *lower() const { return lower_.get(); }
  const ContactSystem &system() const { return system_; }

  /// The compliance of body and obstacle together: forces r part their surfaces by W r.
  const Compliance &compliance() const { return sum_ ? *sum_ : body_->compliance(); }

  /// The part of the gap and slip of the nodes that contact forces (local axes, N) cause by moving the
  /// obstacle: 3 n, mm.
  NodeVector given_way(const NodeVector &force) const;

  /// Isotropic material of a body that would deform near its contact on a rigid obstacle as body and obstacle
  /// together do, in plane strain and in antiplane shear: the same for both, whichever is the upper one.
  /// Orthotropic materials count with the averages of MaterialOptions::isotropic().
  MaterialOptions contact_material() const;

  // In the next functions `loads` are those of the load program, FaceTarget::loads, but with the motion (mm)
  // of surfaces that find it; empty stands for none.

  /// Wrench on the held face of the whole body at this motion that balances the contact forces (local axes,
  /// N) of the model, the supports and the loads.
  Wrench held_wrench(const NodeVector &force, const RigidMotion &motion,
                     const Eigen::VectorXd &loads = {}) const;

  /// Conjugates of the loads of the whole body (Conjugate), each times the area of its surface where it acts
  /// by tractions.
  Eigen::VectorXd load_conjugates(const NodeVector &force, const RigidMotion &motion,
                                  const Eigen::VectorXd &loads) const;

  /// The number of loads of the load program.
  Eigen::Index n_loads() const { return static_cast<Eigen::Index>(parameters_.load.loads.size()); }

  /// Areas of the surfaces of the loads of the whole body, mm^2.
  Eigen::VectorXd load_areas() const;

  /// Face and loads of a state: FaceState::loads has the forces of surfaces that find their motion.
  FaceState face_state(const NodeVector &force, const RigidMotion &motion,
                       const Eigen::VectorXd &loads) const;

  /// Displacement of the contact nodes relative to the obstacle (3 n, mm) by face and loads, without contact
  /// forces.
  NodeVector driven_displacement(const RigidMotion &motion, const Eigen::VectorXd &loads) const;

  /// Elastic energy of both bodies of the whole scene, N mm.
  double elastic_energy(const NodeVector &force, const RigidMotion &motion,
                        const Eigen::VectorXd &loads) const;

  /// Displacement of the contact nodes relative to the obstacle before anything moves: their gaps, 3 n, mm.
  const NodeVector &gaps() const { return gaps_; }

  /// Gap of the undeformed surfaces at a contact node under these loads, mm: an interference closes it.
  double undeformed_gap(Eigen::Index node, const Eigen::VectorXd &loads) const;

  /// The same (3 n, mm) after motions have driven the held face, without contact forces. Components that
  /// forces drive have not moved.
  NodeVector free_displacement(const FaceTarget &target) const;

  /// change_lengths() of gap and friction, mm; empty where both are the same everywhere.
  const Eigen::VectorXd &change_lengths() const { return change_lengths_; }

  /// The face as the forces of a target drive it, with one column for each driven component that the model
  /// has. Throws std::invalid_argument as FreeFace does.
  FreeFace free_face(const FaceTarget &target) const;

  /// The components (0 to 5) of the columns of free_face(), and behind them 6 + k for a load k that finds the
  /// motion of its surface.
  std::vector<unsigned int> free_components(const FaceTarget &target) const;

  /// Wall time of mesh, assembly, factorization and condensation.
  const PhaseSeconds &seconds() const { return seconds_; }

private:
  bool is_loose(unsigned int component) const;
  void part_overlap();
  Eigen::VectorXd given_loads(const FaceTarget &target) const;
  Eigen::VectorXd conjugates(const NodeVector &force, const RigidMotion &motion,
                             const Eigen::VectorXd &loads) const;
  std::pair<NodeVector, Eigen::VectorXd> unit_answer(unsigned int component) const;

  const Parameters parameters_;
  const ModelChoice choice_;
  const LoadProgram program_;
  const FrictionField friction_;
  PhaseSeconds seconds_;
  std::shared_ptr<const ElasticBody> body_; ///< other scenes may have it, too
  LocalAxes axes_;
  Eigen::VectorXd pressed_areas_;
  std::unique_ptr<const LowerBody> lower_;
  NodeVector gaps_;
  std::optional<Eigen::Index> interference_; ///< its number among the loads
  NodeVector overlap_;                       ///< what it drives: negative gaps, 3 n, mm
  Eigen::VectorXd change_lengths_;
  std::unique_ptr<const Compliance> counterface_; ///< elastic, below a body without a dense compliance
  std::unique_ptr<const Compliance> sum_;         ///< null on a rigid obstacle
  ContactSystem system_;
};
} // namespace orthocone
