// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/backend_choice.h>

#include <orthocone/accuracy/cost_model.h>
#include <orthocone/multigrid/multigrid_body.h>

#include "body/even_mesh.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
constexpr double much = 1e3; // GB
const SymmetryPlanes quarter{true, true};

Parameters refined(const unsigned int refinements)
{
  Parameters parameters;
  parameters.mesh = even_mesh(2, refinements);
  return parameters;
}

BodyBackend chosen(const Parameters &parameters, const double gigabytes = much)
{
  return choose_backend(parameters, quarter, gigabytes).backend;
}
} // namespace

TEST(BackendChoice, TakesMultigridForLargeBodiesOnly)
{
  EXPECT_EQ(chosen(refined(1)), BodyBackend::condensed);
  EXPECT_EQ(chosen(refined(4)), BodyBackend::multigrid);
  EXPECT_NE(choose_backend(refined(1), quarter, much).reason, "");
}

TEST(BackendChoice, TakesWhatTheMemoryHolds)
{
  EXPECT_EQ(chosen(refined(2), 0.01), BodyBackend::multigrid);
  EXPECT_EQ(chosen(refined(2)), BodyBackend::condensed);
}

TEST(BackendChoice, KnowsThatStretchedCellsTakeMoreCycles)
{
  Parameters parameters = refined(3);
  parameters.load.cycles = 1;
  parameters.mesh.layers = 1;
  parameters.geometry.height = 0.2; // cells are 20 times as wide as high
  EXPECT_EQ(chosen(parameters), BodyBackend::condensed);
}

/// Cells of which none is halved: multigrid must be clearly faster, or alone fit into the memory.
TEST(BackendChoice, KnowsMeshesWithoutCoarserOnes)
{
  Parameters parameters = refined(0);
  MeshOptions &mesh = parameters.mesh;
  mesh.core_cells = mesh.layers = 32;
  mesh.rings = 16;
  EXPECT_EQ(chosen(parameters), BodyBackend::multigrid);
  EXPECT_NE(choose_backend(parameters, quarter, much).reason, "");
  EXPECT_EQ(chosen(parameters, 0.1), BodyBackend::automatic); // too large for both
  mesh.layer_grading = mesh.rim_grading = 0.8;                // cells are 40 times as long as wide
  EXPECT_EQ(chosen(parameters), BodyBackend::condensed);
  EXPECT_EQ(chosen(parameters, 3), BodyBackend::multigrid);
}

/// Trilinear elements are their own coarsest mesh, which is factorized up to 1500 contact nodes.
TEST(BackendChoice, KnowsThatALargeCoarsestMeshIsAggregated)
{
  const auto bytes_per_unknown = [](const unsigned int n)
  {
    Parameters parameters = refined(0);
    parameters.mesh.degree = 1;
    parameters.mesh.core_cells = parameters.mesh.layers = n;
    parameters.mesh.rings = n / 2;
    parameters.load.cycles = 1; // more of them keep bodies, which are bounded
    const ModelSize size = model_size(parameters, quarter);
    EXPECT_EQ(aggregates_coarsest(size.dofs, size.contact_nodes), n > 38);
    return 1e9 * CostModel(parameters, quarter).multigrid_gigabytes() / size.dofs;
  };
  EXPECT_LT(bytes_per_unknown(48), 0.7 * bytes_per_unknown(38));
  EXPECT_NEAR(bytes_per_unknown(96), bytes_per_unknown(48), 0.1 * bytes_per_unknown(48));
}

/// Measured runs of one cycle: those of degree 3 are in the table "adaptive" of docs/accuracy.md.
TEST(BackendChoice, KnowsThatHalvedCellsTakeMoreMemory)
{
  struct Run
  {
    unsigned int degree, n_rounds;
    double dofs, contact_nodes, gigabytes;
  };
  for (const Run &run :
       {Run{3, 5, 295845, 8650, 1.065}, Run{3, 6, 617817, 17983, 2.181}, Run{3, 7, 1279437, 37129, 5.276},
        Run{3, 8, 2397168, 68839, 12.272}, Run{1, 6, 203826, 3962, 4.043}})
  {
    Parameters parameters = refined(1);
    parameters.mesh.degree = run.degree;
    parameters.mesh.refined_cells.resize(run.n_rounds);
    parameters.load.cycles = 1;
    const ModelSize size{0, run.contact_nodes, run.dofs, 0}; // memory depends on no more
    EXPECT_NEAR(CostModel(parameters, quarter, size).multigrid_gigabytes() / run.gigabytes, 1, 0.3)
        << run.n_rounds;
  }
}

/// A checkpoint has the bodies of a cycle that another one follows.
TEST(BackendChoice, KnowsThatCyclesKeepBodies)
{
  Parameters parameters = refined(3);
  const auto gigabytes = [&](const unsigned int cycles)
  {
    parameters.load.cycles = cycles;
    return CostModel(parameters, quarter).multigrid_gigabytes();
  };
  EXPECT_GT(gigabytes(2), gigabytes(1));
  EXPECT_NEAR(gigabytes(200), gigabytes(2), 0.1 * gigabytes(2)); // of one cycle
}

