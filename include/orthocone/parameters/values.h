// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Values as users write them: legs, probes, and the words of the enumerations. Every accepted word stands in
// one table here.
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
/// Table of the words of an enumeration; specialised for each of them.
template<typename Enum>
struct Words;

template<>
struct Words<BodyShape>
{
  static constexpr std::array<std::pair<BodyShape, std::string_view>, 3> table{
      {{BodyShape::cylinder, "cylinder"}, {BodyShape::box, "box"}, {BodyShape::file, "file"}}};
};

template<>
struct Words<MaterialLaw>
{
  static constexpr std::array<std::pair<MaterialLaw, std::string_view>, 2> table{
      {{MaterialLaw::isotropic, "isotropic"}, {MaterialLaw::orthotropic, "orthotropic"}}};
};

template<>
struct Words<TopFace>
{
  static constexpr std::array<std::pair<TopFace, std::string_view>, 2> table{
      {{TopFace::clamped, "clamped"}, {TopFace::guided, "guided"}}};
};

template<>
struct Words<ModelKind>
{
  static constexpr std::array<std::pair<ModelKind, std::string_view>, 5> table{
      {{ModelKind::automatic, "auto"},
       {ModelKind::full, "full"},
       {ModelKind::half, "half"},
       {ModelKind::quarter, "quarter"},
       {ModelKind::axisymmetric, "axisymmetric"}}};
};

template<>
struct Words<MeshResolution>
{
  static constexpr std::array<std::pair<MeshResolution, std::string_view>, 5> table{
      {{MeshResolution::custom, "custom"},
       {MeshResolution::paper, "paper"},
       {MeshResolution::coarse, "coarse"},
       {MeshResolution::medium, "medium"},
       {MeshResolution::fine, "fine"}}};
};

template<>
struct Words<VolumetricQuadrature>
{
  static constexpr std::array<std::pair<VolumetricQuadrature, std::string_view>, 2> table{
      {{VolumetricQuadrature::full, "full"}, {VolumetricQuadrature::reduced, "reduced"}}};
};

template<>
struct Words<WearKind>
{
  static constexpr std::array<std::pair<WearKind, std::string_view>, 3> table{
      {{WearKind::none, "none"}, {WearKind::archard, "archard"}, {WearKind::energy, "energy"}}};
};

template<>
struct Words<ObstacleKind>
{
  static constexpr std::array<std::pair<ObstacleKind, std::string_view>, 3> table{
      {{ObstacleKind::rigid, "rigid"},
       {ObstacleKind::half_space, "half-space"},
       {ObstacleKind::body, "body"}}};
};

template<>
struct Words<BodyBackend>
{
  static constexpr std::array<std::pair<BodyBackend, std::string_view>, 3> table{
      {{BodyBackend::automatic, "auto"},
       {BodyBackend::condensed, "condensed"},
       {BodyBackend::multigrid, "multigrid"}}};
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

/// "ux uy uz : steps ; NAME value ... : steps ; ...", possibly empty; nothing if malformed, if a leg has no
/// steps or names a component twice. Then `allowed`, if given, is what is allowed instead.
std::optional<std::vector<Leg>> parse_legs(const std::string &text, std::string *allowed = nullptr);

/// What reads back as these legs.
std::string legs_text(const std::vector<Leg> &legs);

/// What users are told of legs in general.
std::string allowed_legs();

/// "name: x y ; ...", possibly empty; nothing if malformed. Names become file names: letters, digits, '-',
/// '_', each used once.
std::optional<std::vector<Probe>> parse_probes(const std::string &text);
} // namespace orthocone
