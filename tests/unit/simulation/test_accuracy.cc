// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>
#include <orthocone/simulation/mesh_ladder.h>
#include <orthocone/simulation/mesh_search.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
constexpr double contact_area = 314;

/// Quantities that approach 1, 2, 3 and 40 with errors that fall by `ratio` from level to level.
std::vector<Quantities> converging(const unsigned int n_levels, const double ratio)
{
  std::vector<Quantities> levels;
  for (unsigned int level = 0; level < n_levels; ++level)
  {
    const double error = 0.1 * std::pow(ratio, level);
    levels.push_back({{1 + error, 2 - error, 3 * (1 + error), 40 * (1 - error)}});
  }
  return levels;
}

/// Thickness of the outermost ring and of the lowest layer, mm.
std::array<double, 2> edge_cells(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  double rings = 0, layers = 0;
  for (unsigned int i = 0; i < mesh.rings; ++i)
    rings += std::pow(mesh.rim_grading, i);
  for (unsigned int i = 0; i < mesh.layers / 2; ++i)
    layers += std::pow(mesh.layer_grading, i);
  return {{(1 - mesh.core_ratio) * geometry.radius * std::pow(mesh.rim_grading, mesh.rings - 1) / rings,
           geometry.height / 2 * std::pow(mesh.layer_grading, mesh.layers / 2 - 1) / layers}};
}
} // namespace

TEST(EstimatedErrors, BoundThoseOfGeometricConvergence)
{
  for (const double ratio : {0.1, 0.3, 0.5, 0.7})
    for (const unsigned int n_levels : {3U, 4U, 5U})
    {
      const auto levels = converging(n_levels, ratio);
      const Quantities errors = estimated_errors(levels, contact_area);
      const std::array<double, 4> limits{{1, 2, 3, 40}};
      for (unsigned int i = 0; i < n_quantities; ++i)
      {
        const double error = 100 * std::abs(levels.back()[i] - limits[i]) / levels.back()[i];
        EXPECT_GE(errors[i], (ratio > 0.6 ? 0.6 : 0.999) * error)
            << "ratio " << ratio << ", " << n_levels << " levels";
        EXPECT_LE(errors[i], 40 * error);
      }
    }
}

TEST(EstimatedErrors, DoNotBelieveADifferenceThatIsSmallByChance)
{
  const std::vector<Quantities> levels{{{1, 1, 1, 100}}, {{1.1, 1, 1, 100}}, {{1.1, 1, 1, 100}}};
  const Quantities errors = estimated_errors(levels, contact_area);
  EXPECT_GT(errors[0], 3);
  EXPECT_EQ(errors[1], 0);
}

TEST(EstimatedErrors, OfATinyStickZoneAreRelativeToATenthOfTheContact)
{
  const std::vector<Quantities> levels{{{1, 1, 1, 1}}, {{1, 1, 1, 0.5}}, {{1, 1, 1, 0.25}}};
  EXPECT_NEAR(estimated_errors(levels, contact_area)[3], 100 * 0.25 / (0.1 * contact_area), 1e-9);
  const std::vector<Quantities> none{{{0, 0, 0, 0}}, {{0, 0, 0, 0}}};
  for (const double error : estimated_errors(none, contact_area))
    EXPECT_EQ(error, 0);
}

