// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shape_checks.h"

#include "file_checks.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/grading.h>
#include <orthocone/base/text.h>
#include <orthocone/parameters/values.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone
{
namespace
{
bool is_box(const GeometryOptions &geometry)
{
  return geometry.shape == BodyShape::box;
}

std::string shape_word(const GeometryOptions &geometry)
{
  return " with Geometry/Shape = " + to_word(geometry.shape);
}

void check_grading(const std::string &entry, const double grading, const unsigned int n_graded,
                   const std::string &what)
{
  constexpr double least_thickness = 1e-6;
  if (thinnest_share(n_graded, grading) < least_thickness)
    throw InputError("Mesh/" + entry + " = " + to_text(grading) + " with " + what);
}

void check_layers(const unsigned int n, const double grading)
{
  check_grading("Layer grading", grading, (n + 1) / 2,
                std::to_string(n) + " layers: allowed is what leaves every layer 1e-6 of the height");
}

void check_cylinder(const MeshOptions &mesh)
{
  check_grading("Rim grading", mesh.rim_grading, mesh.n_rings(),
                std::to_string(mesh.n_rings()) +
                    " rings: allowed is what leaves every ring 1e-6 of their common thickness");
  check_layers(mesh.layers, mesh.layer_grading);
}

void check_box(const MeshOptions &mesh)
{
  for (const unsigned int d : {0, 1})
    check_grading("Edge grading", mesh.edge_grading, (mesh.cells[d] + 1) / 2,
                  std::to_string(mesh.cells[d]) + " cells along " + (d == 0 ? "x" : "y") +
                      ": allowed is what leaves every cell 1e-6 of the side");
  check_layers(mesh.cells[2], mesh.layer_grading);
}

bool is_on_base(const GeometryOptions &geometry, const std::array<double, 2> &place)
{
  constexpr double with_rounding = 1 + 1e-12;
  if (is_box(geometry))
    return 2 * std::abs(place[0]) <= with_rounding * geometry.sizes[0] &&
           2 * std::abs(place[1]) <= with_rounding * geometry.sizes[1];
  return std::hypot(place[0], place[1]) <= with_rounding * geometry.radius;
}

std::string base_in_words(const GeometryOptions &geometry)
{
  if (is_box(geometry))
    return "|x| <= " + to_text(geometry.sizes[0] / 2) + " and |y| <= " + to_text(geometry.sizes[1] / 2) +
           ", halves of Geometry/Sizes";
  return "points within Geometry/Radius = " + to_text(geometry.radius) + " of the axis";
}

void check_probes(const GeometryOptions &geometry, const std::vector<Probe> &probes)
{
  for (const Probe &probe : probes)
    if (!is_on_base(geometry, probe.position))
      throw InputError("Output/Probes: '" + probe.name + "' at (" + to_text(probe.position[0]) + ", " +
                       to_text(probe.position[1]) + ") is off the contact surface: allowed are " +
                       base_in_words(geometry));
}

/// Size of the largest elements at the rim of the base, relative to the radius, or for a box to half its
/// shorter side.
double rim_size(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  if (!is_box(geometry))
    return std::max((1 - mesh.core_ratio) * last_share(mesh.n_rings(), mesh.rim_grading),
                    geometry.height / geometry.radius * end_share(mesh.layers, mesh.layer_grading));
  double size = geometry.sizes[2] * end_share(mesh.cells[2], mesh.layer_grading);
  for (const unsigned int d : {0, 1})
    size = std::max(size, geometry.sizes[d] * end_share(mesh.cells[d], mesh.edge_grading));
  return size / (std::min(geometry.sizes[0], geometry.sizes[1]) / 2);
}

std::string coarse_rim(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  constexpr double most = 0.1; // divided by degree^2: that decides how well the singular slip is resolved
  constexpr double percent = 100;
  // Every round of refinement of single cells has the rim.
  const auto n_halvings = mesh.refinements + mesh.adaptive + mesh.refined_cells.size();
  const double size = std::ldexp(rim_size(geometry, mesh), -static_cast<int>(n_halvings));
  if (mesh.accuracy != 0 || size <= most * mesh.degree * mesh.degree)
    return {}; // with an accuracy the mesh is yet to be chosen
  return "Mesh: elements of degree " + std::to_string(mesh.degree) + " and " +
         to_text(std::round(percent * size)) + " % of " +
         (is_box(geometry) ? "half the shorter side" : "the radius") +
         " do not resolve the rim; the slip there may be wrong by 20 % and more: take "
         "a higher degree, more layers and " +
         (is_box(geometry) ? "cells, or Edge grading" : "rings, or Rim grading") + " and Layer grading < 1";
}

/// Warns of entries of other shapes that are set.
void warn_of_other_shape(const Parameters &parameters, std::vector<std::string> &warnings)
{
  static const std::vector<std::string> of_cylinders{"Geometry/Radius", "Geometry/Height", "Mesh/Core cells",
                                                     "Mesh/Rings",      "Mesh/Layers",     "Mesh/Core ratio",
                                                     "Mesh/Rim grading"};
  static const std::vector<std::string> of_boxes{"Geometry/Sizes", "Mesh/Cells", "Mesh/Edge grading"};
  static const std::vector<std::string> of_files{"Geometry/Mesh file", "Geometry/Contact surface",
                                                 "Geometry/Held surface", "Geometry/Symmetry surfaces"};
  const BodyShape shape = parameters.geometry.shape;
  const auto is_in = [](const std::vector<std::string> &entries, const std::string &entry)
  { return std::find(entries.begin(), entries.end(), entry) != entries.end(); };
  const auto is_of_other = [&](const std::string &entry)
  {
    return (shape != BodyShape::cylinder && is_in(of_cylinders, entry)) ||
           (shape != BodyShape::box && is_in(of_boxes, entry)) ||
           (shape != BodyShape::file && is_in(of_files, entry)) ||
           (shape == BodyShape::file && entry == "Mesh/Layer grading");
  };
  const auto values = entry_values(parameters);
  const auto defaults = entry_values(Parameters());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].second != defaults[i].second && is_of_other(values[i].first))
      warnings.push_back(values[i].first + " = " + values[i].second + " is ignored" +
                         shape_word(parameters.geometry));
}
} // namespace

