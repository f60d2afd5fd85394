// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The entry Curved surfaces: which surfaces of a mesh file are planes, cylinders or spheres.
#include "../names_of_groups.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/curved_surfaces.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
using Vector = std::array<double, 3>;

/// The text behind a word and the blank after it, or nothing.
std::optional<std::string> behind(const std::string &word, const std::string &text)
{
  const bool begins = text.compare(0, word.size(), word) == 0 && text.size() > word.size();
  return begins && text[word.size()] == ' ' ? std::optional(trimmed(text.substr(word.size()))) : std::nullopt;
}

/// Reads "0 1 -2.5".
std::optional<Vector> parse_vector(const std::string &text)
{
  const auto numbers = parse_numbers(text, 3, ' ');
  if (!numbers ||
      !std::all_of(numbers->begin(), numbers->end(), [](const double x) { return std::isfinite(x); }))
    return std::nullopt;
  return Vector{{(*numbers)[0], (*numbers)[1], (*numbers)[2]}};
}

bool is_zero(const Vector &vector)
{
  return std::all_of(vector.begin(), vector.end(), [](const double x) { return x == 0; });
}

/// Reads "through 0 0 0 along 0 1 0".
bool parse_axis(const std::string &text, CurvedSurface &surface)
{
  const auto rest = behind("through", text);
  const std::size_t along = rest ? rest->find(" along ") : std::string::npos;
  if (along == std::string::npos)
    return false;
  const auto through = parse_vector(trimmed(rest->substr(0, along)));
  const auto direction = parse_vector(trimmed(rest->substr(along + std::string(" along ").size())));
  if (!through || !direction || is_zero(*direction))
    return false;
  surface.centre = *through;
  surface.direction = *direction;
  return true;
}

std::optional<CurvedSurface> parse_surface(const std::string &text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    return std::nullopt;
  CurvedSurface surface;
  surface.surface = trimmed(text.substr(0, colon));
  if (surface.surface.empty() || !is_group_name(surface.surface))
    return std::nullopt;
  const std::string what = trimmed(text.substr(colon + 1));
  const auto kind = from_word<SurfaceKind>(what.substr(0, what.find(' ')));
  if (!kind)
    return std::nullopt;
  surface.kind = *kind;
  const std::string rest = trimmed(what.substr(to_word(*kind).size()));
  if (surface.kind == SurfaceKind::plane)
    return rest.empty() ? std::optional(surface) : std::nullopt;
  if (surface.kind == SurfaceKind::cylinder)
    return parse_axis(rest, surface) ? std::optional(surface) : std::nullopt;
  const auto about = behind("about", rest);
  const auto centre = about ? parse_vector(*about) : std::nullopt;
  if (!centre)
    return std::nullopt;
  surface.centre = *centre;
  return surface;
}

std::string vector_text(const Vector &vector)
{
  return to_text(vector[0]) + " " + to_text(vector[1]) + " " + to_text(vector[2]);
}

bool is_new(const std::vector<CurvedSurface> &others, const CurvedSurface &surface)
{
  return std::none_of(others.begin(), others.end(),
                      [&](const CurvedSurface &other) { return other.surface == surface.surface; });
}
} // namespace

std::string CurvedSurface::text() const
{
  const std::string begin = surface + ": " + to_word(kind);
  switch (kind)
  {
  case SurfaceKind::cylinder:
    return begin + " through " + vector_text(centre) + " along " + vector_text(direction);
  case SurfaceKind::sphere:
    return begin + " about " + vector_text(centre);
  default:
    return begin;
  }
}

void declare_curved_surfaces(GeometryOptions &geometry, const Condition &is_chosen, Section &section)
{
  section
      .add("Curved surfaces", geometry.curved_surfaces,
           list_codec<CurvedSurface>("nothing, or surfaces, each once, that are cylinders, spheres or "
                                     "planes, such as 'bore: cylinder "
                                     "through 0 0 5 along 0 1 0 ; ball: sphere about 0 0 8 ; end: plane'",
                                     ';', " ; ", parse_surface, &CurvedSurface::text, is_new),
           "Surfaces of a Mesh file that are cylinders, spheres or planes, in the coordinates of the file "
           "(mm), "
           "so that smaller cells and curved elements follow them: 'NAME: cylinder through X Y Z along X Y "
           "Z', "
           "'NAME: sphere about X Y Z' and 'NAME: plane', separated by ';'. The radius is that of the nodes; "
           "in "
           "plane strain cylinders are along y.")
      .also_called({"curved boundaries", "manifolds", "round surfaces"})
      .only_if(is_chosen);
}

void check_curved_surfaces(const GeometryOptions &geometry)
{
  if (!geometry.is_plane_strain())
    return;
  for (const CurvedSurface &surface : geometry.curved_surfaces)
    if (surface.kind == SurfaceKind::sphere ||
        (surface.kind == SurfaceKind::cylinder && (surface.direction[0] != 0 || surface.direction[2] != 0)))
      throw InputError(geometry.section + "/Curved surfaces = " + surface.text() +
                       " with Geometry/Kind = plane strain: allowed are cylinders along y, such as 'cylinder "
                       "through 0 0 0 along 0 1 0', and planes");
}
} // namespace orthocone
