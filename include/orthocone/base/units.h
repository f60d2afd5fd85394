// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Units that users may write behind a number, and what they are in those of the program (mm, N, MPa, degrees,
// N mm, s, K). Nothing here throws.
#pragma once

#include <optional>
#include <string>

namespace orthocone
{
/// The number of the program's unit `unit` that is `value` of the unit `given`; nothing where `given`
/// measures something else, or is no unit. Each unit is its own.
std::optional<double> in_unit(const std::string &unit, double value, const std::string &given);

/// Whether other units than `unit` itself are known for it.
bool has_other_units(const std::string &unit);

/// `unit` and its others: "mm, um, nm, cm, m".
std::string units_like(const std::string &unit);

/// What `word` measures: "length"; "" where it is no unit.
std::string quantity_of_unit(const std::string &word);

/// The number of a text such as "10 um" in the program's unit; a bare number is in it already. Nothing for
/// any other text.
std::optional<double> parse_quantity(const std::string &text, const std::string &unit);

/// A list of numbers, separated by ',', as the program's unit has it: "2 cm, 5" becomes "20, 5". Pieces that
/// are no number with a unit of this kind stay as they are.
std::string without_units(const std::string &text, const std::string &unit);

/// What is wrong with the units of such a text, where the program's unit is `unit` ("" for pure numbers):
/// "; N is a unit of force". "" if it has none that is known.
std::string fault_of_units(const std::string &text, const std::string &unit);
} // namespace orthocone
