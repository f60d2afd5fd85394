// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/grid_surface.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/surface/model_symmetry.h>

#include <stdexcept>
#include <variant>

namespace orthocone
{
/// Mesh and unknowns of the modelled part of the body, a solid or a section, or the unknowns of a half-space,
/// which has no mesh: all that --check needs. The constructor throws InputError or FileError for a mesh file
/// and its entries, and what refine() throws.
class Body
{
public:
  Body(const BodyOptions &options, const ModelSymmetry &symmetry);

  const BodyUnknowns &unknowns() const;

  /// Without a mesh the functions below throw std::logic_error.
  bool has_mesh() const { return !std::holds_alternative<GridSurface>(shape_); }

  /// Of the half-space; with a mesh it throws std::bad_variant_access.
  const SurfaceGrid &surface_grid() const { return std::get<GridSurface>(shape_).grid(); }

  /// Number of meshes: the coarsest, and those that halving cells made of it.
  unsigned int n_levels() const;

  /// The longest edge of a cell divided by its shortest one: the largest ratio of all cells.
  double stretch() const;

  /// BodyMesh::cell_numbers().
  std::vector<unsigned int> cell_numbers() const;

  /// Fills `pattern` with the entries of the stiffness on and below the diagonal, n_free() x n_free().
  void make_pattern(dealii::SparsityPattern &pattern) const;

  /// K, n_free() x n_free(), N/mm.
  Stiffness stiffness(const Materials &materials) const;

  const Materials &materials() const { return materials_; }

  /// The displacement space of a solid. Throws std::bad_variant_access for a section.
  const Discretization &solid() const { return std::get<Solid>(shape_).discretization; }

  /// Returns `use` of the displacement space, which is a Discretization or a SectionDiscretization.
  template<typename Use>
  auto visit(const Use &use) const
  {
    if (const auto *const solid = std::get_if<Solid>(&shape_))
      return use(solid->discretization);
    return use(section().discretization);
  }

private:
  // A mesh and the displacements on it.
  struct Solid
  {
    Solid(const BodyOptions &options, const ModelSymmetry &symmetry)
        : mesh(options.geometry, options.mesh, symmetry.planes()),
          discretization(mesh.triangulation(), options.mesh, held_surfaces(options.geometry))
    {
    }
    BodyMesh mesh;
    Discretization discretization;
  };
  struct Section
  {
    Section(const BodyOptions &options, const ModelSymmetry &symmetry)
        : mesh(options.geometry, options.mesh, symmetry),
          discretization(mesh.triangulation(), options.mesh, held_surfaces(options.geometry),
                         *symmetry.section())
    {
    }
    SectionMesh mesh;
    SectionDiscretization discretization;
  };
  using Shape = std::variant<Solid, Section, GridSurface>;
  const Section &section() const
  {
    if (const auto *const section = std::get_if<Section>(&shape_))
      return *section;
    throw std::logic_error("a half-space has no mesh");
  }
  static Shape shape_of(const BodyOptions &options, const ModelSymmetry &symmetry);

  Materials materials_;
  Shape shape_;
};
} // namespace orthocone
