// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "o_grid.h"
#include "ring_manifold.h"
#include "shapes.h"
#include "size_formula.h"

#include <orthocone/base/grading.h>
#include <orthocone/body/shapes/supports.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone
{
namespace
{
constexpr unsigned int n_ring_blocks = 4;
constexpr dealii::types::manifold_id first_ring_manifold = 1;

/// Quarter turns from the positive x axis to the outer block in which a cell lies, or n_ring_blocks for the
/// core.
unsigned int block_of(const dealii::Point<3> &centre, const double half_side)
{
  const double x = centre[0];
  const double y = centre[1];
  if (std::max(std::abs(x), std::abs(y)) < half_side)
    return n_ring_blocks;
  if (std::abs(x) > std::abs(y))
    return x > 0 ? 0 : 2;
  return y > 0 ? 1 : 3;
}

bool lies_in_plane(const dealii::Triangulation<3>::face_iterator &face, const unsigned int axis,
                   const double value, const double tolerance)
{
  for (const unsigned int vertex : face->vertex_indices())
    if (std::abs(face->vertex(vertex)[axis] - value) > tolerance)
      return false;
  return true;
}

dealii::types::boundary_id boundary_of(const dealii::Triangulation<3>::face_iterator &face,
                                       const GeometryOptions &geometry, const SymmetryPlanes &planes)
{
  constexpr double relative_tolerance = 1e-12;
  const double z_tolerance = relative_tolerance * geometry.height;
  const double r_tolerance = relative_tolerance * geometry.radius;
  if (lies_in_plane(face, 2, 0, z_tolerance))
    return boundary_of_surface(geometry, "base", Boundary::lateral_surface);
  if (lies_in_plane(face, 2, geometry.height, z_tolerance))
    return Boundary::top_face;
  if (planes.normal_to_x && lies_in_plane(face, 0, 0, r_tolerance))
    return Boundary::plane_normal_to_x;
  if (planes.normal_to_y && lies_in_plane(face, 1, 0, r_tolerance))
    return Boundary::plane_normal_to_y;
  return boundary_of_surface(geometry, "side", Boundary::lateral_surface);
}

std::vector<double> radii(const double radius, const MeshOptions &options)
{
  const unsigned int n_core = (options.core_cells + 1) / 2;
  const double core = core_half_side(radius, options.core_ratio);
  std::vector<double> positions;
  for (unsigned int i = 0; i < n_core; ++i)
    positions.push_back(core * i / n_core);
  for (const double depth : graded_positions(options.n_rings(), options.rim_grading))
    positions.push_back(core + depth * (radius - core));
  positions.back() = radius;
  return positions;
}

std::vector<double> differences(const std::vector<double> &positions)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < positions.size(); ++i)
    steps.push_back(positions[i] - positions[i - 1]);
  return steps;
}

class Cylinder : public Shape
{
public:
  Cylinder(const GeometryOptions &geometry, const MeshOptions &mesh)
      : geometry_(geometry),
        mesh_(mesh)
  {
  }

  void make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const override;
  void make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const override;
  std::string asymmetry(const ModelSymmetry &symmetry) const override;
  ModelSize size(const ModelSymmetry &symmetry) const override;

private:
  void curve_rings(dealii::Triangulation<3> &triangulation) const;
  ModelSize with_contact(double n_rim, ModelSize size) const;

  const GeometryOptions geometry_;
  const MeshOptions mesh_;
};

std::string Cylinder::asymmetry(const ModelSymmetry &symmetry) const
{
  if (symmetry.is_plane_strain())
    return geometry_.shape_entry() + " has no constant section along y";
  if (const std::string why = asymmetry_of_surfaces(geometry_, symmetry); !why.empty())
    return why;
  return symmetry.is_axisymmetric() || mesh_.core_cells % 2 == 0
             ? ""
             : mesh_.section + "/Core cells = " + std::to_string(mesh_.core_cells) + " is odd";
}

