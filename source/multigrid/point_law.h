// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Hooke's law at a point of each of several cells, one in each lane.
#pragma once

#include "cell_products.h"

#include <orthocone/base/every_processor.h>

namespace orthocone
{
/// Derivatives of three components by three coordinates at one point.
template<typename Number>
struct PointGradient
{
  typename Lanes<Number>::Values of[3][3];

  ORTHOCONE_INLINE typename Lanes<Number>::Values trace() const { return of[0][0] + of[1][1] + of[2][2]; }
};

/// Derivatives by the unit cell's coordinates become those by x, y and z.
template<typename Number>
ORTHOCONE_INLINE PointGradient<Number> in_space(const Lanes<Number> *geometry, const Lanes<Number> *gradient,
                                                const unsigned int step)
{
  PointGradient<Number> result;
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int e = 0; e < 3; ++e)
      result.of[c][e] = gradient[3 * c * step].values * geometry[e].values +
                        gradient[(3 * c + 1) * step].values * geometry[3 + e].values +
                        gradient[(3 * c + 2) * step].values * geometry[6 + e].values;
  return result;
}

/// The principle of virtual work at the point: sigma : grad(v) weight = g : grad_unit(v) for every v, so that
/// g = sigma J^-T weight with the Jacobian J of the cell. The stress is symmetric, which is not made use of:
/// nine products in a register are cheaper than six that have to be put into place. Writes the forces on the
/// derivatives by the unit cell's coordinates. `pressure` is the volumetric stress times the weight of the
/// point.
template<typename Number>
ORTHOCONE_INLINE void
apply_law(const Number mu, const Lanes<Number> *geometry, const PointGradient<Number> &strain,
          const typename Lanes<Number>::Values pressure, Lanes<Number> *gradient, const unsigned int step)
{
  typename Lanes<Number>::Values stress[3][3];
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int e = 0; e < 3; ++e)
      stress[c][e] = mu * geometry[9].values * (strain.of[c][e] + strain.of[e][c]);
  for (unsigned int c = 0; c < 3; ++c)
    stress[c][c] += pressure;
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      gradient[(3 * c + d) * step].values = stress[c][0] * geometry[3 * d].values +
                                            stress[c][1] * geometry[3 * d + 1].values +
                                            stress[c][2] * geometry[3 * d + 2].values;
}
} // namespace orthocone
