// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/bodies.h"

#include <orthocone/body/body.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
/// The formula knows all numbers but how many unknowns the planes of symmetry hold.
void expect_size_of(const BodyOptions &parameters, const ModelSymmetry &symmetry)
{
  const ModelSize size = make_shape(parameters.geometry, parameters.mesh)->size(symmetry);
  const Body body(parameters, symmetry);
  dealii::SparsityPattern pattern;
  body.make_pattern(pattern);
  const auto entries = static_cast<double>(pattern.n_nonzero_elements());
  const bool has_planes = symmetry.n_copies() > 1 || symmetry.is_axisymmetric(); // which hold some unknowns
  EXPECT_EQ(size.cells, body.unknowns().size().cells);
  EXPECT_EQ(size.contact_nodes, body.unknowns().contact_surface().nodes.size());
  EXPECT_EQ(size.dofs, body.unknowns().n_dofs());
  EXPECT_NEAR(size.stiffness_entries, entries, (has_planes ? 0.2 : 1e-12) * entries)
      << symmetry.name() << ", degree " << parameters.mesh.degree;
}

const std::vector<ModelSymmetry> solids{SymmetryPlanes{}, SymmetryPlanes{true, false},
                                        SymmetryPlanes{false, true}, SymmetryPlanes{true, true}};
} // namespace

TEST(ModelSize, OfCylinders)
{
  BodyOptions parameters;
  parameters.mesh.core_cells = 4;
  parameters.mesh.rings = 3;
  parameters.mesh.layers = 3;
  for (const unsigned int degree : {1, 2, 3})
    for (const TopFace top : {TopFace::clamped, TopFace::guided})
    {
      parameters.mesh.degree = degree;
      parameters.geometry.top_face = top;
      for (const ModelSymmetry &symmetry : solids)
        expect_size_of(parameters, symmetry);
      expect_size_of(parameters, ModelSymmetry::of_revolution());
      if (top == TopFace::clamped)
        expect_size_of(parameters, ModelSymmetry::of_revolution(true));
    }
}

TEST(ModelSize, OfBoxes)
{
  BodyOptions parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.mesh.cells = {{8, 6, 3}};
  for (const unsigned int degree : {1, 2, 3})
  {
    parameters.mesh.degree = degree;
    for (const ModelSymmetry &symmetry : solids)
      expect_size_of(parameters, symmetry);
    for (const bool has_third : {false, true})
      for (const bool is_half : {false, true})
        expect_size_of(parameters, ModelSymmetry::of_plane_strain(2, has_third, is_half));
  }
}
} // namespace orthocone::test
