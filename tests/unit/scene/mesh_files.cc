// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/mesh_files.h>

#include "body/bodies.h"
#include "body/msh.h"
#include "folder_of_files.h"

#include <orthocone/body/body.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
/// A quarter of a box whose curved base rises by `rise` (1/mm) times x^2, in units of which `unit` are a mm.
GeometryOptions curved_box(const Folder &folder, const std::string &name, const double rise,
                           const double unit)
{
  GeometryOptions geometry;
  geometry.shape = BodyShape::box;
  geometry.sizes = {{12, 8, 6}};
  MeshOptions mesh;
  mesh.cells = {{6, 6, 4}};
  Msh box{BodyMesh(geometry, mesh, quarter).triangulation()};
  for (auto &node : box.nodes)
    node[2] += node[2] == 0 ? rise * node[0] * node[0] : 0;
  for (auto &node : box.nodes)
    for (double &coordinate : node)
      coordinate /= unit;
  return imported(folder.write(name, box.text()), {"x0", "y0"});
}
} // namespace

TEST(MeshFiles, OfBothBodiesAreDescribedAndWarnedOf)
{
  const Folder folder;
  Parameters parameters;
  parameters.geometry = curved_box(folder, "upper.msh", 0.001, 1);
  parameters.lower.geometry = curved_box(folder, "lower.msh", 0.002, 1000);
  parameters.lower.mesh.refinements = 1;
  EXPECT_EQ(describe_mesh_files(parameters).find("lower "), std::string::npos);
  EXPECT_TRUE(mesh_file_warnings(parameters).empty()) << "the lower body is not asked for";

  parameters.obstacle.kind = ObstacleKind::body;
  const std::string text = describe_mesh_files(parameters);
  for (const char *const line : {"\ncontact height 0 to 0.036 mm", "\nlower mesh file      ",
                                 "\nlower contact height 0 to 7.2e-05 mm", "\nlower worst cell     at ("})
    EXPECT_NE(text.find(line), std::string::npos) << line << " is missing in\n" << text;
  const std::vector<std::string> warnings = mesh_file_warnings(parameters);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].find("Lower geometry/Mesh file: the body is 0.006 mm long"), 0U) << warnings[0];
  EXPECT_EQ(warnings[1].find("Lower mesh/Refinements: "), 0U) << warnings[1];

  parameters.geometry = {};
  EXPECT_EQ(describe_mesh_files(parameters).find("lower mesh file"), 0U);
}
} // namespace orthocone::test
