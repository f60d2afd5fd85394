// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "fitted_surfaces.h"

#include "cell_quality.h"
#include "imported_places.h"

#include <orthocone/base/errors.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace orthocone
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using BoundaryFace = dealii::Triangulation<3>::active_face_iterator;

constexpr double largest_departure = 1e-6; // of the radius, or of the extent of the body

/// Mean plane of the vertices, normal to the mean of the faces.
SurfaceForm mean_plane(const std::vector<BoundaryFace> &faces, const std::vector<Point<3>> &vertices)
{
  SurfaceForm plane{SurfaceKind::plane, {}};
  for (const Point<3> &vertex : vertices)
    plane.centre += vertex / static_cast<double>(vertices.size());
  for (const BoundaryFace &face : faces)
  {
    const Tensor<1, 3> normal = area_vector(face);
    plane.axis += normal * plane.axis >= 0 ? normal : -normal;
  }
  plane.axis /= plane.axis.norm();
  return plane;
}

Tensor<1, 3> direction_of(const CurvedSurface &surface)
{
  Tensor<1, 3> axis;
  const double largest = std::max(
      {std::abs(surface.direction[0]), std::abs(surface.direction[1]), std::abs(surface.direction[2])});
  for (unsigned int d = 0; d < 3; ++d)
    axis[d] = surface.direction[d] / largest;
  return axis / axis.norm();
}

/// The form through the vertices, with their mean radius.
SurfaceForm form_of(const FacesOfSurface &given, const std::vector<Point<3>> &vertices)
{
  const CurvedSurface &surface = given.surface;
  if (surface.kind == SurfaceKind::plane)
    return mean_plane(given.faces, vertices);
  SurfaceForm form{surface.kind, {surface.centre[0], surface.centre[1], surface.centre[2]}};
  if (surface.kind == SurfaceKind::cylinder)
    form.axis = direction_of(surface);
  for (const Point<3> &vertex : vertices)
    form.radius += form.arm(vertex).norm() / static_cast<double>(vertices.size());
  return form;
}

/// With the digits that a reader can compare.
std::string short_number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(9) << value;
  return text.str();
}

/// Throws where a vertex is off the form.
void require_on(const SurfaceForm &form, const CurvedSurface &surface, const std::vector<Point<3>> &vertices,
                const std::string &entry, const double extent)
{
  const auto departure = [&](const Point<3> &vertex)
  { return std::abs(form.arm(vertex).norm() - form.radius); };
  const Point<3> worst =
      *std::max_element(vertices.begin(), vertices.end(),
                        [&](const auto &a, const auto &b) { return departure(a) < departure(b); });
  const bool is_plane = surface.kind == SurfaceKind::plane;
  if (departure(worst) <= largest_departure * (is_plane ? extent : form.radius))
    return;
  const std::string begin = entry + " = " + surface.text() + ": the node at " + place(worst) + " is ";
  if (is_plane)
    throw InputError(
        begin + short_number(departure(worst)) +
        " mm off the mean plane of its surface: allowed is 1e-6 of the length of the body; name a "
        "surface that is plane");
  throw InputError(begin + short_number(form.arm(worst).norm()) + " mm off the " +
                   (surface.kind == SurfaceKind::sphere ? "centre" : "axis") + ", and the mean radius is " +
                   short_number(form.radius) +
                   " mm: allowed is 1e-6 of it for all nodes of the surface; correct the " +
                   (surface.kind == SurfaceKind::sphere ? "centre" : "axis") +
                   ", or give the round part a physical surface of its own");
}

/// Whether the corners of a face, and the middles of its lines that lie in no form, are in a plane.
bool is_plane(const BoundaryFace &face, const CoarseCurves<3> &curves, const SurfaceForm &plane,
              const double tolerance)
{
  const auto is_off = [&](const Point<3> &point) { return plane.arm(point).norm() > tolerance; };
  for (const unsigned int v : face->vertex_indices())
    if (is_off(face->vertex(v)))
      return false;
  for (const unsigned int i : face->line_indices())
  {
    const auto key = key_of<2>(face->line(i));
    const auto middle = curves.of_lines.find(key);
    if (middle != curves.of_lines.end() && curves.forms_of_lines.count(key) == 0 && is_off(middle->second))
      return false;
  }
  return true;
}

/// Keeps lines of the forms in plane faces beside them, unless both touch instead of meeting at an angle.
void add_planes(const dealii::Triangulation<3> &mesh, const double extent, CoarseCurves<3> &curves)
{
  constexpr double most = 0.99; // cosine of the angle
  for (const BoundaryFace &face : mesh.active_face_iterators())
  {
    if (!face->at_boundary() || curves.forms_of_quads.count(key_of<4>(face)) > 0)
      continue;
    const Tensor<1, 3> normal = area_vector(face);
    const SurfaceForm plane{SurfaceKind::plane, face->vertex(0), normal / normal.norm()};
    if (!is_plane(face, curves, plane, largest_departure * extent))
      continue;
    for (const unsigned int i : face->line_indices())
    {
      const auto found = curves.forms_of_lines.find(key_of<2>(face->line(i)));
      if (found == curves.forms_of_lines.end())
        continue;
      const Point<3> middle = projected(found->second, face->line(i)->center());
      if (std::abs(found->second.front().normal(middle) * plane.axis) < most)
        found->second.push_back(plane);
    }
  }
}
} // namespace

void fit_surfaces(const std::vector<FacesOfSurface> &surfaces, const std::string &entry, const double extent,
                  dealii::Triangulation<3> &mesh, CoarseCurves<3> &curves)
{
  std::map<unsigned int, std::vector<SurfaceForm>> forms_of_vertices;
  for (const FacesOfSurface &given : surfaces)
  {
    std::vector<Point<3>> vertices;
    const std::set<unsigned int> numbers = vertices_of(given.faces);
    for (const unsigned int v : numbers)
      vertices.push_back(mesh.get_vertices()[v]);
    const SurfaceForm form = form_of(given, vertices);
    require_on(form, given.surface, vertices, entry, extent);
    for (const unsigned int v : numbers)
      forms_of_vertices[v].push_back(form);
    std::set<std::array<unsigned int, 2>> lines;
    for (const BoundaryFace &face : given.faces)
    {
      if (!curves.forms_of_quads.emplace(key_of<4>(face), form).second)
        throw InputError(entry + ": " + given.surface.surface +
                         " has faces of another surface, such as the one at " + place(face->center()) +
                         ": allowed are surfaces without common faces");
      for (const unsigned int i : face->line_indices())
        lines.insert(key_of<2>(face->line(i)));
    }
    for (const auto &line : lines)
      curves.forms_of_lines[line].push_back(form);
  }
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (const auto found = forms_of_vertices.find(cell->vertex_index(v)); found != forms_of_vertices.end())
        cell->vertex(v) = projected(found->second, cell->vertex(v));
  add_planes(mesh, extent, curves);
}
} // namespace orthocone
