// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/mesh_search.h>
#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/results/totals.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace orthocone::test
{
namespace
{
constexpr double area = 314;   ///< of the contact, mm^2
constexpr double motion = 0.1; ///< of the top, mm

/// Quantities that approach 1, 2, 3, 40 and 5 with errors that fall by `ratio` from level to level.
std::vector<Quantities> converging(const unsigned int n_levels, const double ratio)
{
  std::vector<Quantities> levels;
  for (unsigned int level = 0; level < n_levels; ++level)
  {
    const double error = 0.1 * std::pow(ratio, level);
    levels.push_back({{1 + error, 2 - error, 3 * (1 + error), 40 * (1 - error), 5 + error}});
  }
  return levels;
}

/// Thickness of the widest and of the thinnest of `n` intervals that shrink by `grading`, mm.
std::array<double, 2> widest_and_thinnest(const unsigned int n, const double grading, const double all)
{
  double sum = 0;
  for (unsigned int i = 0; i < n; ++i)
    sum += std::pow(grading, i);
  return {{all / sum, all / sum * std::pow(grading, n - 1)}};
}

/// Sizes of cells of a ladder's level, mm: rings where they are narrowest.
struct CellSizes
{
  CellSizes(const GeometryOptions &geometry, const bool is_axisymmetric, const unsigned int level)
      : mesh(ladder_mesh(geometry, {}, is_axisymmetric, level)),
        core(std::sqrt(2.) * mesh.core_ratio * geometry.radius / mesh.core_cells),
        rings(widest_and_thinnest(mesh.rings, mesh.rim_grading,
                                  geometry.radius *
                                      (1 - mesh.core_ratio / (is_axisymmetric ? std::sqrt(2.) : 1.)))),
        layers(widest_and_thinnest(mesh.layers / 2, mesh.layer_grading, geometry.height / 2))
  {
  }

  MeshOptions mesh;
  double core;
  std::array<double, 2> rings, layers;
};

/// Dissipated energy (N mm) of the paper's case A and stick area (mm2) before its last step.
std::array<double, 2> unloading_of_case_a(const MeshOptions &mesh)
{
  Parameters parameters;
  parameters.friction.mu = {{0.2, 0.2}};
  parameters.mesh = mesh;
  const Scene scene(parameters, choose_model(parameters));
  const ContactFieldEvaluator evaluator(scene);
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  double stick_area = 0;
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const ContactState before = state;
    stick_area = compute_totals(evaluator, before).stick_area;
    EXPECT_TRUE(solver.solve(state, step).converged);
    solver.accept(before, state, step);
  }
  return {{compute_totals(evaluator, state).total_dissipation, stick_area}};
}
} // namespace

TEST(EstimatedErrors, BoundThoseOfGeometricConvergence)
{
  for (const double ratio : {0.1, 0.3, 0.5, 0.7})
    for (const unsigned int n_levels : {3U, 4U, 5U})
    {
      const auto levels = converging(n_levels, ratio);
      const Quantities errors = estimated_errors(levels, area, motion);
      const Quantities limits{{1, 2, 3, 40, 5}};
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
  const Quantities errors = estimated_errors(levels, area, motion);
  EXPECT_GT(errors[0], 3);
  EXPECT_EQ(errors[1], 0);
}

TEST(EstimatedErrors, OfATinyStickZoneAreRelativeToATenthOfTheContact)
{
  const std::vector<Quantities> levels{{{1, 1, 1, 1}}, {{1, 1, 1, 0.5}}, {{1, 1, 1, 0.25}}};
  EXPECT_NEAR(estimated_errors(levels, area, motion)[3], 100 * 0.25 / (0.1 * area), 1e-9);
  const std::vector<Quantities> none{{{0, 0, 0, 0}}, {{0, 0, 0, 0}}};
  for (const double error : estimated_errors(none, area, motion))
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
      const CellSizes cells(geometry, is_axisymmetric, level);
      EXPECT_LE(cells.layers[1], 1.2 * cells.rings[1]) << "height " << height << ", level " << level;
      if (level == 0)
        continue;
      const CellSizes coarser(geometry, is_axisymmetric, level - 1);
      EXPECT_LT(cells.rings[1], 0.6 * coarser.rings[1]) << "level " << level;
      EXPECT_LT(cells.layers[1], coarser.layers[1]);
      EXPECT_LT(cells.core, 0.9 * coarser.core);
      EXPECT_LT(cells.rings[0], 0.96 * coarser.rings[0]) << "level " << level;
    }
}

