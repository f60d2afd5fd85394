// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/elastic_body.h>

namespace orthocone
{
using Eigen::VectorXd;

VectorXd ElasticBody::driving(const RigidMotion &held, const VectorXd &loads) const
{
  VectorXd all = VectorXd::Zero(driven()->conjugates.rows());
  all.head<n_rigid_components>() = held.components;
  all.segment(n_rigid_components, loads.size()) = loads;
  return all;
}

NodeVector ElasticBody::moved_with(const RigidMotion &held, const VectorXd &loads) const
{
  NodeVector moved = frame().moved_with(held);
  if (const DrivenField *const field = driven())
    moved += field->contact * driving(held, loads);
  return moved;
}

Wrench ElasticBody::wrench(const NodeVector &force) const
{
  Wrench wrench = frame().wrench(force);
  if (const DrivenField *const field = driven())
    wrench.components += field->contact.leftCols<n_rigid_components>().transpose() * force;
  return wrench;
}

VectorXd ElasticBody::conjugates(const NodeVector &force, const RigidMotion &held,
                                 const VectorXd &loads) const
{
  const DrivenField *const field = driven();
  if (field == nullptr)
    return VectorXd::Zero(n_rigid_components) - wrench(force).components;
  VectorXd all = field->conjugates * driving(held, loads);
  all -= field->signs.cwiseProduct(field->contact.transpose() * force);
  all.head<n_rigid_components>() -= frame().wrench(force).components;
  return all;
}

double ElasticBody::driven_energy(const NodeVector &force, const RigidMotion &held,
                                  const VectorXd &loads) const
{
  const DrivenField *const field = driven();
  if (field == nullptr)
    return 0;
  const VectorXd driving = this->driving(held, loads);
  const VectorXd by_traction = 0.5 * (driving - field->signs.cwiseProduct(driving));
  return 0.5 * driving.dot(field->conjugates * driving) + force.dot(field->contact * by_traction);
}

VectorXd ElasticBody::with_motion(const RigidMotion &held, const VectorXd &elastic,
                                  const VectorXd &loads) const
{
  VectorXd displacement = with_rigid_motion(held, elastic);
  if (const DrivenField *const field = driven())
    displacement += field->volume * driving(held, loads);
  return displacement;
}
} // namespace orthocone
