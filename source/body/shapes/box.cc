// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shapes.h"
#include "size_formula.h"

#include <orthocone/base/grading.h>
#include <orthocone/body/shapes/boundary.h>

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
  std::string asymmetry(const ModelSymmetry &symmetry) const override;
  ModelSize size(const ModelSymmetry &symmetry) const override;

private:
  /// Places of the faces of the modelled cells along x, y or z.
  std::vector<double> places(unsigned int direction, const SymmetryPlanes &planes) const;

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

void Box::make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const
{
  // Cells of size 1 come first, so that their corners can be moved exactly to places() in every model.
  constexpr bool colourize = true;
  std::array<std::vector<double>, 3> corners;
  std::vector<unsigned int> n_cells;
  dealii::Point<3> end;
  for (unsigned int d = 0; d < 3; ++d)
  {
    corners[d] = places(d, planes);
    n_cells.push_back(corners[d].size() - 1);
    end[d] = n_cells[d];
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, n_cells, dealii::Point<3>(), end,
                                                    colourize);
  dealii::GridTools::transform(
      [&](const dealii::Point<3> &corner)
      {
        dealii::Point<3> place;
        for (unsigned int d = 0; d < 3; ++d)
          place[d] = corners[d][static_cast<std::size_t>(std::lround(corner[d]))];
        return place;
      },
      triangulation);
  // The order of the faces of a coloured box: left, right, front, back, lower, upper.
  const std::array<Boundary, 6> boundaries{
      {planes.normal_to_x ? Boundary::plane_normal_to_x : Boundary::lateral_surface,
       Boundary::lateral_surface,
       planes.normal_to_y ? Boundary::plane_normal_to_y : Boundary::lateral_surface,
       Boundary::lateral_surface, Boundary::contact_surface, Boundary::top_face}};
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundaries[face->boundary_id()]);
}

std::string Box::asymmetry(const ModelSymmetry &symmetry) const
{
  if (symmetry.is_axisymmetric())
    return no_body_of_revolution(geometry_.shape);
  const unsigned int direction = symmetry.planes().normal_to_x ? 0 : 1;
  const unsigned int n = mesh_.cells[direction];
  return n % 2 == 0 ? ""
                    : std::string("Mesh/Cells has an odd number along ") + "xy"[direction] + ", " +
                          std::to_string(n);
}

ModelSize Box::size(const ModelSymmetry &symmetry) const
{
  const SymmetryPlanes planes = symmetry.planes();
  const double nx = mesh_.cells[0] / (planes.normal_to_x ? 2. : 1.);
  const double ny = mesh_.cells[1] / (planes.normal_to_y ? 2. : 1.);
  return solid_size({nx * ny, 2 * (nx + ny), {{planes.normal_to_x ? ny : 0, planes.normal_to_y ? nx : 0}}},
                    mesh_.cells[2], mesh_.degree, geometry_.top_face);
}
} // namespace

std::unique_ptr<Shape> make_box(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  return std::make_unique<Box>(geometry, mesh);
}
} // namespace orthocone