/// No difference between levels shows what all of them have in common. (Layers of flat bodies are nearly even
/// on the first levels, and thin.)
TEST(MeshLadder, HasNoCellsThatAreTheSameOnAllLevels)
{
  for (const double height : {10., 30., 100.})
    for (const bool is_axisymmetric : {false, true})
    {
      const GeometryOptions geometry{10, height, TopFace::clamped};
      const CellSizes first(geometry, is_axisymmetric, 1);
      const CellSizes last(geometry, is_axisymmetric, n_ladder_levels(is_axisymmetric) - 1);
      EXPECT_LT(last.rings[0], 2. / 3 * first.rings[0]);
      EXPECT_LT(last.layers[0], 0.9 * first.layers[0]) << "height " << height;
    }
}

/// Stick ends in the middle of the base on the way up, where a ladder whose innermost ring is the same on
/// all levels has 436.9 N mm and 19 mm2 on all of the finer ones.
TEST(MeshLadder, ApproachesTheSameUnloadingAsEvenCells)
{
  MeshOptions even;
  even.core_cells = even.rings = even.layers = 32;
  even.core_ratio = std::sqrt(0.5); // a section's cells are then all as wide
  even.degree = 4;
  const auto truth = unloading_of_case_a(even);
  for (const unsigned int level : {3U, 5U})
  {
    const auto values = unloading_of_case_a(ladder_mesh({}, {}, true, level));
    EXPECT_NEAR(values[0], truth[0], 1.5e-3 * truth[0]) << "level " << level;
    EXPECT_NEAR(values[1], truth[1], 0.1 * truth[1]) << "level " << level;
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
  parameters.load.legs = {move_to(0, 0, -0.1, 3), move_to(0, 0, -0.05, 3)};
  parameters.mesh.accuracy = 10;
  std::vector<std::string> lines;
  const ChosenModel chosen = choose_mesh_and_steps(parameters, choose_model(parameters),
                                                   [&](const std::string &line) { lines.push_back(line); });
  ASSERT_EQ(lines.size(), 5U); // three levels, the backend of the last one, and the result
  EXPECT_EQ(chosen.parameters.mesh.backend, BodyBackend::condensed);
  EXPECT_EQ(lines[3].rfind("backend        condensed about ", 0), 0U) << lines[3];
  ASSERT_TRUE(chosen.accuracy);
  EXPECT_TRUE(chosen.accuracy->is_reached());
  EXPECT_EQ(chosen.given.mesh.accuracy, 10);
  EXPECT_EQ(chosen.parameters.mesh.accuracy, 0);
  // A second march begins every step with its solution.
  StepSolver solver(*chosen.scene);
  solver.restore(chosen.starts);
  ContactState state(chosen.scene->gaps());
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const SolverReport report = solver.solve(state, step);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0U);
  }
  EXPECT_NEAR(compute_totals(ContactFieldEvaluator(*chosen.scene), state).total_dissipation,
              chosen.accuracy->values[2], 1e-9 * chosen.accuracy->values[2]);
}

TEST(MeshSearch, DoesNotTryAMeshThatDoesNotFitIntoTheMemory)
{
  Parameters parameters;
  parameters.load.legs = {move_to(0, 0, -0.1, 1)};
  parameters.mesh.accuracy = 10;
  std::string reported;
  constexpr double gigabytes = 1e-3; // less than any model needs
  const ChosenModel chosen = find_mesh(
      parameters, choose_model(parameters), [&](const std::string &line) { reported += line + "\n"; },
      gigabytes);
  ASSERT_TRUE(chosen.accuracy);
  EXPECT_FALSE(chosen.accuracy->is_reached());
  ASSERT_TRUE(chosen.scene);
  EXPECT_EQ(chosen.parameters.mesh.core_cells, ladder_mesh({}, parameters.mesh, false, 0).core_cells);
  EXPECT_NE(reported.find("level 1 would need more memory"), std::string::npos) << reported;
  EXPECT_NE(reported.find("NOT reached"), std::string::npos) << reported;
}
} // namespace orthocone::test