TEST(MeshLadder, IsFinerOnEveryLevelAndFitsTheHeight)
{
  std::vector<std::pair<double, bool>> scenes;
  for (const double height : {1., 4., 10., 30., 100.})
    for (const bool is_axisymmetric : {false, true})
      scenes.emplace_back(height, is_axisymmetric);
  for (const auto &[height, is_axisymmetric] : scenes)
    for (unsigned int level = 0; level < n_ladder_levels(is_axisymmetric); ++level)
    {
      const GeometryOptions geometry{10, height, TopFace::clamped};
      const MeshOptions mesh = ladder_mesh(geometry, {}, is_axisymmetric, level);
      Parameters parameters;
      parameters.geometry = geometry;
      parameters.mesh = mesh;
      EXPECT_NO_THROW(check_parameters(parameters));
      const auto [rim, base] = edge_cells(geometry, mesh);
      EXPECT_LE(base, 1.2 * rim) << "height " << height << ", level " << level;
      if (level == 0)
        continue;
      const auto coarser = edge_cells(geometry, ladder_mesh(geometry, {}, is_axisymmetric, level - 1));
      EXPECT_LT(rim, 0.6 * coarser[0]);
      EXPECT_LT(base, coarser[1]);
    }
}

TEST(MeshLadder, ResolutionsAreLevelsOfItAndPaperIsTheDefault)
{
  MeshOptions mesh;
  mesh.model = ModelKind::half;
  unsigned int last = 0;
  for (const MeshResolution resolution :
       {MeshResolution::coarse, MeshResolution::medium, MeshResolution::fine})
  {
    mesh.resolution = resolution;
    const MeshOptions resolved = resolved_mesh({}, mesh, false);
    EXPECT_EQ(resolved.resolution, MeshResolution::custom);
    EXPECT_EQ(resolved.model, ModelKind::half);
    EXPECT_GT(resolved.core_cells, last);
    last = resolved.core_cells;
  }
  mesh.resolution = MeshResolution::paper;
  Parameters paper, custom;
  custom.mesh.model = ModelKind::half;
  paper.mesh = resolved_mesh({}, mesh, false);
  EXPECT_EQ(entry_values(paper), entry_values(custom));
}

TEST(MeshSearch, StopsWhereTheEstimatesAreAsWantedAndItsModelRemembersTheCycle)
{
  Parameters parameters;
  parameters.load.legs = {Leg{{{0, 0, -0.1}}, 1}, Leg{{{0, 0, -0.05}}, 1}};
  parameters.mesh.accuracy = 10;
  unsigned int n_lines = 0;
  const ChosenMesh chosen =
      choose_mesh(parameters, choose_model(parameters), [&](const std::string &) { ++n_lines; });
  EXPECT_EQ(n_lines, 4U); // three levels and the result
  ASSERT_TRUE(chosen.accuracy);
  EXPECT_TRUE(chosen.accuracy->is_reached());
  EXPECT_EQ(chosen.requested.accuracy, 10);
  EXPECT_EQ(chosen.mesh.accuracy, 0);
  // A second march begins every step with its solution.
  ContactState state = chosen.model->initial_state();
  for (const LoadStep &step : load_steps(parameters.load))
  {
    const SolverReport report = chosen.model->solver().solve(state, step);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0U);
  }
  EXPECT_NEAR(chosen.model->totals(state).total_dissipation, chosen.accuracy->values[2],
              1e-9 * chosen.accuracy->values[2]);
}

TEST(MeshSearch, DoesNotTryAMeshThatDoesNotFitIntoTheMemory)
{
  Parameters parameters;
  parameters.load.legs = {Leg{{{0, 0, -0.1}}, 1}};
  parameters.mesh.accuracy = 10;
  std::string told;
  constexpr double gigabytes = 1e-3; // less than any model needs
  const ChosenMesh chosen = find_mesh(
      parameters, choose_model(parameters), [&](const std::string &line) { told += line + "\n"; }, gigabytes);
  ASSERT_TRUE(chosen.accuracy);
  EXPECT_FALSE(chosen.accuracy->is_reached());
  ASSERT_TRUE(chosen.model);
  EXPECT_EQ(chosen.mesh.core_cells, ladder_mesh({}, parameters.mesh, false, 0).core_cells);
  EXPECT_NE(told.find("level 1 would need more memory"), std::string::npos) << told;
  EXPECT_NE(told.find("NOT reached"), std::string::npos) << told;
}
} // namespace orthocone::test
