// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/lame.h>

namespace orthocone
{
LameParameters::LameParameters(const MaterialOptions &material)
    : lambda(material.young_modulus * material.poisson_ratio /
             ((1 + material.poisson_ratio) * (1 - 2 * material.poisson_ratio))),
      mu(material.young_modulus / (2 * (1 + material.poisson_ratio)))
{
}
} // namespace orthocone
