// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shapes.h"
#include "size_formula.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/grading.h>
#include <orthocone/body/shapes/supports.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
namespace
{
/// Places (mm) of the cells' faces along an axis, with 0 in the middle. Both sides mirror each other to the
/// last bit.
std::vector<double> places_about_middle(const double length, const unsigned int n, const double grading)
{
  const std::vector<double> from_end = positions_graded_to_both_ends(length, n, grading);
  std::vector<double> places;
  for (unsigned int i = 0; i <= n; ++i)
    places.push_back((from_end[i] - from_end[n - i]) / 2);
  return places;
}

class Box : public Shape
{
public:
  Box(const GeometryOptions &geometry, const MeshOptions &mesh)
      : geometry_(geometry),
        mesh_(mesh)
  {
  }

  void make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const override;
  void make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const override;
  std::string asymmetry(const ModelSymmetry &symmetry) const override;
  ModelSize size(const ModelSymmetry &symmetry) const override;

private:
  /// Of one of its faces but the top.
  dealii::types::boundary_id side(const std::string &name) const
  {
    return boundary_of_surface(geometry_, name, Boundary::lateral_surface);
  }

  /// Places of the faces of the modelled cells along x, y or z.
  std::vector<double> places(unsigned int direction, const SymmetryPlanes &planes) const;

  /// Fills `triangulation` with the cells between places along these directions.
  template<int dim>
  void make_cells(const SymmetryPlanes &planes, const std::array<unsigned int, dim> &directions,
                  dealii::Triangulation<dim> &triangulation) const;

  const GeometryOptions geometry_;
  const MeshOptions mesh_;
};

std::vector<double> Box::places(const unsigned int direction, const SymmetryPlanes &planes) const
{
  const unsigned int n = mesh_.cells[direction];
  const double length = geometry_.sizes[direction];
  if (direction == 2)
    return positions_graded_to_both_ends(length, n, mesh_.layer_grading);
  std::vector<double> all = places_about_middle(length, n, mesh_.edge_grading);
  if (direction == 0 ? planes.normal_to_x : planes.normal_to_y)
  {
    if (n % 2 != 0)
      throw std::logic_error("a plane of symmetry cuts the cells of the box");
    all.erase(all.begin(), all.begin() + n / 2);
  }
  return all;
}

template<int dim>
void Box::make_cells(const SymmetryPlanes &planes, const std::array<unsigned int, dim> &directions,
                     dealii::Triangulation<dim> &triangulation) const
{
  // Cells of size 1 come first, so that their corners can be moved exactly to places() in every model.
  constexpr bool colourize = true;
  std::array<std::vector<double>, dim> corners;
  std::vector<unsigned int> n_cells;
  dealii::Point<dim> end;
  for (unsigned int d = 0; d < dim; ++d)
  {
    corners[d] = places(directions[d], planes);
    n_cells.push_back(corners[d].size() - 1);
    end[d] = n_cells[d];
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, n_cells, dealii::Point<dim>(), end,
                                                    colourize);
  dealii::GridTools::transform(
      [&](const dealii::Point<dim> &corner)
      {
        dealii::Point<dim> place;
        for (unsigned int d = 0; d < dim; ++d)
          place[d] = corners[d][static_cast<std::size_t>(std::lround(corner[d]))];
        return place;
      },
      triangulation);
}

template<int dim, std::size_t n>
void set_boundaries(const std::array<dealii::types::boundary_id, n> &boundaries,
                    dealii::Triangulation<dim> &triangulation)
{
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundaries[face->boundary_id()]);
}

void Box::make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const
{
  make_cells<3>(planes, {{0, 1, 2}}, triangulation);
  // The order of the faces of a coloured box: left, right, front, back, lower, upper.
  const std::array<dealii::types::boundary_id, 6> boundaries{
      {planes.normal_to_x ? Boundary::plane_normal_to_x : side("x-"), side("x+"),
       planes.normal_to_y ? Boundary::plane_normal_to_y : side("y-"), side("y+"), side("base"),
       Boundary::top_face}};
  set_boundaries(boundaries, triangulation);
}

