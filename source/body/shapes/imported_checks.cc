// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What ImportedMesh checks of its cells and surfaces.
#include "cell_quality.h"
#include "coarse_curves.h"
#include "imported_places.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/supports.h>

#include <algorithm>

namespace orthocone
{
using dealii::Point;

void ImportedMesh::check_cells()
{
  std::vector<std::string> inverted;
  for (const auto &cell : triangulation_.active_cell_iterators())
    if (const double quality = quality_of(cell); !(quality > 0))
      inverted.push_back(place(cell->center()));
    else if (quality <= worst_quality_)
    {
      worst_quality_ = quality;
      worst_place_ = cell->center();
    }
  const bool is_one = inverted.size() == 1;
  FaultList faults;
  if (!inverted.empty())
    faults.add((is_one ? "the cell at " : "the cells at ") + enumeration(inverted) +
               (is_one ? " is" : " are") + " inverted: allowed are hexahedra with a positive volume " +
               where_volumes_count());
  if (const unsigned int n = n_pieces(triangulation_); n > 1)
    faults.add("has " + std::to_string(n) +
               " pieces without a common face: allowed is one body (gmsh: Coherence, Coherence Mesh)");
  faults.throw_if_any(file_.path + ": ");
}

/// Where cells need a positive volume, and what helps them to it.
std::string ImportedMesh::where_volumes_count() const
{
  if (curves_->is_empty())
    return "at each of their corners";
  return std::string("at every point, not only at their corners") +
         (geometry_.curved_surfaces.empty() ? " (gmsh: Mesh.HighOrderOptimize = 1)"
                                            : "; smaller cells along Curved surfaces make the arcs lower, "
                                              "and elements of second order bend "
                                              "the edges behind them, too");
}

double ImportedMesh::quality_of(const dealii::Triangulation<3>::cell_iterator &cell) const
{
  return curves_->is_empty() ? scaled_jacobian(cell)
                             : scaled_jacobian(curved_cell(*curves_, cell).quadratic());
}

/// Finds quadrilaterals of a physical surface that are no faces of the body.
void ImportedMesh::check_outside(const std::string &given, const std::string &surface,
                                 FaultList &faults) const
{
  const PhysicalGroup *const group = file_.find(2, surface);
  const std::size_t outside = faces_of(surface).size(),
                    n_given = group == nullptr ? outside : group->n_elements;
  if (outside != n_given)
    faults.add(given + " has " + std::to_string(n_given) + " faces, of which " + std::to_string(outside) +
               " are on the outside of the cells: allowed are all");
}

/// Finds places where the contact surface is below its plane or does not look down on it.
void ImportedMesh::check_contact(FaultList &faults) const
{
  const std::string given = geometry_.contact_entry();
  std::vector<std::string> below, upwards;
  for (const auto vertex : vertices_of(contact_))
    if (const Point<3> &at = triangulation_.get_vertices()[vertex]; at[2] < 0)
      below.push_back(place(at));
  std::set<std::string> middles_below;
  for (const Face &face : contact_)
  {
    const std::vector<Point<3>> nodes = nodes_of(face);
    for (std::size_t i = face->n_vertices(); i < nodes.size(); ++i)
      if (nodes[i][2] < 0)
        middles_below.insert(place(nodes[i]));
  }
  below.insert(below.end(), middles_below.begin(), middles_below.end());
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && is_contact(id_of(face)))
      {
        const auto outwards = face->center() - cell->center();
        const auto normals = area_vectors(nodes_of(face));
        if (std::any_of(normals.begin(), normals.end(),
                        [&](const auto &normal) { return normal * outwards * normal[2] >= 0; }))
          upwards.push_back(place(face->center()));
      }
  if (!below.empty())
    faults.add(given + " is below the plane at " + enumeration(below) +
               ": allowed is z >= 0, because the height of a contact node is its gap, or a counterface by "
               "Obstacle/Distance");
  if (!upwards.empty())
    faults.add(given + " does not look down at " + enumeration(upwards) +
               ": allowed is a surface that faces downwards, towards the counterface, or a counterface by "
               "Obstacle/Distance or with Obstacle/Normal = surface");
}

void ImportedMesh::check_surfaces() const
{
  FaultList faults;
  const auto check = [&](const std::string &entry, const std::string &surface)
  { check_outside(geometry_.section + "/" + entry + " = " + shown(surface), surface, faults); };
  for (const std::string &surface : geometry_.contact_surfaces)
    check("Contact surface", surface);
  check("Held surface", geometry_.held_surface);
  if (const auto twice = std::adjacent_find(contact_.begin(), contact_.end()); twice != contact_.end())
    faults.add(geometry_.contact_entry() + " has a face in two of its surfaces, at " +
               place((*twice)->center()) + ": allowed are surfaces without common faces");
  const std::set<unsigned int> vertices = vertices_of(contact_);
  std::vector<std::string> common;
  for (const auto held : vertices_of(held_))
    if (vertices.count(held) > 0)
      common.push_back(place(triangulation_.get_vertices()[held]));
  if (!common.empty())
    faults.add(geometry_.section + "/Held surface = " + shown(geometry_.held_surface) +
               " has nodes of the contact surface, such as " + common.front() +
               ": allowed are surfaces that do not touch");
  check_marked(faults);
  if (geometry_.faces_down)
    check_contact(faults);
  faults.throw_if_any();
}

/// Finds surfaces of supports and loads with faces of another surface that counts: each face has one name.
void ImportedMesh::check_marked(FaultList &faults) const
{
  const std::vector<std::string> names = marked_surfaces(geometry_);
  for (std::size_t i = 0; i < marked_.size(); ++i)
  {
    const bool is_support = std::any_of(geometry_.supports.begin(), geometry_.supports.end(),
                                        [&](const Support &support) { return support.surface == names[i]; });
    const std::string given =
        (is_support ? geometry_.section + "/Supports: " : std::string("Load program/Loads: ")) +
        shown(names[i]);
    check_outside(given, names[i], faults);
    for (const Face &face : marked_[i])
    {
      const auto id = id_of(face);
      const std::string other = is_contact(id)                 ? "the contact surface"
                                : id == Boundary::top_face     ? "the held surface"
                                : id < Boundary::first_support ? "a plane of symmetry"
                                : id < Boundary::first_support + i
                                    ? shown(names[id - Boundary::first_support])
                                    : "";
      if (other.empty())
        continue;
      faults.add(given + " has faces of " + other + ", such as the one at " + place(face->center()) +
                 ": allowed are surfaces without common faces");
      break;
    }
  }
}
} // namespace orthocone
