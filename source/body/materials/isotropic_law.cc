// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material_law.h>

namespace orthocone
{
namespace
{
/// It has no entries of its own: every law needs two isotropic constants, if only for the regions of a mesh.
class IsotropicLaw : public MaterialLaw
{
public:
  std::unique_ptr<MaterialLaw> clone() const override { return std::make_unique<IsotropicLaw>(); }
  std::optional<ElasticTangent> tangent() const override { return {}; }
  void check(const MaterialOptions &) const override {} // each entry has its own range
};
} // namespace

Kind<MaterialLaw> isotropic_law()
{
  return {"isotropic", "with the two constants above", [] { return std::make_unique<IsotropicLaw>(); }};
}
} // namespace orthocone
