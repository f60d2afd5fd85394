// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/msh.h"
#include "folder_of_files.h"
#include "results/scenes.h"

#include <orthocone/body/shapes/body_mesh.h>

namespace orthocone::test
{
// The built-in cylinder, written and read in again: the same cells of degree 1, the same history.
TEST(ImportedCylinder, HasTheHistoryOfTheBuiltInOne)
{
  const Folder folder;
  const Parameters built_in = small_scene();
  const BodyMesh cells(built_in.geometry, built_in.mesh, SymmetryPlanes{true, true});
  Parameters from_file = built_in;
  from_file.geometry =
      imported(folder.write("cylinder.msh", Msh(cells.triangulation()).text()), {"x0", "y0"});
  TestScene expected(built_in), scene(from_file);
  EXPECT_EQ(scene.symmetry.name(), "quarter");
  std::vector<Totals> history;
  std::vector<NodeVector> forces;
  expected.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &)
      {
        history.push_back(compute_totals(expected.evaluator, after));
        forces.push_back(after.force);
      });
  std::size_t step = 0;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &)
      {
        const Totals totals = compute_totals(scene.evaluator, after);
        const double largest = forces[4].lpNorm<Eigen::Infinity>();
        EXPECT_LE((after.force - forces.at(step)).lpNorm<Eigen::Infinity>(), 1e-10 * largest);
        const Totals &other = history.at(step++);
        EXPECT_NEAR(totals.force[2], other.force[2], 1e-10 * history[4].force[2]);
        EXPECT_NEAR(totals.max_slip, other.max_slip, 1e-10 * history[4].max_slip);
        EXPECT_NEAR(totals.total_dissipation, other.total_dissipation,
                    1e-10 * history[4].total_dissipation + 1e-10 * other.total_dissipation);
      });
  EXPECT_EQ(step, history.size());
}
} // namespace orthocone::test
