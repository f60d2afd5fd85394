// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_quality.h"

#include <orthocone/base/text.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
struct Part
{
  std::size_t n = 0;
  double size = 0; ///< mm^2 or mm^3
};

void append(std::ostream &text, const GmshFile &file, const unsigned int dimension,
            const std::map<unsigned int, Part> &parts)
{
  const bool is_volume = dimension == 3;
  for (const auto &[number, part] : parts)
  {
    const PhysicalGroup *const group = file.find(dimension, std::to_string(number));
    text << (is_volume ? "volume         " : "surface        ")
         << (group != nullptr && !group->name.empty()
                 ? shown(group->name) + " (" + std::to_string(number) + ")"
             : number == 0 ? "without a group"
                           : std::to_string(number))
         << ": " << part.n << (is_volume ? " cells, " : " faces, ") << part.size
         << (is_volume ? " mm^3\n" : " mm^2\n");
  }
}
/// A surface that is named by its place, which may have faces of the groups above.
void append_place(std::ostream &text, const std::string &surface,
                  const std::vector<dealii::Triangulation<3>::active_face_iterator> &faces)
{
  double area = 0;
  for (const auto &face : faces)
    area += area_vector(face).norm();
  text << "surface        " << shown(surface) << ": " << faces.size() << " faces, " << area << " mm^2\n";
}
} // namespace

std::string ImportedMesh::describe() const
{
  std::map<unsigned int, Part> volumes, surfaces;
  const auto add = [](Part &part, const double size)
  {
    ++part.n;
    part.size += size;
  };
  for (const auto &cell : triangulation_.active_cell_iterators())
    add(volumes[cell->material_id()], cell->measure());
  for (const auto &[number, faces] : faces_of_group_)
    for (const Face &face : faces)
      add(surfaces[number], area_vector(face).norm());
  for (const Face &face : triangulation_.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 0)
      add(surfaces[0], area_vector(face).norm());
  double least = highest_[2], largest = lowest_[2];
  for (const Face &face : contact_)
    for (const unsigned int v : face->vertex_indices())
    {
      least = std::min(least, face->vertex(v)[2]);
      largest = std::max(largest, face->vertex(v)[2]);
    }
  std::ostringstream text;
  text << std::setprecision(6) << "mesh file      " << file_.path << "\n";
  append(text, file_, 3, volumes);
  append(text, file_, 2, surfaces);
  std::vector<std::string> named = geometry_.contact_surfaces;
  named.push_back(geometry_.held_surface);
  named.insert(named.end(), geometry_.symmetry_surfaces.begin(), geometry_.symmetry_surfaces.end());
  for (const std::string &surface : marked_surfaces(geometry_))
    named.push_back(surface);
  for (const std::string &surface : named)
    if (!surface.empty() && file_.find(2, surface) == nullptr)
      append_place(text, surface, faces_of(surface));
  text << "worst cell     at (" << worst_place_ << ") mm, scaled Jacobian " << std::setprecision(3)
       << worst_quality_ << " (1: a brick)\ncontact height " << least << " to " << largest
       << " mm above z = 0\n";
  return text.str();
}
} // namespace orthocone
