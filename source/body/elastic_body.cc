// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/elastic_body.h>

namespace orthocone
{
using Eigen::VectorXd;

NodeVector ElasticBody::moved_with(const RigidMotion &held) const
{
  NodeVector moved = frame().moved_with(held);
  if (const DrivenField *const field = driven())
    moved += field->contact * held.components;
  return moved;
}

Wrench ElasticBody::wrench(const NodeVector &force) const
{
  Wrench wrench = frame().wrench(force);
  if (const DrivenField *const field = driven())
    wrench.components += field->contact.transpose() * force;
  return wrench;
}

Wrench ElasticBody::resistance(const RigidMotion &held) const
{
  Wrench wrench;
  if (const DrivenField *const field = driven())
    wrench.components = field->stiffness * held.components;
  return wrench;
}

VectorXd ElasticBody::with_motion(const RigidMotion &held, const VectorXd &elastic) const
{
  VectorXd displacement = with_rigid_motion(held, elastic);
  if (const DrivenField *const field = driven())
    displacement += field->volume * held.components;
  return displacement;
}
} // namespace orthocone
