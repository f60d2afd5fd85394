// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Legs, probes and lines as users write them. Nothing here throws.
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
inline const std::vector<Load> no_loads{};

/// "ux uy uz : steps ; NAME value ... : steps ; ...", possibly empty, in mm, degrees, N and N mm, and the
/// units of the loads, or with another unit behind the value of a name. Each leg has at least one step, and
/// names a component or a load once. `loads` must outlive the codec; they are read before legs.
Codec<std::vector<Leg>> legs_codec(const std::vector<Load> &loads = no_loads);

/// Loads, each name once, and none that legs have for something else.
Codec<std::vector<Load>> loads_codec();

/// The program's unit of the component or load of this name.
std::string unit_of(const std::string &name, const std::vector<Load> &loads);

/// Sets the target of the component of this name, mm, degrees, N or N mm, or of a load. Returns what is
/// allowed instead of the name, or "".
std::string set_target(const std::string &name, double value, const std::vector<Load> &loads, Leg &leg);

/// "name: x y ; ...", possibly empty, mm. Names become file names: they consist of letters, digits, '-' and
/// '_', and each may occur once.
Codec<std::vector<Probe>> probes_codec();

/// "name: x y z to x y z, points ; ...", possibly empty, mm, with names as those of probes.
Codec<std::vector<Line>> lines_codec();
} // namespace orthocone
