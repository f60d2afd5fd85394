// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/wear_kind.h>

namespace orthocone
{
namespace
{
/// In proportion to pressure times slip (Archard, J. Appl. Phys. 24, 1953, 981).
class ArchardWear : public WearKindOptions
{
public:
  std::unique_ptr<WearKindOptions> clone() const override { return std::make_unique<ArchardWear>(); }
  double volume(const double coefficient, const Rubbing &rubbing) const override
  {
    return coefficient * rubbing.normal_force * rubbing.slip;
  }
};
} // namespace

Kind<WearKindOptions> archard_wear()
{
  return {"archard", "Coefficient x pressure x slip", [] { return std::make_unique<ArchardWear>(); }};
}
} // namespace orthocone
