// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/backends/half_space_body.h>

#include <orthocone/surface/turned_compliance.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
HalfSpace half_space_of(const MaterialOptions &material)
{
  return {material.young_modulus, material.poisson_ratio};
}

Index most_loaded_node(const NodeVector &force)
{
  Index most = 0;
  for (Index node = 1; 3 * node < force.size(); ++node)
    if (force.segment<3>(3 * node).squaredNorm() > force.segment<3>(3 * most).squaredNorm())
      most = node;
  return most;
}
} // namespace

HalfSpaceBody::HalfSpaceBody(const BodyOptions &options,
                             const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                             const std::function<void(const Body &)> &on_meshed, PhaseSeconds &seconds)
    : grid_(surface_grid(options.geometry, options.mesh)),
      material_(half_space_of(options.material)),
      body_(timed(seconds.mesh, [&] { return Body(options, {}); })),
      axes_(axes_of(body_.unknowns().contact_surface()))
{
  on_meshed(body_);
  frame_ = std::make_unique<const ContactFrame>(body_.unknowns(), axes_);
  compliance_ = timed(seconds.condensation, [&] { return make_compliance(std::nullopt); });
}

/// In the axes of the grid where the nodes have these, which is what most scenes need.
std::unique_ptr<const Compliance>
HalfSpaceBody::make_compliance(const std::optional<HalfSpace> &counterface) const
{
  auto plain = std::make_unique<const GridHalfSpace>(grid_, material_, counterface);
  if (axes_.is_uniform() && axes_.global_in_local(0) == axes_about_z(0))
    return plain;
  return std::make_unique<const TurnedCompliance>(std::move(plain), axes_);
}

std::unique_ptr<const Compliance> HalfSpaceBody::compliance_on(const MaterialOptions &counterface) const
{
  return make_compliance(half_space_of(counterface));
}

VectorXd HalfSpaceBody::elastic_displacement(const NodeVector &force) const
{
  NodeVector local;
  compliance_->vmult(local, force);
  VectorXd displacement(local.size());
  for (Index node = 0; 3 * node < local.size(); ++node)
    displacement.segment<3>(3 * node) =
        axes_.global_in_local(static_cast<std::size_t>(node)) * local.segment<3>(3 * node);
  return displacement;
}

/// Bilinear between the middles of the coarser patches, and a quarter of the force, because a patch has a
/// quarter of the area: each middle has the weight 3/4 along an axis for the patch that it lies next to.
NodeVector HalfSpaceBody::prolonged_forces(const VectorXd &coarser) const
{
  const Index n_x = grid_.n_x / 2, n_y = grid_.n_y / 2;
  const auto neighbour = [](const Index i, const Index n)
  { return std::clamp<Index>(i / 2 + (i % 2 == 0 ? -1 : 1), 0, n - 1); };
  NodeVector force(3 * grid_.n_nodes());
  for (Index node = 0; node < grid_.n_nodes(); ++node)
  {
    const Index i = node % grid_.n_x, j = node / grid_.n_x;
    const auto at = [&](const Index x, const Index y) { return coarser.segment<3>(3 * (y * n_x + x)); };
    const auto along_x = [&](const Index y) -> Vector3d
    { return 0.75 * at(i / 2, y) + 0.25 * at(neighbour(i, n_x), y); };
    const Vector3d mean = 0.75 * along_x(j / 2) + 0.25 * along_x(neighbour(j, n_y));
    force.segment<3>(3 * node) = axes_.global_in_local(static_cast<std::size_t>(node)).transpose() * mean / 4;
  }
  return force;
}

BodyMismatch HalfSpaceBody::mismatch(const NodeVector &force, const NodeVector &elastic, double) const
{
  BodyMismatch mismatch{0, 0, elastic_displacement(force)};
  mismatch.displacement = frame_->difference(elastic, mismatch.volume);
  if (force.isZero(0))
    return mismatch;
  const Index node = most_loaded_node(force);
  const Vector3d by_sum =
      axes_.global_in_local(static_cast<std::size_t>(node)) * compliance_->displacement_at(node, force);
  mismatch.unbalanced = (mismatch.volume.segment<3>(3 * node) - by_sum).norm() / by_sum.norm();
  return mismatch;
}
} // namespace orthocone
