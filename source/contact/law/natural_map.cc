// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/natural_map.h>

namespace orthocone
{
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d TrialForce::admitted(const FrictionLaw &law) const
{
  if (is_open())
    return Vector3d::Zero();
  const Vector2d tangential = law.force(length <= normal ? reduced : Vector2d(normal * (reduced / length)));
  return {normal, tangential[0], tangential[1]};
}

Vector3d admissible_force(const FrictionLaw &law, const Vector3d &force)
{
  const TrialForce trial(law, 0, force, Vector3d::Zero());
  return trial.sticks() ? force : trial.admitted(law);
}
} // namespace orthocone