std::string height_entry(const GeometryOptions &geometry)
{
  return is_box(geometry) ? "l_z of Geometry/Sizes" : "Geometry/Height";
}

void check_mesh_choice_of_shape(const Parameters &parameters)
{
  if (parameters.geometry.shape == BodyShape::cylinder)
    return;
  const MeshOptions &mesh = parameters.mesh;
  const std::string shape = shape_word(parameters.geometry);
  const std::string chosen = is_box(parameters.geometry)
                                 ? "; Mesh/Cells chooses the mesh of a box"
                                 : "; the file has the mesh, which Mesh/Refinements and Adaptive refine";
  if (mesh.accuracy != 0)
    throw InputError("Mesh/Accuracy = " + to_text(mesh.accuracy) + " %" + shape + ": allowed is 0" + chosen);
  if (mesh.resolution != MeshResolution::custom)
    throw InputError("Mesh/Resolution = " + to_word(mesh.resolution) + shape + ": allowed is custom" +
                     chosen);
}

void check_quadrature(const MeshOptions &mesh)
{
  if (mesh.n_quadrature_points() <= mesh.degree)
    throw InputError(
        "Mesh/Quadrature points = " + std::to_string(mesh.quadrature_points) +
        ": with Mesh/Degree = " + std::to_string(mesh.degree) +
        " allowed is 0 or more than the degree (fewer points leave deformations without stiffness)");
}

void check_shape(const Parameters &parameters)
{
  if (parameters.geometry.is_from_file())
    return check_mesh_file(parameters.geometry);
  if (is_box(parameters.geometry))
    check_box(parameters.mesh);
  else
    check_cylinder(parameters.mesh);
  check_probes(parameters.geometry, parameters.output.probes);
}

std::string coarse_rim_warning(const Parameters &parameters)
{
  return parameters.geometry.is_from_file() ? "" : coarse_rim(parameters.geometry, parameters.mesh);
}

/// Half the widest and half the narrowest width of the base, mm.
static std::array<double, 2> half_widths(const GeometryOptions &geometry)
{
  if (!is_box(geometry))
    return {{geometry.radius, geometry.radius}};
  const auto [least, most] = std::minmax(geometry.sizes[0], geometry.sizes[1]);
  return {{most / 2, least / 2}};
}

bool rim_surely_touches(const Parameters &parameters)
{
  return parameters.obstacle.is_plane();
}

bool rim_of_lower_body_touches(const Parameters &parameters)
{
  const GeometryOptions &upper = parameters.geometry, &lower = parameters.lower.geometry;
  if (upper.is_from_file() || lower.is_from_file())
    return false;
  return rim_surely_touches(parameters) && half_widths(lower)[1] <= half_widths(upper)[0];
}

void warn_of_shape(const Parameters &parameters, std::vector<std::string> &warnings)
{
  warn_of_other_shape(parameters, warnings);
}
} // namespace orthocone