TEST(BackendChoice, ComparesNothingForSectionsAndSmallModels)
{
  for (const BackendChoice &choice : {choose_backend(refined(0), quarter, much),
                                      choose_backend(refined(4), ModelSymmetry::of_revolution(), much)})
  {
    EXPECT_EQ(choice.backend, BodyBackend::automatic);
    EXPECT_EQ(choice.reason, "");
  }
}

TEST(BackendChoice, TakesMultigridWithEveryVolumetricQuadrature)
{
  for (const auto quadrature :
       {VolumetricQuadrature::automatic, VolumetricQuadrature::full, VolumetricQuadrature::projected})
  {
    Parameters parameters = refined(4);
    parameters.mesh.volumetric_quadrature = quadrature;
    EXPECT_EQ(chosen(parameters), BodyBackend::multigrid);
  }
}

/// Of many cycles that may be jumped only the first and the last one count.
TEST(BackendChoice, CountsNoCyclesThatMayBeJumped)
{
  const auto seconds_of_condensed = [](const Parameters &parameters)
  {
    const std::string reason = choose_backend(parameters, quarter, much).reason;
    const std::size_t begin = reason.find("condensed about");
    return reason.substr(begin, reason.find(" s and", begin) - begin);
  };
  Parameters parameters = refined(2);
  parameters.load.cycles = 2;
  const std::string of_two = seconds_of_condensed(parameters);
  parameters.load.cycles = parameters.load.jump_cycles = 100000;
  EXPECT_NE(seconds_of_condensed(parameters), of_two);
  parameters.load.jump_when_periodic = 1e-6;
  EXPECT_EQ(seconds_of_condensed(parameters), of_two);
}

/// V-cycles of case B on 76320 unknowns (docs/stability.md, "On the whole body").
TEST(BackendChoice, KnowsThatNearlyIncompressibleBodiesTakeMoreCycles)
{
  Parameters parameters = refined(3);
  parameters.mesh.degree = 2;
  const auto seconds_with = [&](const double poisson_ratio)
  {
    parameters.material.poisson_ratio = poisson_ratio;
    return CostModel(parameters, quarter).multigrid().step_seconds;
  };
  const double of_steel = seconds_with(0.3);
  const std::pair<double, double> measured[] = {
      {0.495, 676. / 166}, {0.499, 1032. / 166}, {0.4999, 1551. / 166}};
  for (const auto &[poisson_ratio, ratio] : measured)
    EXPECT_NEAR(seconds_with(poisson_ratio) / of_steel, ratio, 0.25 * ratio) << poisson_ratio;
  EXPECT_EQ(seconds_with(0.1), of_steel);
}

TEST(BackendChoice, LeavesNearlyIncompressibleBodiesToMultigridWhereTheMemoryAsksForIt)
{
  Parameters parameters = refined(2);
  parameters.mesh.degree = 2;
  parameters.material.poisson_ratio = 0.4999;
  const double enough = CostModel(parameters, quarter).multigrid_gigabytes();
  EXPECT_EQ(chosen(parameters, 1.01 * enough), BodyBackend::multigrid);
  EXPECT_NE(chosen(parameters), BodyBackend::multigrid);
}

TEST(BackendChoice, NamesTheEntryThatMultigridIsNotFor)
{
  const auto expect_named = [](const Parameters &parameters, const std::string &entry)
  {
    const BackendChoice choice = choose_backend(parameters, quarter, much);
    EXPECT_EQ(choice.backend, BodyBackend::automatic);
    EXPECT_NE(choice.reason.find("multigrid is not for " + entry), std::string::npos) << choice.reason;
  };
  Parameters other = refined(4);
  other.material.poisson_ratio = 0.499;
  other.mesh.volumetric_quadrature = VolumetricQuadrature::full;
  expect_named(other, "Material/Poisson ratio = 0.499 with full volumetric quadrature");
  other = refined(4);
  other.contact_solver.method = "gauss-seidel";
  expect_named(other, "Contact solver/Method = gauss-seidel");
  other = refined(4);
  other.obstacle.kind = ObstacleKind::body;
  expect_named(other, "Obstacle/Kind = body");
}

/// The half-space takes memory and time of its own, and does not keep multigrid from large bodies.
TEST(BackendChoice, CountsAHalfSpaceBelowMultigrid)
{
  Parameters parameters = refined(4);
  const Estimate rigid = CostModel(parameters, quarter).multigrid();
  parameters.obstacle.kind = ObstacleKind::half_space;
  const Estimate elastic = CostModel(parameters, quarter).multigrid();
  EXPECT_GT(elastic.gigabytes, rigid.gigabytes);
  EXPECT_GT(elastic.set_up_seconds, rigid.set_up_seconds);
  EXPECT_GT(elastic.step_seconds, rigid.step_seconds);
  EXPECT_EQ(chosen(parameters), BodyBackend::multigrid);
}

TEST(BackendChoice, LeavesWhatIsGiven)
{
  for (const BodyBackend given : {BodyBackend::condensed, BodyBackend::multigrid})
  {
    Parameters parameters = refined(4);
    parameters.mesh.backend = given;
    EXPECT_EQ(chosen(parameters), given);
  }
}
} // namespace orthocone::test
