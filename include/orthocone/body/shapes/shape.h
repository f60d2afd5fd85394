// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <string>

namespace orthocone
{
/// Size of a model, found from the numbers of cells alone. Counts are real numbers, because they may exceed
/// any integer.
struct ModelSize
{
  double cells;
  double contact_nodes;
  double dofs;
  double stiffness_entries; ///< on and below the diagonal; with symmetry to about 10 %
};

/// Shape of the body: what is meshed, and how large the model is. Its base is in z = 0, its axis is z;
/// lengths are in mm. A new shape is a file with a class derived from this one and a line in make_shape().
class Shape
{
public:
  virtual ~Shape() = default;

  /// Fills `triangulation` with the hexahedra of the modelled part; its boundary ids are those of boundary.h.
  virtual void make_solid(const SymmetryPlanes &planes, dealii::Triangulation<3> &triangulation) const = 0;

  /// The same for a section of this symmetry, (r, z) or (x, z), with quadrilaterals. Throws std::logic_error
  /// for one that the body does not have.
  virtual void make_section(const ModelSymmetry &symmetry, dealii::Triangulation<2> &triangulation) const;

  /// Why the body or its cells do not have this symmetry; empty if they do.
  virtual std::string asymmetry(const ModelSymmetry &symmetry) const = 0;

  /// The planes at which the cells themselves end, because a file has a part of the body only.
  virtual SymmetryPlanes own_planes() const { return {}; }

  /// Size of the model with this symmetry. A file throws std::logic_error for another part of the body than
  /// it has.
  virtual ModelSize size(const ModelSymmetry &symmetry) const = 0;
};

/// The shape that the options name, with the cells that they ask for. A mesh file throws as ImportedMesh
/// does.
std::unique_ptr<Shape> make_shape(const GeometryOptions &geometry, const MeshOptions &mesh);
} // namespace orthocone
