// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The paper's cases on meshes that are graded to the rim, the base and the clamped face.
#include "results/scenes.h"

#include <orthocone/scene/parameters.h>

#include <string>
#include <tuple>

namespace orthocone::test
{
using Mesh = std::tuple<const char *, unsigned int, double>; ///< case, degree, grading

class GradedMesh : public testing::TestWithParam<Mesh>
{
};

namespace
{
std::string name_of(const testing::TestParamInfo<Mesh> &info)
{
  const auto [name, degree, grading] = info.param;
  return std::string(name) + "_q" + std::to_string(degree) + (grading < 0.5 ? "_strong" : "_weak");
}
} // namespace

INSTANTIATE_TEST_SUITE_P(Cases, GradedMesh,
                         testing::Combine(testing::Values("case_a", "case_b", "case_c"),
                                          testing::Values(2U, 3U), testing::Values(0.35, 0.6)),
                         name_of);

/// Small cells beside large ones, and a rim that lifts off: where Newton's method alone stalls.
TEST_P(GradedMesh, NewtonSolvesEveryStepUndivided)
{
  const auto &[name, degree, grading] = GetParam();
  Parameters parameters =
      read_parameters(ORTHOCONE_PRM_DIR "/paper/" + std::string(name) + ".prm", {"Load program/Cycles=1"});
  parameters.contact_solver = ContactSolverOptions{};
  parameters.mesh = MeshOptions{};
  parameters.mesh.model = ModelKind::quarter;
  parameters.mesh.core_cells = 4;
  parameters.mesh.rings = 5;
  parameters.mesh.layers = 6;
  parameters.mesh.degree = degree;
  parameters.mesh.rim_grading = parameters.mesh.layer_grading = grading;
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const ContactState before = state;
    const SolverReport report = solver.solve(state, step);
    ASSERT_TRUE(report.converged) << "step " << step.number << " residual " << report.residual;
    EXPECT_LE(report.residual, 1e-10);
    EXPECT_EQ(report.n_parts, 1U) << "step " << step.number;
    solver.accept(before, state, step);
  }
}
} // namespace orthocone::test
