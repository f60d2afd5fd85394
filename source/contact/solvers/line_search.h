// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "linearization.h"

#include <utility>

namespace orthocone
{
/// linearize().
using Map = Linearization(const ContactStep &, const Eigen::VectorXd &, const NodeVector &, double);

/// Unknowns, their displacement, and a map there.
struct Iterate
{
  Iterate(Map *const map, const ContactStep &step, Eigen::VectorXd unknowns_, NodeVector displacement_,
          const double rho_factor)
      : unknowns(std::move(unknowns_)),
        displacement(std::move(displacement_)),
        linearization(map(step, unknowns, displacement, rho_factor))
  {
  }

  Eigen::VectorXd unknowns;
  NodeVector displacement;
  Linearization linearization;
};

/// The first of the iterates along `change`, each half as far as the one before, that reduces the map, or the
/// nearest one. Since W is linear, they cost no product with it.
Iterate line_search(Map *const map, const ContactStep &step, const Iterate &start,
                    const Eigen::VectorXd &change, const double smallest_step, const double rho_factor);
} // namespace orthocone
