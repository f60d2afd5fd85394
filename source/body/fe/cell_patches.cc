// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_patches.h"

#include <orthocone/body/shapes/boundary.h>

#include <deal.II/grid/grid_tools.h>

namespace orthocone
{
namespace
{
/// The image behind a face on the boundary: that of a plane of symmetry or of the axis, or 0.
unsigned int image_behind(const dealii::types::boundary_id id)
{
  switch (id)
  {
  case Boundary::plane_normal_to_x:
    return 1;
  case Boundary::plane_normal_to_y:
    return 2;
  case Boundary::axis:
    return 3;
  default:
    return 0;
  }
}
} // namespace

template<int dim>
CellPatches<dim>::CellPatches(const DisplacementSpace<dim> &space)
    : images_(space.dof_handler().get_triangulation().n_vertices(), {0}),
      is_on_surface_(images_.size(), false)
{
  const auto &mesh = space.dof_handler().get_triangulation();
  cells_.resize(images_.size());
  const auto cells_of_vertices = dealii::GridTools::vertex_to_cell_map(mesh);
  for (std::size_t vertex = 0; vertex < cells_.size(); ++vertex)
    for (const auto &cell : cells_of_vertices[vertex])
      cells_[vertex].emplace_back(&mesh, cell->level(), cell->index(), &space.dof_handler());
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
    {
      const bool is_boundary = cell->at_boundary(face);
      const bool is_interface = !is_boundary && cell->neighbor(face)->is_active() &&
                                cell->neighbor(face)->material_id() != cell->material_id();
      if (!is_boundary && !is_interface)
        continue;
      const unsigned int image = is_boundary ? image_behind(cell->face(face)->boundary_id()) : 0;
      for (const unsigned int i : cell->face(face)->vertex_indices())
        if (const unsigned int vertex = cell->face(face)->vertex_index(i); image == 0)
          is_on_surface_[vertex] = true;
        else
          for (const unsigned int other : std::set<unsigned int>(images_[vertex]))
            images_[vertex].insert(other ^ image);
    }
}

template<int dim>
void CellPatches<dim>::add_neighbours(const Cell &cell, const unsigned int images, Members &members) const
{
  const auto add = [&](const Cell &neighbour)
  {
    if (neighbour->material_id() == cell->material_id())
      members.emplace(neighbour, images);
  };
  for (const unsigned int face : cell->face_indices())
    if (cell->at_boundary(face))
    {
      if (const unsigned int image = image_behind(cell->face(face)->boundary_id()); image != 0)
        members.emplace(cell, images ^ image);
    }
    else if (cell->neighbor(face)->is_active())
      add(cell->neighbor(face));
    else
      for (unsigned int i = 0; i < cell->face(face)->n_children(); ++i)
        add(cell->neighbor_child_on_subface(face, i));
}

template<int dim>
std::vector<PatchCell<dim>> CellPatches<dim>::around(const unsigned int vertex,
                                                     const dealii::types::material_id material) const
{
  Members members;
  for (const Cell &cell : cells_[vertex])
    if (cell->material_id() == material)
      for (const unsigned int images : images_[vertex])
        members.emplace(cell, images);
  if (is_on_surface_[vertex])
    for (const auto &[cell, images] : Members(members))
      add_neighbours(cell, images, members);
  std::vector<PatchCell<dim>> patch;
  for (const auto &[cell, images] : members)
    patch.push_back({cell, images});
  return patch;
}

template class CellPatches<2>;
template class CellPatches<3>;
} // namespace orthocone
