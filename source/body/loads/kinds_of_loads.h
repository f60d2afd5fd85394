// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The kinds of loads, each of which is defined in a file of its name.
#pragma once

#include <orthocone/body/loads/load.h>

namespace orthocone
{
const LoadKind &pressure_load();
const LoadKind &traction_load();
const LoadKind &motion_load();
const LoadKind &force_load();
const LoadKind &temperature_load();

inline std::vector<OtherUnit> units_of_stress()
{
  return {{"N/mm^2", 1}, {"GPa", 1e3}, {"kPa", 1e-3}, {"Pa", 1e-6}};
}

inline std::vector<OtherUnit> units_of_length()
{
  return {{"um", 1e-3}, {"\u00b5m", 1e-3}, {"\u03bcm", 1e-3}, {"nm", 1e-6}, {"m", 1e3}};
}
} // namespace orthocone
