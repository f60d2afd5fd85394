// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/loads/load.h>

#include "../names_of_groups.h"
#include "kinds_of_loads.h"

#include <orthocone/base/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace orthocone
{
std::vector<const LoadKind *> &load_kinds()
{
  static std::vector<const LoadKind *> kinds{&pressure_load(), &traction_load(),    &motion_load(),
                                             &force_load(),    &temperature_load(), &interference_load()};
  return kinds;
}

namespace
{
using Eigen::Vector3d;

std::string words_of_kinds()
{
  std::string all;
  for (const LoadKind *const kind : load_kinds())
    all += (all.empty() ? "" : ", ") + std::string(kind->word());
  return all;
}

const LoadKind *find_kind(const std::string &word)
{
  const auto &kinds = load_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const LoadKind *kind) { return kind->word() == word; });
  return found == kinds.end() ? nullptr : *found;
}

/// Whether a name can be a word of a leg and of the header of a table, where a '_' joins it with a suffix.
bool is_load_name(const std::string &name)
{
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 && !parse_number(name) &&
         std::all_of(name.begin(), name.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '-'; });
}

/// Reads "x", "-y" or three numbers as a direction of length 1.
std::optional<Vector3d> parse_direction(const std::string &text)
{
  const bool is_reversed = text.size() == 2 && text[0] == '-';
  const std::size_t axis = std::string("xyz").find(is_reversed ? text.substr(1) : text);
  if (!text.empty() && text.size() <= 2 && axis < 3)
    return Vector3d((is_reversed ? -1. : 1.) * Vector3d::Unit(static_cast<Eigen::Index>(axis)));
  const auto numbers = parse_numbers(text, 3, ',');
  if (!numbers)
    return std::nullopt;
  const Vector3d direction((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  if (!(direction.norm() > 0) || !std::isfinite(direction.norm()))
    return std::nullopt;
  return direction.normalized();
}

/// Reads the names of surfaces, or none, with "lower" in front of those of the second body.
bool parse_surfaces(const std::string &text, Load &load)
{
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (word == "lower" && load.surfaces.empty() && !load.is_on_lower)
      load.is_on_lower = true;
    else if (std::find(load.surfaces.begin(), load.surfaces.end(), word) != load.surfaces.end() ||
             !is_group_name(word))
      return false;
    else
      load.surfaces.push_back(word);
  return true;
}

std::string direction_text(const Vector3d &direction)
{
  if (const unsigned int axis = axis_of(direction); axis < 3)
    return std::string(direction[axis] < 0 ? "-" : "") + "xyz"[axis];
  return to_text(direction[0]) + ", " + to_text(direction[1]) + ", " + to_text(direction[2]);
}

/// What a load of this kind lacks, or has too much; "" if it is complete.
std::string fault_of_form(const Load &load, const bool has_direction)
{
  const std::string kind(load.kind->word());
  if (load.kind->has_surface() == load.surfaces.empty())
    return load.kind->has_surface() ? "'" + kind + " on SURFACE'"
                                    : "'" + kind + "' without a surface" +
                                          (load.kind->drives_overlap() ? "" : ", or '" + kind + " on lower'");
  if (load.kind->has_direction() != has_direction)
    return load.kind->has_direction() ? "'" + kind + " on SURFACE along x', with x, y, z or three numbers"
                                      : "'" + kind + "' without 'along'";
  if (load.kind->moves_surface() && axis_of(load.direction) == 3)
    return "'" + kind + " on SURFACE along x', y or z";
  return {};
}
} // namespace

unsigned int axis_of(const Vector3d &direction)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) == 1)
      return axis;
  return 3;
}

std::string Load::text() const
{
  std::string text = name + ": " + std::string(kind->word());
  if (is_on_lower || !surfaces.empty())
    text += std::string(" on") + (is_on_lower ? " lower" : "");
  for (const std::string &surface : surfaces)
    text += " " + surface;
  return kind->has_direction() ? text + " along " + direction_text(direction) : text;
}

std::string parse_load(const std::string &text, Load &load)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    return allowed_loads();
  load.name = trimmed(text.substr(0, colon));
  if (!is_load_name(load.name))
    return "a name of letters, digits and '-' before ':', which begins with a letter";
  std::string what = trimmed(text.substr(colon + 1));
  const std::size_t along = (what + " ").find(" along ");
  std::optional<Vector3d> direction;
  if (along != std::string::npos)
  {
    direction = parse_direction(trimmed(what.substr(std::min(along + 7, what.size()))));
    if (!direction)
      return "'along' with x, y, z, -x, -y, -z, or with three numbers 'a, b, c' that are not all 0";
    load.direction = *direction;
    what = trimmed(what.substr(0, along));
  }
  const std::size_t on = what.find(" on ");
  const std::string word = trimmed(what.substr(0, on));
  load.kind = find_kind(word);
  if (load.kind == nullptr)
    return "a kind of load behind the name, of " + words_of_kinds();
  if (on != std::string::npos && !parse_surfaces(what.substr(on + 4), load))
    return "surfaces behind 'on', each once, with 'lower' in front of those of the second body";
  return fault_of_form(load, direction.has_value());
}

Strain free_strain(const std::vector<Load> &loads, const Eigen::VectorXd &values, const bool is_lower,
                   const MaterialOptions &material)
{
  Strain strain;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (loads[k].is_on_lower == is_lower)
      strain += values[static_cast<Eigen::Index>(k)] * loads[k].kind->free_strain(material);
  return strain;
}

std::string allowed_loads()
{
  return "nothing, or loads \"NAME: KIND on SURFACE\" or \"NAME: KIND on SURFACE along x\", separated by "
         "';', where KIND is one of " +
         words_of_kinds();
}

std::string help_of_load_kinds()
{
  std::string all;
  for (const LoadKind *const kind : load_kinds())
    all += (all.empty() ? "" : "; ") + std::string(kind->word()) + " " + std::string(kind->help());
  return all;
}
} // namespace orthocone