void Cylinder::make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const
{
  dealii::Triangulation<2> disc;
  make_o_grid_disc(geometry_.radius, mesh_, planes, disc);
  dealii::GridGenerator::extrude_triangulation(
      disc, positions_graded_to_both_ends(geometry_.height, mesh_.layers, mesh_.layer_grading),
      triangulation);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundary_of(face, geometry_, planes));
  curve_rings(triangulation);
}

void Cylinder::curve_rings(dealii::Triangulation<3> &triangulation) const
{
  const double half_side = core_half_side(geometry_.radius, mesh_.core_ratio);
  for (const auto &cell : triangulation.active_cell_iterators())
    if (const unsigned int block = block_of(cell->center(), half_side); block < n_ring_blocks)
      cell->set_all_manifold_ids(first_ring_manifold + block);
  for (unsigned int block = 0; block < n_ring_blocks; ++block)
    triangulation.set_manifold(first_ring_manifold + block, RingManifold(geometry_.radius, half_side, block));
}

void Cylinder::make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const
{
  if (!symmetry.is_axisymmetric())
    return Shape::make_section(symmetry, triangulation);
  constexpr bool colourize = true;
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation,
      {differences(radii(geometry_.radius, mesh_)),
       differences(positions_graded_to_both_ends(geometry_.height, mesh_.layers, mesh_.layer_grading))},
      dealii::Point<2>(0, 0), dealii::Point<2>(geometry_.radius, geometry_.height), colourize);
  const auto named = [&](const char *const name)
  { return boundary_of_surface(geometry_, name, Boundary::lateral_surface); };
  // The order of the faces of a coloured rectangle: left, right, lower, upper.
  const std::array<dealii::types::boundary_id, 4> boundaries{
      {Boundary::axis, named("side"), named("base"), Boundary::top_face}};
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundaries[face->boundary_id()]);
}

ModelSize Cylinder::size(const ModelSymmetry &symmetry) const
{
  const double core = mesh_.core_cells;
  const double rings = mesh_.n_rings();
  if (symmetry.is_axisymmetric())
    return with_contact(1, section_size(std::ceil(core / 2) + rings, mesh_.layers, mesh_.degree,
                                        geometry_.top_face, symmetry));
  const unsigned int n_copies = symmetry.n_copies();
  const double faces = (core * core + 4 * core * rings) / n_copies;
  const double diameter = n_copies == 1 ? 0 : core + 2 * rings; // or two radii of a quarter
  const std::array<double, 2> planes{
      {n_copies == 4 ? diameter / 2 : diameter, n_copies == 4 ? diameter / 2 : 0}};
  return with_contact(4 * core / n_copies * mesh_.degree + (n_copies == 1 ? 0 : 1),
                      solid_size({faces, 4 * core / n_copies + diameter, planes}, mesh_.layers, mesh_.degree,
                                 geometry_.top_face));
}

/// Of `size` as if the base alone touched, with `n_rim` of its nodes at the rim.
ModelSize Cylinder::with_contact(const double n_rim, ModelSize size) const
{
  const double of_base = size.contact_nodes, over_height = mesh_.layers * mesh_.degree + 1.;
  const double inside = of_base - (geometry_.touches_with("side") ? n_rim : 0);
  const double above = over_height - (geometry_.touches_with("base") ? 1 : 0);
  size.contact_nodes = of_base * over_height - inside * above;
  return size;
}

class CylinderKind : public ShapeKind
{
public:
  BodyShape shape() const override { return BodyShape::cylinder; }

  void declare(GeometryOptions &geometry, const Condition &is_chosen, Section &section) const override
  {
    section.add("Radius", geometry.radius, number_codec(positive), "Radius of a cylinder in mm.")
        .unit("mm")
        .only_if(is_chosen)
        .also_called({"r", "diameter", "d"});
    section.add("Height", geometry.height, number_codec(positive), "Height of a cylinder in mm.")
        .unit("mm")
        .only_if(is_chosen)
        .also_called({"length"});
  }

