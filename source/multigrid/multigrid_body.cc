// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/multigrid/multigrid_body.h>

#include "counterface_sum.h"
#include "multigrid_compliance.h"
#include "node_values.h"

#include <orthocone/base/ranks.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/node_compliance.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// Reports the meshed body before the long work begins.
const BodyUnknowns &announced(const Body &mesh, const std::function<void(const Body &)> &on_meshed)
{
  on_meshed(mesh);
  return mesh.unknowns();
}

class MultigridBody : public ElasticBody
{
public:
  MultigridBody(const BodyOptions &options, const ModelSymmetry &symmetry, const double accuracy,
                const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
      : mesh_(timed(seconds.mesh, [&] { return Body(options, symmetry); })),
        surface_(announced(mesh_, on_meshed).contact_surface()),
        frame_(mesh_.unknowns(), axes_of(surface_)),
        stiffness_(timed(seconds.assembly,
                         [&] { return MatrixFreeStiffness<double>(mesh_.solid(), options.material); })),
        cycle_(timed(seconds.factorization, [&]
                     { return VCycle(mesh_.solid(), options.mesh, options.geometry, options.material); })),
        compliance_(frame_, stiffness_, cycle_, node_compliance(surface_, symmetry, options.material),
                    accuracy),
        driven_(timed(seconds.condensation, [&] { return driven_field(options, symmetry); }))
  {
  }
  MultigridBody(const MultigridBody &) = delete; // its modules refer to each other
  MultigridBody &operator=(const MultigridBody &) = delete;

  const Body &mesh() const override { return mesh_; }
  const ContactFrame &frame() const override { return frame_; }
  const Compliance &compliance() const override { return compliance_; }
  std::unique_ptr<const Compliance> compliance_above(const Compliance &counterface) const override
  {
    return std::make_unique<CounterfaceSum>(compliance_, counterface);
  }
  const DrivenField *driven() const override { return driven_ ? &*driven_ : nullptr; }

  VectorXd elastic_displacement(const NodeVector &force) const override
  {
    return compliance_.body_displacement(force);
  }

  VectorXd prolonged(const VectorXd &coarser) const override { return cycle_.prolonged(coarser); }
  BodyMismatch mismatch(const NodeVector &force, const NodeVector &elastic, double bound) const override;
  unsigned long n_v_cycles() const override { return cycle_.n_cycles(); }

private:
  VectorXd with_rigid_motion(const RigidMotion &held, const VectorXd &elastic) const override
  {
    BodyVector<double> displacement = stiffness_.make_vector();
    std::copy(elastic.begin(), elastic.end(), displacement.begin());
    displacement.update_ghost_values();
    return frame_.with_motion(
        held, Eigen::Map<const VectorXd>(displacement.begin(), static_cast<Index>(unknowns().n_dofs())));
  }
  std::optional<DrivenField> driven_field(const BodyOptions &options, const ModelSymmetry &symmetry) const;

  Body mesh_;
  const ContactSurface &surface_;
  ContactFrame frame_;
  MatrixFreeStiffness<double> stiffness_;
  VCycle cycle_;
  MultigridCompliance compliance_;
  std::optional<DrivenField> driven_; ///< with supports or loads
};

std::optional<DrivenField> MultigridBody::driven_field(const BodyOptions &options,
                                                       const ModelSymmetry &symmetry) const
{
  if (!is_driven(mesh_, options))
    return std::nullopt;
  return orthocone::driven_field(mesh_, options, frame_, symmetry,
                                 [this](const VectorXd &forces) { return compliance_.displacement(forces); });
}

// The check of a step asks for what no solver owns: a solution of the whole body under the final contact
// forces, whose equilibrium K u = f is looked at with a product of its own, and whose displacement at the
// contact nodes is compared with that of the step.
BodyMismatch MultigridBody::mismatch(const NodeVector &force, const NodeVector &elastic, double) const
{
  const VectorXd forces = frame_.on_free_unknowns(force);
  BodyMismatch mismatch{0, 0, elastic_displacement(force)};
  BodyVector<double> displacement = stiffness_.make_vector(), image = displacement;
  entries(displacement, forces.size()) = mismatch.volume;
  stiffness_.vmult(image, displacement);
  double residual = 0;
  for (Index i = 0; i < forces.size(); ++i)
    residual += (image.local_element(i) - forces[i]) * (image.local_element(i) - forces[i]);
  residual = sum_over_ranks(residual);
  mismatch.unbalanced = residual == 0 ? 0 : std::sqrt(residual / sum_over_ranks(forces.squaredNorm()));
  mismatch.displacement = frame_.difference(elastic, mismatch.volume);
  return mismatch;
}
} // namespace

std::unique_ptr<const ElasticBody>
make_multigrid_body(const BodyOptions &options, const ModelSymmetry &symmetry, const double accuracy,
                    const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                    const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
{
  return std::make_unique<MultigridBody>(options, symmetry, accuracy, axes_of, on_meshed, seconds);
}

bool aggregates_coarsest(const double n_dofs, const double n_contact_nodes)
{
  constexpr double most_dofs = 1.5e5, most_contact_nodes = 1500;
  return n_dofs > most_dofs || n_contact_nodes > most_contact_nodes;
}
} // namespace orthocone
