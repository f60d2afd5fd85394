// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/peaks.h>

#include <cmath>

namespace orthocone
{
namespace
{
bool rises(Peaks::Peak &peak, const double value, const unsigned int step)
{
  constexpr double rounding = 1e-9; // a load that is held is largest when it is reached
  if (!(value > (1 + rounding) * peak.first))
    return false;
  peak = {value, step};
  return true;
}
} // namespace

void Peaks::consider(const unsigned int step, const Totals &totals)
{
  constexpr double least_share = 1e-3;
  ++n_steps;
  const double sideways = std::hypot(totals.force[0], totals.force[1]);
  rises(slip, totals.max_slip, step);
  rises(pressure, totals.max_pressure, step);
  rises(force_z, totals.force[2], step);
  rises(contact_area, totals.contact_area, step);
  if (rises(tangential_force, sideways, step))
  {
    sheared_contact = {totals.contact_area, step};
    sheared_stick = {totals.stick_area, step};
  }
  if (totals.force[2] > least_share * force_z.first)
    rises(friction, sideways / totals.force[2], step);
}

std::array<Peaks::Peak *, 8> Peaks::all()
{
  return {{&slip, &pressure, &force_z, &tangential_force, &friction, &contact_area, &sheared_contact,
           &sheared_stick}};
}
} // namespace orthocone
