// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: a contact solver. It sees a ContactStep, a value, and says with
// make_report() how far it came; what counts as solved is not its business.
#include "results/scenes.h"

#include <orthocone/contact/law/natural_map.h>
#include <orthocone/contact/solvers/contact_solver.h>

namespace orthocone::test
{
namespace
{
/// Simultaneous projections with the steps of the natural map divided by the number of nodes: slow, but it
/// cannot overshoot.
class CautiousProjections : public ContactSolver
{
public:
  explicit CautiousProjections(const ContactSolverOptions &options)
      : options_(options)
  {
  }

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override
  {
    const double share = 1 / static_cast<double>(step.n_nodes());
    unsigned int iteration = 0;
    while (step.residual(unknowns) > options_.tolerance && iteration++ < options_.maximum_iterations)
    {
      const NodeVector d = step.displacement(unknowns);
      for (Eigen::Index node = 0; node < step.n_nodes(); ++node)
      {
        auto force = unknowns.segment<3>(3 * node);
        const double rho = share * step.system().rho(node);
        force = TrialForce(step.law(node), rho, force, d.segment<3>(3 * node)).admitted(step.law(node));
      }
    }
    return make_report(step, unknowns, iteration, options_.tolerance);
  }

private:
  ContactSolverOptions options_;
};

ContactStep pressed(const Scene &scene)
{
  FaceTarget target;
  target.motion = moved_by(0, 0, -0.05);
  return ContactStep(scene.system(), step_displacement(scene.free_displacement(target), scene.gaps()));
}
} // namespace

TEST(ExampleSolver, FindsTheForcesOfNewton)
{
  Parameters parameters = small_scene();
  parameters.mesh.core_cells = parameters.mesh.rings = 2;
  parameters.contact_solver.tolerance = 1e-8;
  parameters.contact_solver.maximum_iterations = 100000;
  const Scene scene(parameters, choose_model(parameters));
  const ContactStep step = pressed(scene);
  Eigen::VectorXd ours = Eigen::VectorXd::Zero(step.n_unknowns()), newtons = ours;
  EXPECT_TRUE(CautiousProjections(parameters.contact_solver).solve(step, ours).converged);
  EXPECT_TRUE(make_contact_solver(scene.system(), parameters.contact_solver)->solve(step, newtons).converged);
  EXPECT_LT((ours - newtons).norm(), 1e-5 * newtons.norm());
}
} // namespace orthocone::test
