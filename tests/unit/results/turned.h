// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Bodies from files that stand anywhere in space.
#pragma once

#include "body/msh.h"
#include "folder_of_files.h"

#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/surface/local_axes.h>

#include <deal.II/grid/grid_generator.h>

#include <functional>
#include <sstream>

namespace orthocone::test
{
using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d &)>;

/// A mesh with mapped vertices, as a file.
inline std::string mapped_mesh(const dealii::Triangulation<3> &mesh, const Map &map)
{
  Msh file(mesh);
  for (auto &node : file.nodes)
  {
    const Eigen::Vector3d place = map({node[0], node[1], node[2]});
    node = {{place[0], place[1], place[2]}};
  }
  return file.text();
}

/// A box of these cells with the corner (0, 0, 0): faces x = 0 and x = l are 1 and 2 as boundaries, and all
/// others 3, where `ids` (of x-, x+, y-, y+, z-, z+) does not say otherwise.
inline std::string box_mesh(const std::array<double, 3> &sizes, const std::vector<unsigned int> &cells,
                            const std::array<unsigned int, 6> &ids, const Map &map)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, dealii::Point<3>(),
                                                    dealii::Point<3>(sizes[0], sizes[1], sizes[2]), true);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(ids[face->boundary_id()]);
  return mapped_mesh(mesh, map);
}

/// "(0.6*x + -0.8*z + 3)": a component of a linear map of (x, y, z) as an expression.
inline std::string linear(const Eigen::Vector3d &factors, const double shift = 0)
{
  std::ostringstream text;
  text.precision(17);
  text << "(" << factors[0] << "*x + " << factors[1] << "*y + " << factors[2] << "*z + " << shift << ")";
  return text.str();
}
} // namespace orthocone::test
