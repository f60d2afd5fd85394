// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/driven_work.h>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

double driven_work(const Scene &scene, const ContactState &before, const ContactState &after)
{
  const FaceState first = scene.face_state(before.force, before.motion, before.loads),
                  last = scene.face_state(after.force, after.motion, after.loads);
  const RigidMotion increment{after.motion.components - before.motion.components};
  double work = 0.5 * (first.wrench.work(increment) + last.wrench.work(increment));
  if (scene.n_loads() == 0)
    return work;
  const VectorXd y_first = scene.load_conjugates(before.force, before.motion, before.loads),
                 y_last = scene.load_conjugates(after.force, after.motion, after.loads);
  for (Index k = 0; k < scene.n_loads(); ++k)
  {
    const bool by_traction =
        scene.parameters().load.loads[static_cast<std::size_t>(k)].kind->acts_by_traction();
    work += by_traction ? 0.5 * (before.loads[k] + after.loads[k]) * (y_last[k] - y_first[k])
                        : 0.5 * (y_first[k] + y_last[k]) * (after.loads[k] - before.loads[k]);
  }
  return work;
}
} // namespace orthocone
