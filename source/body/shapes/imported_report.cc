// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_quality.h"

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include <cmath>
#include <iomanip>
#include <map>
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
  std::vector<std::string> named{geometry_.contact_surface, geometry_.held_surface};
  named.insert(named.end(), geometry_.symmetry_surfaces.begin(), geometry_.symmetry_surfaces.end());
  for (const std::string &surface : named)
    if (file_.find(2, surface) == nullptr)
      append_place(text, surface, faces_of(surface));
  text << "worst cell     at (" << worst_place_ << ") mm, scaled Jacobian " << std::setprecision(3)
       << worst_quality_ << " (1: a brick)\ncontact height " << least << " to " << largest
       << " mm above z = 0\n";
  return text.str();
}

/// Whether faces of a surface meet at angles that are neither nearly 0 nor as large as at an edge.
bool ImportedMesh::is_curved() const
{
  const double least = std::cos(pi / 1800), most = std::cos(pi / 4);             // 0.1 and 45 degrees
  std::map<std::pair<unsigned int, unsigned int>, dealii::Tensor<1, 3>> normals; // by line and surface
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      dealii::Tensor<1, 3> normal = area_vector(face) / area_vector(face).norm();
      normal *= normal * (face->center() - cell->center()) > 0 ? 1 : -1;
      for (const unsigned int line : face->line_indices())
      {
        const auto [other, is_first] =
            normals.emplace(std::make_pair(face->line_index(line), face->boundary_id()), normal);
        if (const double cosine = other->second * normal; !is_first && cosine < least && cosine > most)
          return true;
      }
    }
  return false;
}

std::vector<std::string> ImportedMesh::warnings(const MeshOptions &mesh) const
{
  std::vector<std::string> warnings;
  if (extent_ < 1)
    warnings.push_back(
        geometry_.section + "/Mesh file: the body is " + to_text(extent_) +
        " mm long; lengths are read as mm, and a mesh in metres is to be scaled by 1000 (gmsh: "
        "Mesh.ScalingFactor = 1000)");
  if ((mesh.refinements > 0 || mesh.adaptive > 0 || !mesh.refined_cells.empty()) && is_curved())
    warnings.emplace_back(
        mesh.section + "/Refinements: the file has cells with plane faces, and smaller cells keep them "
        "as facets of curved surfaces; a finer mesh by gmsh follows the curves");
  constexpr double poor = 0.1;
  if (worst_quality_ < poor)
    warnings.push_back(geometry_.section + "/Mesh file: the worst cell has a scaled Jacobian of " +
                       to_text(std::round(1e4 * worst_quality_) / 1e4) +
                       "; stresses near it are not to be trusted");
  return warnings;
}
} // namespace orthocone
