// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/condensed_body.h>
#include <orthocone/simulation/contact_state.h>
#include <orthocone/simulation/model_symmetry.h>
#include <orthocone/simulation/stick_area.h>

namespace orthocone
{
/// What users look at, at one node of the contact surface; vectors in global axes (x, y, z).
struct ContactFields
{
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();      ///< mm
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();              ///< mm, tangential
  double accumulated_slip = 0;                                 ///< mm
  double gap = 0;                                              ///< mm, > 0 open
  double pressure = 0;                                         ///< MPa
  Eigen::Vector3d friction_traction = Eigen::Vector3d::Zero(); ///< MPa, of the plane on the body
  double friction_criterion = -1; ///< ||r_t||_m / r_n - 1; -1 without pressure, 0 without friction
  NodeStatus status = NodeStatus::open;
  Eigen::Vector3d nodal_force = Eigen::Vector3d::Zero(); ///< N, of one node of the whole surface
  double dissipated_energy = 0;                          ///< N/mm, accumulated, per area
};

/// Computes the fields of the nodes of a state. Only reads.
class ContactFieldEvaluator
{
public:
  ContactFieldEvaluator(const ContactSurface &surface, const ModelSymmetry &symmetry, const SurfaceAxes &axes,
                        const OrthotropicFriction &law, const MaterialOptions &material);

  ContactFields fields(const ContactState &state, unsigned int node) const;
  std::vector<ContactFields> all_fields(const ContactState &state) const;

  /// Area that sticks in the whole body, mm^2.
  double stick_area(const ContactState &state) const;

  const ContactSurface &surface() const { return surface_; }
  const ModelSymmetry &symmetry() const { return symmetry_; }

private:
  const ContactSurface &surface_;
  ModelSymmetry symmetry_;
  SurfaceAxes axes_;
  OrthotropicFriction law_;
  Eigen::VectorXd shares_; ///< ModelSymmetry::force_shares()
  StickArea stick_area_;
};
} // namespace orthocone
