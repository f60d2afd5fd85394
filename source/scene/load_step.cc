// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_step.h>

#include <algorithm>

namespace orthocone
{
bool FaceTarget::has_forces() const
{
  return std::find(by_force.begin(), by_force.end(), true) != by_force.end();
}

FaceTarget LoadStep::target(const FaceState &begin) const
{
  FaceTarget target{by_force, motion, force,
                    Eigen::Map<const Eigen::VectorXd>(loads.data(), static_cast<Eigen::Index>(loads.size()))};
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    if (from_present[i] && by_force[i])
      target.force[i] = begin.wrench[i] + share * (force[i] - begin.wrench[i]);
    else if (from_present[i])
      target.motion[i] = begin.motion[i] + share * (motion[i] - begin.motion[i]);
  return target;
}

LoadStep LoadStep::resolved(const FaceState &begin) const
{
  LoadStep step = *this;
  const FaceTarget end = target(begin);
  step.motion = end.motion;
  step.force = end.force;
  return step;
}

std::string LoadStep::driven(const ModelSymmetry &symmetry, const TopFace top_face) const
{
  constexpr unsigned int first_rotation = 3, normal = 2;
  const bool turns =
      std::any_of(motion.components.data() + first_rotation, motion.components.data() + n_rigid_components,
                  [](const double rotation) { return rotation != 0; });
  if (top_face == TopFace::free)
    return "none";
  std::string names;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
  {
    const bool is_named = i < first_rotation || turns || by_force[i];
    if (is_named && (i == normal || top_face == TopFace::clamped) &&
        (i < first_rotation || symmetry.leaves(i)))
      names += std::string(names.empty() ? "" : " ") + (by_force[i] ? wrench_names[i] : motion_names[i]);
  }
  return names;
}
} // namespace orthocone
