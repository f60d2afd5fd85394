// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/contact_material.h>

namespace orthocone
{
namespace
{
/// Material on a rigid plane with the compliances in plane strain, (1 - nu^2)/E, and in antiplane shear,
/// (1 + nu)/E, of both bodies together.
MaterialOptions as_one(const MaterialOptions &a, const MaterialOptions &b)
{
  const auto antiplane = [](const MaterialOptions &of) { return (1 + of.poisson_ratio) / of.young_modulus; };
  const double both = antiplane(a) + antiplane(b);
  MaterialOptions material;
  material.poisson_ratio = (a.poisson_ratio * antiplane(a) + b.poisson_ratio * antiplane(b)) / both;
  material.young_modulus = (1 + material.poisson_ratio) / both;
  return material;
}
} // namespace

MaterialOptions contact_material(const Parameters &parameters)
{
  const auto &kind = parameters.obstacle.kind;
  const MaterialOptions body = parameters.material.isotropic();
  if (kind.chosen().is_body())
    return as_one(body, parameters.lower.material.isotropic());
  const auto below = kind.chosen().material();
  return below ? as_one(body, *below) : body;
}
} // namespace orthocone
