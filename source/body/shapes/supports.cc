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
      .add("Supports", geometry.supports,
           list_codec<Support>("nothing, or surfaces with their directions, such as 'x+: x ; side: x y z'",
                               ';', " ; ", parse_support, support_text),
           "Surfaces whose displacement along x, y or z is zero, beside the held face; 'x-: x' is a roller. "
           "A cylinder offers top and side, a box top, x-, x+, y- and y+ (in plane strain top, x- and x+), "
           "and a file its surfaces by names or places. Supports do not follow the held face, and a node "
           "that belongs to both moves with the held face.")
      .also_called({"boundary conditions", "rollers", "fixed"});
}

std::vector<std::string> marked_surfaces(const GeometryOptions &geometry)
{
  std::vector<std::string> names;
  const auto add = [&](const std::string &name)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const Support &support : geometry.supports)
    add(support.surface);
  for (const Load &load : geometry.loads)
    if (geometry.has(load))
      std::for_each(load.surfaces.begin(), load.surfaces.end(), add);
  return names;
}

dealii::types::boundary_id boundary_of_marked(const GeometryOptions &geometry, const std::string &surface)
{
  const bool is_top = !geometry.is_from_file() && surface == "top";
  return is_top ? dealii::types::boundary_id(Boundary::top_face)
                : boundary_of_surface(geometry, surface, Boundary::lateral_surface);
}

HeldSurfaces held_surfaces(const GeometryOptions &geometry)
{
  HeldSurfaces held(geometry.top_face);
  held.contact_faces_down = geometry.faces_down;
  held.has_datum = geometry.top_face == TopFace::free && !geometry.is_lower;
  for (const Support &support : geometry.supports)
    held.supports.push_back({boundary_of_marked(geometry, support.surface), support.directions});
  for (const Load &load : geometry.loads)
    if (geometry.has(load) && load.kind->moves_surface())
      for (const std::string &surface : load.surfaces)
      {
        held.supports.push_back({boundary_of_marked(geometry, surface), {}});
        held.supports.back().directions[axis_of(load.direction)] = true;
      }
  return held;
}

dealii::types::boundary_id boundary_of_surface(const GeometryOptions &geometry, const std::string &surface,
                                               const Boundary otherwise)
{
  if (geometry.touches_with(surface))
    return contact_boundary(geometry.number_of_contact(surface));
  const std::vector<std::string> names = marked_surfaces(geometry);
  const auto found = std::find(names.begin(), names.end(), surface);
  return found == names.end()
             ? dealii::types::boundary_id(otherwise)
             : static_cast<dealii::types::boundary_id>(Boundary::first_support + (found - names.begin()));
}

std::string mirrored_surface(const std::string &surface, const unsigned int plane)
{
  const char axis = "xy"[plane];
  if (surface.size() != 2 || surface[0] != axis)
    return surface;
  return std::string(1, axis) + (surface[1] == '-' ? "+" : "-");
}

/// Why the loads are not symmetric. What pulls across a plane of symmetry is not, nor what pulls out of a
/// section without such a displacement.
static std::string asymmetry_of_loads(const GeometryOptions &geometry, const ModelSymmetry &symmetry)
{
  const SymmetryPlanes &planes = symmetry.planes();
  const bool is_section = symmetry.is_section();
  const std::array<bool, 2> excluded{
      {planes.normal_to_x || symmetry.is_axisymmetric(),
       planes.normal_to_y || symmetry.is_axisymmetric() || (is_section && !symmetry.has_third())}};
  for (const Load &load : geometry.loads)
  {
    if (!geometry.has(load))
      continue;
    for (unsigned int d = 0; d < 2; ++d)
      if (excluded[d] && load.direction[d] != 0)
        return "Load program/Loads: " + load.name + " acts along " + "xy"[d];
    for (unsigned int plane = 0; plane < 2; ++plane)
      for (const std::string &surface : load.surfaces)
      {
        const bool is_mirrored = plane == 0 ? planes.normal_to_x : planes.normal_to_y;
        const std::string image = mirrored_surface(surface, plane);
        const auto &all = load.surfaces;
        if (is_mirrored && !geometry.is_from_file() && std::find(all.begin(), all.end(), image) == all.end())
          return "Load program/Loads: " + load.name + " acts on " + surface + " and not on " + image;
      }
  }
  return {};
}

/// A mirror that exchanges two sides of a box must find both, or none, in contact.
static std::string asymmetry_of_contact(const GeometryOptions &geometry, const SymmetryPlanes &planes)
{
  for (const std::string &surface : geometry.touching_surfaces())
    for (unsigned int plane = 0; plane < 2; ++plane)
      if (const std::string image = mirrored_surface(surface, plane);
          (plane == 0 ? planes.normal_to_x : planes.normal_to_y) && !geometry.touches_with(image))
        return geometry.contact_entry() + " has " + surface + " and not " + image;
  return {};
}

