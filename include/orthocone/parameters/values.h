// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Values as users write them: legs, probes, and the words of the enumerations. The words of the body's
// enumerations are beside these, in body_options.h. Nothing here throws.
#pragma once

#include <orthocone/parameters/options.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orthocone
{
template<>
struct Words<WearKind>
{
  static constexpr std::array<std::pair<WearKind, std::string_view>, 3> table{
      {{WearKind::none, "none"}, {WearKind::archard, "archard"}, {WearKind::energy, "energy"}}};
};

template<>
struct Words<DeepWear>
{
  static constexpr std::array<std::pair<DeepWear, std::string_view>, 2> table{
      {{DeepWear::implicitly, "implicit"}, {DeepWear::explicitly, "explicit"}}};
};

template<>
struct Words<ObstacleKind>
{
  static constexpr std::array<std::pair<ObstacleKind, std::string_view>, 3> table{
      {{ObstacleKind::rigid, "rigid"},
       {ObstacleKind::half_space, "half-space"},
       {ObstacleKind::body, "body"}}};
};

/// The word of an enumerator.
template<typename Enum>
std::string to_word(const Enum value)
{
  for (const auto &[enumerator, word] : Words<Enum>::table)
    if (enumerator == value)
      return std::string(word);
  return {};
}

/// The enumerator of a word, or nothing.
template<typename Enum>
std::optional<Enum> from_word(const std::string_view text)
{
  for (const auto &[enumerator, word] : Words<Enum>::table)
    if (word == text)
      return enumerator;
  return std::nullopt;
}

/// All words of an enumeration, separated by " | ".
template<typename Enum>
std::string all_words()
{
  std::string list;
  for (const auto &entry : Words<Enum>::table)
    list += (list.empty() ? "" : " | ") + std::string(entry.second);
  return list;
}

/// Reads "ux uy uz : steps ; NAME value ... : steps ; ...", possibly empty, in mm, degrees, N and N mm.
/// Returns nothing if this is malformed, if a leg has no steps, or if it names a component twice. Then
/// `allowed`, if given, becomes what is allowed instead.
std::optional<std::vector<Leg>> parse_legs(const std::string &text, std::string *allowed = nullptr);

/// The text that reads back as these legs.
std::string legs_text(const std::vector<Leg> &legs);

/// The form of legs, as messages describe it.
std::string allowed_legs();

/// Reads "name: x y ; ...", possibly empty, mm. Returns nothing if this is malformed. Names become file
/// names: they consist of letters, digits, '-' and '_', and each may occur once.
std::optional<std::vector<Probe>> parse_probes(const std::string &text);
} // namespace orthocone
