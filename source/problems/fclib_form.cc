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
    const Eigen::Vector2d weights = slip_weights(normalized(law)), axes = law.mu();
    const bool stays = is_frictionless(law) || (axes[0] == axes[1] && weights[0] == weights[1]);
    mu[node] = stays ? axes[0] : 1;
    if (!stays)
    {
      force.segment<2>(3 * node + 1) = axes;
      displacement.segment<2>(3 * node + 1) = axes.cwiseProduct(weights);
    }
    ++node;
  }
}
} // namespace orthocone