std::string asymmetry_of_surfaces(const GeometryOptions &geometry, const ModelSymmetry &symmetry)
{
  if (const std::string why = asymmetry_of_loads(geometry, symmetry); !why.empty())
    return why;
  if (geometry.is_from_file())
    return {};
  const SymmetryPlanes &planes = symmetry.planes();
  if (const std::string why = asymmetry_of_contact(geometry, planes); !why.empty())
    return why;
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

/// Names of surfaces that may not touch the counterface.
static std::vector<std::string> without_contact(const GeometryOptions &geometry,
                                                std::vector<std::string> surfaces)
{
  surfaces.erase(std::remove_if(surfaces.begin(), surfaces.end(),
                                [&](const std::string &name) { return geometry.touches_with(name); }),
                 surfaces.end());
  return surfaces;
}

void check_contact_surfaces(const GeometryOptions &geometry, const std::vector<std::string> &surfaces)
{
  const std::string given = geometry.contact_entry();
  if (geometry.contact_surfaces.size() > most_contact_surfaces)
    throw InputError(given + " names " + std::to_string(geometry.contact_surfaces.size()) +
                     " surfaces: allowed are " + std::to_string(most_contact_surfaces) + " at most");
  if (geometry.is_from_file() || geometry.touches_with_base_only())
    return;
  if (surfaces.empty())
    throw InputError(given + " with " + geometry.shape_entry() +
                     ", whose surfaces have no names: allowed is nothing");
  for (const std::string &name : geometry.contact_surfaces)
  {
    std::vector<std::string> allowed = surfaces;
    allowed.erase(allowed.begin() + 1); // the top, which is the held face
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      throw InputError(given +
                       (name == surfaces[1]
                            ? " is the held face: allowed are "
                            : " names no surface of " + geometry.shape_entry() +
                                  (geometry.is_plane_strain() ? " in plane strain" : "") + ": allowed are ") +
                       enumerated(allowed));
    if (std::count(geometry.contact_surfaces.begin(), geometry.contact_surfaces.end(), name) > 1)
      throw InputError(given + " names " + name + " twice: allowed is once");
    if (name != surfaces.front() && geometry.top_face == TopFace::clamped)
      throw InputError(given + " with " + geometry.section + "/Top face = clamped, so that the rim of " +
                       name +
                       " is a part of the held face, too: allowed is Top face = guided or free, or a Mesh "
                       "file whose contact surface ends below the held face");
    if (geometry.faces_down && name != surfaces.front())
      throw InputError(given + " on a counterface with the normal z: allowed is " + surfaces.front() +
                       ", or a counterface by Obstacle/Distance or with Obstacle/Normal = surface");
  }
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
    const std::vector<std::string> allowed = without_contact(geometry, surfaces);
    if (std::find(allowed.begin(), allowed.end(), support->surface) == allowed.end())
      throw InputError(entry_with(geometry, *support) +
                       (geometry.touches_with(support->surface)
                            ? " is the contact surface, which only the counterface may hold: allowed are "
                            : " names no surface of " + geometry.shape_entry() +
                                  (geometry.is_plane_strain() ? " in plane strain" : "") + ": allowed are ") +
                       enumerated(allowed));
  }
}

void check_surfaces_of_loads(const GeometryOptions &geometry, const std::vector<std::string> &surfaces)
{
  for (const Load &load : geometry.loads)
  {
    if (!geometry.has(load) || load.surfaces.empty() || geometry.is_from_file())
      continue;
    const std::string given = "Load program/Loads: '" + load.text() + "'";
    if (surfaces.empty())
      throw InputError(given + " with " + geometry.shape_entry() +
                       ", whose surfaces have no names: allowed are loads without surfaces");
    std::vector<std::string> allowed = without_contact(geometry, surfaces);
    const bool is_clamped = geometry.top_face == TopFace::clamped;
    if (is_clamped)
      allowed.erase(std::find(allowed.begin(), allowed.end(), surfaces[1]));
    for (const std::string &surface : load.surfaces)
      if (std::find(allowed.begin(), allowed.end(), surface) == allowed.end())
        throw InputError(given +
                         (geometry.touches_with(surface)
                              ? " acts on the contact surface, where the counterface alone may: allowed are "
                          : surface == surfaces[1]
                              ? " acts on the held face, which " + geometry.section +
                                    "/Top face = clamped moves as a rigid plate: allowed are "
                              : ": " + shown(surface) + " is no surface of " + geometry.shape_entry() +
                                    (geometry.is_plane_strain() ? " in plane strain" : "") +
                                    ": allowed are ") +
                         enumerated(allowed));
  }
}
} // namespace orthocone