void Box::make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const
{
  if (!symmetry.is_plane_strain())
    return Shape::make_section(symmetry, triangulation);
  const SymmetryPlanes &planes = symmetry.planes();
  make_cells<2>(planes, {{0, 2}}, triangulation);
  const std::array<dealii::types::boundary_id, 4> boundaries{
      {planes.normal_to_x ? Boundary::plane_normal_to_x : side("x-"), side("x+"), side("base"),
       Boundary::top_face}};
  set_boundaries(boundaries, triangulation);
}

std::string Box::asymmetry(const ModelSymmetry &symmetry) const
{
  if (symmetry.is_axisymmetric())
    return no_body_of_revolution(geometry_);
  if (const std::string why = asymmetry_of_surfaces(geometry_, symmetry); !why.empty())
    return why;
  if (symmetry.is_plane_strain() && !symmetry.planes().normal_to_x)
    return {};
  const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
  const unsigned int n = mesh_.cells[direction];
  return n % 2 == 0
             ? ""
             : mesh_.section + "/Cells has an odd number along " + "xy"[direction] + ", " + std::to_string(n);
}

ModelSize Box::size(const ModelSymmetry &symmetry) const
{
  const SymmetryPlanes planes = symmetry.planes();
  const double nx = mesh_.cells[0] / (planes.normal_to_x ? 2. : 1.);
  const double ny = symmetry.is_plane_strain() ? 0 : mesh_.cells[1] / (planes.normal_to_y ? 2. : 1.);
  ModelSize size =
      symmetry.is_plane_strain()
          ? section_size(nx, mesh_.cells[2], mesh_.degree, geometry_.top_face, symmetry)
          : solid_size({nx * ny, 2 * (nx + ny), {{planes.normal_to_x ? ny : 0, planes.normal_to_y ? nx : 0}}},
                       mesh_.cells[2], mesh_.degree, geometry_.top_face);
  if (geometry_.touches_with_base_only())
    return size;
  const auto touches = [&](const char *const name, const bool is_there)
  { return is_there && geometry_.touches_with(name) ? 1 : 0; };
  const double degree = mesh_.degree;
  const std::array<double, 3> nodes{{nx * degree + 1, ny * degree + 1, mesh_.cells[2] * degree + 1}};
  const double without = (nodes[0] - touches("x-", !planes.normal_to_x) - touches("x+", true)) *
                         (nodes[1] - touches("y-", ny > 0 && !planes.normal_to_y) - touches("y+", ny > 0)) *
                         (nodes[2] - touches("base", true));
  size.contact_nodes = nodes[0] * nodes[1] * nodes[2] - without;
  return size;
}

class BoxKind : public ShapeKind
{
public:
  BodyShape shape() const override { return BodyShape::box; }

  void declare(GeometryOptions &geometry, const Condition &is_chosen, Section &section) const override
  {
    section
        .add("Sizes", geometry.sizes, two_or_three_numbers_codec(),
             "l_x, l_y, l_z: lengths of a box along x, y and z in mm; l_x, l_y: the part of the surface of a "
             "half-space that may touch.")
        .unit("mm")
        .only_if(is_chosen);
  }

  void declare_cells(MeshOptions &mesh, const Condition &is_chosen, Section &section) const override
  {
    constexpr unsigned int most = 4096;
    section
        .add(
            "Cells", mesh.cells, two_or_three_counts_codec(most),
            "n_x, n_y, n_z: numbers of cells of a box along x, y and z, up to 200 each; n_x, n_y: numbers of "
            "patches of a half-space.")
        .only_if(is_chosen);
    section
        .add("Edge grading", mesh.edge_grading, number_codec(NumberRange{0, 10, false, true}),
             "Thickness of each cell of a box along x and y divided by that of its neighbour towards the "
             "middle: below 1, cells get thinner towards the side faces; 1 = uniform.")
        .only_if(is_chosen);
  }

  double held_height(const GeometryOptions &geometry) const override { return geometry.sizes[2]; }

  std::optional<Thickness> thickness(const GeometryOptions &geometry) const override
  {
    return Thickness{geometry.sizes[1], geometry.section + "/Sizes: l_y"};
  }

