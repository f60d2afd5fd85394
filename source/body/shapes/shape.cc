// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shapes.h"

#include <orthocone/parameters/values.h>

#include <stdexcept>

namespace orthocone
{
void Shape::make_section(dealii::Triangulation<2> &) const
{
  throw std::logic_error("this shape is not a body of revolution");
}

std::string no_body_of_revolution(const BodyShape shape)
{
  return "Geometry/Shape = " + to_word(shape) + " is no body of revolution";
}

std::unique_ptr<Shape> make_shape(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  switch (geometry.shape)
  {
  case BodyShape::cylinder:
    return make_cylinder(geometry, mesh);
  case BodyShape::box:
    return make_box(geometry, mesh);
  case BodyShape::file:
    return make_file_shape(geometry, mesh);
  }
  throw std::logic_error("unknown shape");
}
} // namespace orthocone
