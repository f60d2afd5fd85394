// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "fatigue_constants.h"

#include <orthocone/base/errors.h>

#include <algorithm>
#include <array>

namespace orthocone
{
namespace
{
struct KnownConstant
{
  const char *name;
  bool may_vanish;
};

/// Those of tools/fatigues/material.py, which has their meaning and their defaults.
constexpr std::array<KnownConstant, 7> known{{{"bending limit", false},
                                              {"torsion limit", false},
                                              {"yield stress", false},
                                              {"fatemi socie k", true},
                                              {"findley k", true},
                                              {"crossland alpha", true},
                                              {"dang van a", true}}};

std::optional<FatigueConstant> parse_constant(const std::string &text)
{
  const auto parts = split(text, ':');
  if (parts.size() != 2)
    return std::nullopt;
  const auto *const found = std::find_if(
      known.begin(), known.end(), [&](const KnownConstant &constant) { return parts[0] == constant.name; });
  const auto value = parse_numbers(parts[1], 1, ',');
  if (found == known.end() || !value || value->front() < 0 || (value->front() == 0 && !found->may_vanish))
    return std::nullopt;
  return FatigueConstant{parts[0], value->front()};
}

Codec<std::vector<FatigueConstant>> fatigue_codec()
{
  std::string names;
  for (const KnownConstant &constant : known)
    names += (names.empty() ? "" : ", ") + std::string(constant.name);
  const auto is_new = [](const std::vector<FatigueConstant> &before, const FatigueConstant &constant)
  {
    return std::none_of(before.begin(), before.end(),
                        [&](const FatigueConstant &other) { return other.name == constant.name; });
  };
  const auto print = [](const FatigueConstant &constant)
  { return constant.name + ": " + to_text(constant.value); };
  return list_codec<FatigueConstant>(
      "nothing, or constants \"name: number\" separated by ';', each name once, with "
      "the names " +
          names + "; a limit or a yield stress > 0 (MPa), the others >= 0",
      ';', " ; ", parse_constant, print, is_new);
}

std::optional<double> given(const MaterialOptions &material, const std::string &name)
{
  for (const FatigueConstant &constant : material.fatigue)
    if (constant.name == name)
      return constant.value;
  return std::nullopt;
}
} // namespace

void declare_fatigue(MaterialOptions &material, Section &section)
{
  section.add(
      "Fatigue", material.fatigue, fatigue_codec(),
      "Constants of fatigue of the material, which tools/fatigue takes from the run folder: the limits of "
      "reversed bending and torsion, the yield stress and others, as in 'bending limit: 420 ; torsion limit: "
      "250 ; yield stress: 550'. The run itself does not depend on them.");
}

/// The last three constants follow from the ratio of both limits (docs/fatigue.md, "Constants").
void check_fatigue(const MaterialOptions &material)
{
  const auto bending = given(material, "bending limit"), torsion = given(material, "torsion limit");
  const std::string entry = material.section + "/Fatigue",
                    otherwise = ", or all of findley k, crossland alpha and dang van a";
  if (given(material, "findley k") && given(material, "crossland alpha") && given(material, "dang van a"))
    return;
  if (bending.has_value() != torsion.has_value())
    throw InputError(
        entry +
        " has one of bending limit and torsion limit: allowed are both or neither, because other "
        "constants follow from their ratio" +
        otherwise);
  constexpr double least = 0.5; // Tresca's
  if (bending && (*torsion < least * *bending || *torsion >= *bending))
    throw InputError(entry + " has a torsion limit that is " + to_text(*torsion / *bending) +
                     " of the bending limit: allowed are 0.5 up to 1" + otherwise);
}
} // namespace orthocone
