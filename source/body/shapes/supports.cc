// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/supports.h>

#include "../names_of_groups.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr std::array<const char *, 3> direction_names{{"x", "y", "z"}};

/// Reads "x z", or nothing.
std::optional<std::array<bool, 3>> parse_directions(const std::string &text)
{
  std::array<bool, 3> directions{};
  std::istringstream words(text);
  bool is_any = false;
  for (std::string word; words >> word; is_any = true)
  {
    const auto found = std::find(direction_names.begin(), direction_names.end(), word);
    if (found == direction_names.end() || directions[found - direction_names.begin()])
      return std::nullopt;
    directions[found - direction_names.begin()] = true;
  }
  return is_any ? std::optional(directions) : std::nullopt;
}

std::optional<Support> parse_support(const std::string &text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    return std::nullopt;
  const std::string surface = trimmed(text.substr(0, colon));
  const auto directions = parse_directions(text.substr(colon + 1));
  if (surface.empty() || !is_group_name(surface) || !directions)
    return std::nullopt;
  return Support{surface, *directions};
}

std::string support_text(const Support &support)
{
  std::string text = support.surface + ":";
  for (unsigned int d = 0; d < 3; ++d)
    text += support.directions[d] ? std::string(" ") + direction_names[d] : "";
  return text;
}

std::string entry_with(const GeometryOptions &geometry, const Support &support)
{
  return geometry.section + "/Supports = " + support_text(support);
}

std::string enumerated(const std::vector<std::string> &names)
{
  std::string all;
  for (const std::string &name : names)
    all += (all.empty() ? "" : ", ") + name;
  return all;
}
} // namespace

void declare_supports(GeometryOptions &geometry, Section &section)
{
  section
      .add(
          "Supports", geometry.supports,
          list_codec<Support>("nothing, or surfaces with their directions, such as 'x+: x ; side: x y z'",
                              ';', " ; ", parse_support, support_text),
          "Surfaces that are held at zero in some of x, y, z, beside the held face: 'x-: x' is a roller. "
          "Surfaces are base, top, side of a cylinder, base, top, x-, x+, y-, y+ of a box (x- and x+ beside "
          "base and top in plane strain), and those of a file by names or places. Supports do not follow the "
          "held face; where both have a node, the held face moves it.")
      .also_called({"boundary conditions", "rollers", "fixed"});
}

HeldSurfaces held_surfaces(const GeometryOptions &geometry)
{
  HeldSurfaces held(geometry.top_face);
  for (std::size_t i = 0; i < geometry.supports.size(); ++i)
  {
    const bool is_top = !geometry.is_from_file() && geometry.supports[i].surface == "top";
    held.supports.push_back({is_top ? dealii::types::boundary_id(Boundary::top_face)
                                    : static_cast<dealii::types::boundary_id>(Boundary::first_support + i),
                             geometry.supports[i].directions});
  }
  return held;
}

dealii::types::boundary_id boundary_of_surface(const GeometryOptions &geometry, const std::string &surface,
                                               const Boundary otherwise)
{
  for (std::size_t i = 0; i < geometry.supports.size(); ++i)
    if (geometry.supports[i].surface == surface)
      return static_cast<dealii::types::boundary_id>(Boundary::first_support + i);
  return otherwise;
}

std::string mirrored_surface(const std::string &surface, const unsigned int plane)
{
  const char axis = "xy"[plane];
  if (surface.size() != 2 || surface[0] != axis)
    return surface;
  return std::string(1, axis) + (surface[1] == '-' ? "+" : "-");
}

std::string asymmetry_of_supports(const GeometryOptions &geometry, const ModelSymmetry &symmetry)
{
  if (geometry.is_from_file())
    return {};
  const SymmetryPlanes &planes = symmetry.planes();
  for (const Support &support : geometry.supports)
  {
    if (symmetry.is_axisymmetric() && support.directions[0] != support.directions[1])
      return entry_with(geometry, support) + " is not the same all around";
    for (unsigned int plane = 0; plane < 2; ++plane)
    {
      if (!(plane == 0 ? planes.normal_to_x : planes.normal_to_y))
        continue;
      const std::string image = mirrored_surface(support.surface, plane);
      if (std::none_of(geometry.supports.begin(), geometry.supports.end(),
                       [&](const Support &other)
                       { return other.surface == image && other.directions == support.directions; }))
        return entry_with(geometry, support) + " has no mirror image on " + image;
    }
  }
  return {};
}

void check_supports(const GeometryOptions &geometry, const std::vector<std::string> &surfaces)
{
  const std::vector<Support> &supports = geometry.supports;
  for (auto support = supports.begin(); support != supports.end(); ++support)
  {
    const auto is_same = [&](const Support &other) { return other.surface == support->surface; };
    if (std::any_of(supports.begin(), support, is_same))
      throw InputError(geometry.section + "/Supports names " + shown(support->surface) +
                       " twice: allowed is once, with all its directions");
    if (geometry.is_from_file())
      continue;
    if (surfaces.empty())
      throw InputError(entry_with(geometry, *support) + " with " + geometry.shape_entry() +
                       ", whose surfaces have no names: allowed is nothing");
    const std::vector<std::string> allowed(surfaces.begin() + 1, surfaces.end());
    if (std::find(allowed.begin(), allowed.end(), support->surface) == allowed.end())
      throw InputError(entry_with(geometry, *support) +
                       (support->surface == surfaces.front()
                            ? " is the contact surface, which only the counterface may hold: allowed are "
                            : " names no surface of " + geometry.shape_entry() +
                                  (geometry.is_plane_strain() ? " in plane strain" : "") + ": allowed are ") +
                       enumerated(allowed));
  }
}
} // namespace orthocone
