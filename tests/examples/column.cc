// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: a column of history.csv is one line of a list in
// source/results/tables.cc: name, unit, what it means, and how it is found in a SolvedStep.
#include "results/scenes.h"

#include <orthocone/results/tables.h>

namespace orthocone::test
{
namespace
{
/// Share of what friction could carry along x that the step ends with.
double traction_ratio(const SolvedStep &step)
{
  const Eigen::Vector3d &force = step.totals.force;
  return force[2] > 0 ? std::hypot(force[0], force[1]) / force[2] : 0;
}
} // namespace

TEST(ExampleColumn, StandsInHeaderAndRow)
{
  Columns<SolvedStep> columns = history_columns();
  columns.emplace_back("traction_ratio", "", "tangential force / normal force", traction_ratio);
  Parameters parameters = small_scene();
  parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(1, 0, -0.01, 1)};
  TestScene scene(parameters);
  const Totals before = scene.totals();
  scene.march();
  const Totals totals = scene.totals();
  const SolvedStep solved{
      scene.state, before,    totals, {}, {}, 0, LoadProgram(parameters.load).steps().back(),
      "newton",    "ux uy uz"};
  const std::string header = header_line(columns), row = row_line(columns, solved);
  EXPECT_EQ(header.substr(header.rfind(',')), ",traction_ratio\n");
  EXPECT_NEAR(std::stod(row.substr(row.rfind(',') + 1)), 0.3, 1e-6) << "all slips: mu_x";
}
} // namespace orthocone::test
