// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone
{
/// Lame's parameters in MPa.
struct LameParameters
{
  /// lambda = E nu / ((1 + nu) (1 - 2 nu)), mu = E / (2 (1 + nu)), of the isotropic constants.
  explicit LameParameters(const MaterialOptions &material)
      : lambda(material.young_modulus * material.poisson_ratio /
               ((1 + material.poisson_ratio) * (1 - 2 * material.poisson_ratio))),
        mu(material.young_modulus / (2 * (1 + material.poisson_ratio)))
  {
  }

  double lambda;
  double mu;
};
} // namespace orthocone