  void declare_cells(MeshOptions &mesh, const Condition &is_chosen, Section &section) const override
  {
    constexpr unsigned int most = 200;
    section
        .add("Core cells", mesh.core_cells, count_codec(1, most),
             "Number of cells along each side of the core block, the square in the middle of a cylinder's "
             "mesh.")
        .only_if(is_chosen)
        .also_called({"elements"});
    section
        .add("Rings", mesh.rings, count_codec(0, most),
             "Number of rings of cells between the core block of a cylinder and its rim; 0 = as many as Core "
             "cells.")
        .only_if(is_chosen);
    section
        .add("Layers", mesh.layers, count_codec(1, most),
             "Number of layers of cells over the height of a cylinder.")
        .only_if(is_chosen);
    section
        .add("Core ratio", mesh.core_ratio, number_codec(NumberRange{0.01, 1, true, false}),
             "Distance of the corners of the core block from the axis, divided by the radius.")
        .only_if(is_chosen);
    section
        .add("Rim grading", mesh.rim_grading, number_codec(NumberRange{0, 10, false, true}),
             "Thickness of each ring divided by that of the next inner one: below 1, rings get thinner "
             "towards the rim; 1 = uniform.")
        .only_if(is_chosen);
  }

  std::vector<std::string> surfaces(const GeometryOptions &) const override
  {
    return {"base", "top", "side"};
  }

  double held_height(const GeometryOptions &geometry) const override { return geometry.height; }

  void check(const BodyOptions &body) const override
  {
    const unsigned int n = body.mesh.n_rings();
    check_grading(
        body.mesh.section + "/Rim grading", body.mesh.rim_grading, n,
        std::to_string(n) +
            " rings: allowed is a value that leaves every ring at least 1e-6 of the thickness of all rings");
    check_layers(body.mesh, body.mesh.layers);
  }

  bool is_on_base(const GeometryOptions &geometry, const std::array<double, 2> &place) const override
  {
    constexpr double with_rounding = 1 + 1e-12;
    return std::hypot(place[0], place[1]) <= with_rounding * geometry.radius;
  }

  std::string base_in_words(const GeometryOptions &geometry) const override
  {
    return "points within " + geometry.section + "/Radius = " + to_text(geometry.radius) + " of the axis";
  }

  std::array<double, 2> half_widths(const GeometryOptions &geometry) const override
  {
    return {{geometry.radius, geometry.radius}};
  }

  std::string height_entry(const GeometryOptions &geometry) const override
  {
    return geometry.section + "/Height";
  }

  double base_layer(const BodyOptions &body) const override
  {
    return body.geometry.height * end_share(body.mesh.layers, body.mesh.layer_grading);
  }

  double rim_size(const BodyOptions &body) const override
  {
    const MeshOptions &mesh = body.mesh;
    return std::max((1 - mesh.core_ratio) * last_share(mesh.n_rings(), mesh.rim_grading),
                    body.geometry.height / body.geometry.radius * end_share(mesh.layers, mesh.layer_grading));
  }
  std::string rim_unit() const override { return "the radius"; }
  std::string finer_rim() const override { return "rings, or Rim grading"; }

  std::string finer_cells(const BodyOptions &body) const override
  {
    const std::string entry = body.mesh.section + "/";
    return entry + "Resolution = coarse, medium or fine, or " + entry +
           "Resolution = custom (and Accuracy = 0) with more Core cells, a Core ratio with which the core "
           "surrounds the zone, and Layers as thin as these cells";
  }

  std::string describe(const GeometryOptions &geometry) const override
  {
    return "cylinder, radius " + to_text(geometry.radius) + " mm, height " + to_text(geometry.height) + " mm";
  }

  std::unique_ptr<Shape> make(const GeometryOptions &geometry, const MeshOptions &mesh) const override
  {
    return std::make_unique<Cylinder>(geometry, mesh);
  }
};
} // namespace

const ShapeKind &cylinder_kind()
{
  static const CylinderKind kind;
  return kind;
}
} // namespace orthocone
