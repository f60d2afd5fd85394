// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_quality.h"
#include "coarse_curves.h"

#include <orthocone/base/text.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/supports.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <iomanip>
#include <numeric>
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

/// Sizes of cells and of faces on the boundary, mm^3 and mm^2; by quadrature where they are curved.
class Sizes
{
public:
  Sizes(const dealii::Triangulation<3> &mesh, const bool is_curved)
      : is_curved_(is_curved)
  {
    if (is_curved)
      integrate(mesh);
  }

  double of(const dealii::Triangulation<3>::active_cell_iterator &cell) const
  {
    return is_curved_ ? volumes_[cell->active_cell_index()] : cell->measure();
  }
  double of(const dealii::Triangulation<3>::active_face_iterator &face) const
  {
    return is_curved_ ? areas_.at(face->index()) : area_vector(face).norm();
  }

private:
  void integrate(const dealii::Triangulation<3> &mesh)
  {
    constexpr unsigned int degree = 4; // of the mapping, which is exact for cells of second order
    const dealii::MappingQ<3> mapping(degree);
    const dealii::FE_Q<3> fe(1);
    dealii::FEValues<3> cell_values(mapping, fe, dealii::QGauss<3>(degree), dealii::update_JxW_values);
    dealii::FEFaceValues<3> face_values(mapping, fe, dealii::QGauss<2>(degree + 1),
                                        dealii::update_JxW_values);
    const auto sum = [](const std::vector<double> &parts)
    { return std::accumulate(parts.begin(), parts.end(), 0.); };
    for (const auto &cell : mesh.active_cell_iterators())
    {
      cell_values.reinit(cell);
      volumes_.push_back(sum(cell_values.get_JxW_values()));
      for (const unsigned int face : cell->face_indices())
        if (cell->at_boundary(face))
        {
          face_values.reinit(cell, face);
          areas_[cell->face(face)->index()] = sum(face_values.get_JxW_values());
        }
    }
  }

  bool is_curved_;
  std::vector<double> volumes_;
  std::map<int, double> areas_; ///< by the numbers of the faces
};

/// A surface that is named by its place, which may have faces of the groups above.
void append_place(std::ostream &text, const std::string &surface, const Sizes &sizes,
                  const std::vector<dealii::Triangulation<3>::active_face_iterator> &faces)
{
  double area = 0;
  for (const auto &face : faces)
    area += sizes.of(face);
  text << "surface        " << shown(surface) << ": " << faces.size() << " faces, " << area << " mm^2\n";
}
} // namespace

std::string ImportedMesh::describe() const
{
  std::map<unsigned int, Part> volumes, surfaces;
  const Sizes sizes(triangulation_, !curves_->is_empty());
  const auto add = [](Part &part, const double size)
  {
    ++part.n;
    part.size += size;
  };
  for (const auto &cell : triangulation_.active_cell_iterators())
    add(volumes[cell->material_id()], sizes.of(cell));
  for (const auto &[number, faces] : faces_of_group_)
    for (const Face &face : faces)
      add(surfaces[number], sizes.of(face));
  for (const Face &face : triangulation_.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 0)
      add(surfaces[0], sizes.of(face));
  double least = highest_[2], largest = lowest_[2];
  for (const Face &face : contact_)
    for (const dealii::Point<3> &node : nodes_of(face))
    {
      least = std::min(least, node[2]);
      largest = std::max(largest, node[2]);
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
      append_place(text, surface, sizes, faces_of(surface));
  text << "worst cell     at (" << worst_place_ << ") mm, scaled Jacobian " << std::setprecision(3)
       << worst_quality_ << " (1: a brick)\ncontact height " << least << " to " << largest
       << " mm above z = 0\n";
  return text.str();
}
} // namespace orthocone
