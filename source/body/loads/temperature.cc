// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "kinds_of_loads.h"

#include <orthocone/body/options.h>

namespace orthocone
{
namespace
{
/// The temperature of a whole body above that at which it is free of stress: a strain alpha T in all
/// directions. Its conjugate is minus the stress that hinders this strain, times alpha, over the volume.
class Temperature : public LoadKind
{
public:
  std::string_view word() const override { return "temperature"; }
  std::string_view help() const override
  {
    return "heats the whole body, K, so that it has no surface, and needs Material/Thermal expansion";
  }
  const char *unit() const override { return "K"; }
  Conjugate conjugate() const override
  {
    return {"Q", "N mm/K", "derivative of the elastic energy by the temperature"};
  }
  bool has_surface() const override { return false; }
  bool has_direction() const override { return false; }
  Strain free_strain(const MaterialOptions &material) const override
  {
    return material.thermal_expansion * dealii::unit_symmetric_tensor<3>();
  }
  std::string lacking_entry(const MaterialOptions &material) const override
  {
    return material.thermal_expansion == 0 ? material.section + "/Thermal expansion" : "";
  }
};
} // namespace

const LoadKind &temperature_load()
{
  static const Temperature kind;
  return kind;
}
} // namespace orthocone
