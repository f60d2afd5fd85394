// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/shape.h>

namespace orthocone
{
/// Hexahedra of the modelled part of the body whose shape the options name. The mesh of a half or a quarter
/// consists of exactly those cells of the full mesh that lie there.
class BodyMesh
{
public:
  BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes)
  {
    make_shape(geometry, options)->make_solid(planes, triangulation_);
    triangulation_.refine_global(options.refinements);
  }

  const dealii::Triangulation<3> &triangulation() const { return triangulation_; }

private:
  dealii::Triangulation<3> triangulation_;
};

/// Rectangles of the section (r, z) of a body of revolution.
class SectionMesh
{
public:
  SectionMesh(const GeometryOptions &geometry, const MeshOptions &options)
  {
    make_shape(geometry, options)->make_section(triangulation_);
    triangulation_.refine_global(options.refinements);
  }

  const dealii::Triangulation<2> &triangulation() const { return triangulation_; }

private:
  dealii::Triangulation<2> triangulation_;
};
} // namespace orthocone
