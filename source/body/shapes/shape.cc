// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/shape.h>

#include "shapes.h"

#include <stdexcept>

namespace orthocone
{
void Shape::make_section(const ModelSymmetry &, dealii::Triangulation<2> &) const
{
  throw std::logic_error("this shape has no such section");
}

std::string no_body_of_revolution(const GeometryOptions &geometry)
{
  return geometry.shape_entry() + " is no body of revolution";
}

std::unique_ptr<Shape> make_shape(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  return kind_of(geometry).make(geometry, mesh);
}
} // namespace orthocone
