// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/multigrid/multigrid_body.h>

#include "multigrid_compliance.h"

#include <orthocone/base/ranks.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/node_compliance.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// Accuracy of solutions: well below the tolerance of the contact solver and the bound Checks/Equilibrium,
/// and above rounding.
double accuracy_of(const Parameters &parameters)
{
  constexpr double share = 1e-3, share_of_check = 0.1, least = 1e-12;
  return std::max(
      std::min(share * parameters.contact_solver.tolerance, share_of_check * parameters.checks.equilibrium),
      least);
}
} // namespace

struct MultigridBody::Modules
{
  Modules(const Parameters &parameters, const ModelSymmetry &symmetry, const Body &mesh,
          const std::function<LocalAxes(const ContactSurface &)> &axes_of, PhaseSeconds &seconds)
      : frame(mesh.unknowns(), axes_of(mesh.unknowns().contact_surface())),
        stiffness(timed(
            seconds.assembly, [&]
            { return std::make_unique<MatrixFreeStiffness<double>>(mesh.solid(), parameters.material); })),
        cycle(timed(seconds.factorization,
                    [&]
                    {
                      return std::make_unique<VCycle>(mesh.solid(), parameters.mesh, parameters.geometry,
                                                      parameters.material);
                    })),
        compliance(frame, *stiffness, *cycle,
                   node_compliance(mesh.unknowns().contact_surface(), symmetry, parameters.material),
                   accuracy_of(parameters))
  {
  }

  ContactFrame frame;
  std::unique_ptr<MatrixFreeStiffness<double>> stiffness;
  std::unique_ptr<VCycle> cycle;
  MultigridCompliance compliance;
};

MultigridBody::MultigridBody(const Parameters &parameters, const ModelSymmetry &symmetry,
                             const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                             const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
    : mesh_(timed(seconds.mesh, [&] { return Body(parameters, symmetry); }))
{
  on_meshed(mesh_);
  modules_ = std::make_unique<const Modules>(parameters, symmetry, mesh_, axes_of, seconds);
}

MultigridBody::~MultigridBody() = default;

/// The limits are from docs/performance.md, "Large coarsest meshes".
bool MultigridBody::aggregates_coarsest(const double n_dofs, const double n_contact_nodes)
{
  constexpr double most_dofs = 1.5e5, most_contact_nodes = 1500;
  return n_dofs > most_dofs || n_contact_nodes > most_contact_nodes;
}

const Compliance &MultigridBody::compliance() const
{
  return modules_->compliance;
}

NodeVector MultigridBody::moved_with(const RigidMotion &held) const
{
  return modules_->frame.moved_with(held);
}

Wrench MultigridBody::wrench(const NodeVector &force) const
{
  return modules_->frame.wrench(force);
}

VectorXd MultigridBody::elastic_displacement(const NodeVector &force) const
{
  return modules_->compliance.body_displacement(force);
}

VectorXd MultigridBody::with_motion(const RigidMotion &held, const VectorXd &elastic) const
{
  BodyVector<double> displacement = modules_->stiffness->make_vector();
  std::copy(elastic.begin(), elastic.end(), displacement.begin());
  displacement.update_ghost_values();
  return modules_->frame.with_motion(
      held, Eigen::Map<const VectorXd>(displacement.begin(), static_cast<Index>(unknowns().n_dofs())));
}

VectorXd MultigridBody::prolonged(const VectorXd &coarser) const
{
  return modules_->cycle->prolonged(coarser);
}

BodyMismatch MultigridBody::mismatch(const NodeVector &force, const NodeVector &elastic, double) const
{
  const VectorXd forces = modules_->frame.on_free_unknowns(force);
  BodyMismatch mismatch{0, 0, elastic_displacement(force)};
  BodyVector<double> displacement = modules_->stiffness->make_vector(), image = displacement;
  for (Index i = 0; i < forces.size(); ++i)
    displacement.local_element(i) = mismatch.volume[i];
  modules_->stiffness->vmult(image, displacement);
  double residual = 0;
  for (Index i = 0; i < forces.size(); ++i)
    residual += (image.local_element(i) - forces[i]) * (image.local_element(i) - forces[i]);
  residual = sum_over_ranks(residual);
  mismatch.unbalanced = residual == 0 ? 0 : std::sqrt(residual / sum_over_ranks(forces.squaredNorm()));
  mismatch.displacement = modules_->frame.difference(elastic, mismatch.volume);
  return mismatch;
}

unsigned long MultigridBody::n_v_cycles() const
{
  return modules_->cycle->n_cycles();
}
} // namespace orthocone
