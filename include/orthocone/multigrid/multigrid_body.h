// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/phases.h>
#include <orthocone/body/elastic_body.h>
#include <orthocone/surface/local_axes.h>

#include <functional>
#include <memory>

namespace orthocone
{
/// A body that is too large to be factorized. Products with its stiffness are done cell by cell. Solutions
/// come from conjugate gradients and multigrid, which is geometric over the refinements of the mesh and
/// algebraic on a coarsest mesh that is large. Contact laws are solved on the whole body. docs/theory.md,
/// section 3, "A body without a matrix".
class MultigridBody : public ElasticBody
{
public:
  /// The parameters of FactorizedBody. The model must be a solid. Throws what Body throws, std::runtime_error
  /// if the coarsest mesh cannot be factorized, and SolveError if its nodes cannot be aggregated.
  MultigridBody(const BodyOptions &options, const ModelSymmetry &symmetry, double accuracy,
                const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds);
  ~MultigridBody() override;

  /// Whether a coarsest mesh with so many degrees of freedom and contact nodes is solved by aggregates of its
  /// nodes (Trilinos ML) and not by a factorization (docs/performance.md, "Multigrid").
  static bool aggregates_coarsest(double n_dofs, double n_contact_nodes);

  MultigridBody(const MultigridBody &) = delete; // its modules refer to each other
  MultigridBody &operator=(const MultigridBody &) = delete;

  const Body &mesh() const override { return mesh_; }
  const Compliance &compliance() const override;
  NodeVector moved_with(const RigidMotion &held) const override;
  Wrench wrench(const NodeVector &force) const override;
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const override;
  Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const override;
  Eigen::VectorXd prolonged(const Eigen::VectorXd &coarser) const override;
  BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, double bound) const override;
  unsigned long n_v_cycles() const override;

private:
  struct Modules;

  Body mesh_;
  std::unique_ptr<const Modules> modules_;
};
} // namespace orthocone
