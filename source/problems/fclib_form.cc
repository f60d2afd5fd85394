// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "fclib_form.h"

namespace orthocone
{
FclibScale::FclibScale(const std::vector<OrthotropicFriction> &laws)
    : force(Eigen::VectorXd::Ones(3 * static_cast<Eigen::Index>(laws.size()))),
      displacement(force),
      mu(laws.size())
{
  Eigen::Index node = 0;
  for (const OrthotropicFriction &law : laws)
  {
    const Eigen::Vector2d weights = slip_weights(normalized(law));
    const bool stays = is_frictionless(law) || (law.mu_x == law.mu_y && weights[0] == weights[1]);
    mu[node] = stays ? law.mu_x : 1;
    if (!stays)
    {
      force.segment<2>(3 * node + 1) << law.mu_x, law.mu_y;
      displacement.segment<2>(3 * node + 1) << law.mu_x * weights[0], law.mu_y * weights[1];
    }
    ++node;
  }
}
} // namespace orthocone
