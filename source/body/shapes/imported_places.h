// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

#include <iomanip>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace orthocone
{
/// A place of a mesh in a message.
inline std::string place(const dealii::Point<3> &point)
{
  std::ostringstream text;
  text << std::setprecision(4) << "(" << point[0] << ", " << point[1] << ", " << point[2] << ") mm";
  return text.str();
}

/// Numbers of the vertices of faces.
inline std::set<unsigned int>
vertices_of(const std::vector<dealii::Triangulation<3>::active_face_iterator> &faces)
{
  std::set<unsigned int> all;
  for (const auto &face : faces)
    for (const unsigned int v : face->vertex_indices())
      all.insert(face->vertex_index(v));
  return all;
}
} // namespace orthocone