  void check(const BodyOptions &body) const override
  {
    const MeshOptions &mesh = body.mesh;
    constexpr unsigned int most = 200;
    const std::string with_shape = " with " + body.geometry.shape_entry() + ": allowed are ";
    if (body.geometry.sizes[2] == 0)
      throw InputError(body.geometry.section +
                       "/Sizes = " + two_or_three_numbers_codec().print(body.geometry.sizes) + with_shape +
                       "three numbers, l_x, l_y, l_z");
    if (mesh.cells[2] == 0 || *std::max_element(mesh.cells.begin(), mesh.cells.end()) > most)
      throw InputError(mesh.section + "/Cells = " + two_or_three_counts_codec(most).print(mesh.cells) +
                       with_shape + "three whole numbers from 1 to " + std::to_string(most));
    for (const unsigned int d : {0, 1})
      check_grading(mesh.section + "/Edge grading", mesh.edge_grading, (mesh.cells[d] + 1) / 2,
                    std::to_string(mesh.cells[d]) + " cells along " + (d == 0 ? "x" : "y") +
                        ": allowed is a value that leaves every cell at least 1e-6 of the side");
    check_layers(mesh, mesh.cells[2]);
  }

  std::vector<std::string> surfaces(const GeometryOptions &geometry) const override
  {
    if (geometry.is_plane_strain())
      return {"base", "top", "x-", "x+"};
    return {"base", "top", "x-", "x+", "y-", "y+"};
  }

  std::string chooser_of_mesh() const override { return "Mesh/Cells chooses the mesh of a box"; }

  bool is_on_base(const GeometryOptions &geometry, const std::array<double, 2> &place) const override
  {
    constexpr double with_rounding = 1 + 1e-12;
    return 2 * std::abs(place[0]) <= with_rounding * geometry.sizes[0] &&
           2 * std::abs(place[1]) <= with_rounding * geometry.sizes[1];
  }

  std::string base_in_words(const GeometryOptions &geometry) const override
  {
    return "|x| <= " + to_text(geometry.sizes[0] / 2) + " and |y| <= " + to_text(geometry.sizes[1] / 2) +
           ", halves of " + geometry.section + "/Sizes";
  }

  std::array<double, 2> half_widths(const GeometryOptions &geometry) const override
  {
    const double width = geometry.is_plane_strain() ? geometry.sizes[0] : geometry.sizes[1];
    const auto [least, most] = std::minmax(geometry.sizes[0], width);
    return {{most / 2, least / 2}};
  }

  std::string height_entry(const GeometryOptions &geometry) const override
  {
    return "l_z of " + geometry.section + "/Sizes";
  }

  double base_layer(const BodyOptions &body) const override
  {
    return body.geometry.sizes[2] * end_share(body.mesh.cells[2], body.mesh.layer_grading);
  }

  double rim_size(const BodyOptions &body) const override
  {
    const auto &sizes = body.geometry.sizes;
    const MeshOptions &mesh = body.mesh;
    double size = sizes[2] * end_share(mesh.cells[2], mesh.layer_grading);
    for (unsigned int d = 0; d < (body.geometry.is_plane_strain() ? 1u : 2u); ++d)
      size = std::max(size, sizes[d] * end_share(mesh.cells[d], mesh.edge_grading));
    return size / half_widths(body.geometry)[1];
  }
  std::string rim_unit() const override { return "half the shorter side"; }
  std::string finer_rim() const override { return "cells, or Edge grading"; }

  std::string finer_cells(const BodyOptions &body) const override
  {
    return "more " + body.mesh.section + "/Cells, or an Edge grading above 1";
  }

  std::string describe(const GeometryOptions &geometry) const override
  {
    return "box, " + to_text(geometry.sizes[0]) + " x " + to_text(geometry.sizes[1]) + " x " +
           to_text(geometry.sizes[2]) + " mm";
  }

  std::unique_ptr<Shape> make(const GeometryOptions &geometry, const MeshOptions &mesh) const override
  {
    return std::make_unique<Box>(geometry, mesh);
  }
};
} // namespace

const ShapeKind &box_kind()
{
  static const BoxKind kind;
  return kind;
}
} // namespace orthocone
