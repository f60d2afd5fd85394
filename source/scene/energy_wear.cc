// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/wear_kind.h>

namespace orthocone
{
namespace
{
/// In proportion to dissipated energy per area (Fouvry et al., Wear 255, 2003, 287).
class EnergyWear : public WearKindOptions
{
public:
  std::unique_ptr<WearKindOptions> clone() const override { return std::make_unique<EnergyWear>(); }
  double volume(const double coefficient, const Rubbing &rubbing) const override
  {
    return coefficient * rubbing.dissipated;
  }
};
} // namespace

Kind<WearKindOptions> energy_wear()
{
  return {"energy", "Coefficient x dissipated energy per area",
          [] { return std::make_unique<EnergyWear>(); }};
}
} // namespace orthocone
