// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A steel block is pressed on a plane by 0.001 mm: the body is condensed to its contact nodes, then contact
// is solved.
#include <orthocone/body/backends/factorized_body.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <iostream>

int main()
{
  orthocone::BodyOptions options;
  options.geometry.shape = orthocone::BodyShape::box;
  options.geometry.sizes = {{10, 10, 5}};
  options.mesh.cells = {{4, 4, 2}};
  options.material.young_modulus = 210000;
  options.material.poisson_ratio = 0; // so the force is E A u / h = 4200 N
  orthocone::PhaseSeconds seconds;
  const orthocone::FactorizedBody body(
      options, {}, [](const auto &) { return orthocone::LocalAxes(0.); }, [](const auto &) {}, seconds);

  const auto n = static_cast<std::size_t>(body.compliance().n_nodes());
  const orthocone::ContactSystem system(body.compliance(),
                                        {n, orthocone::OrthotropicFriction{0.3, 0.3, 0.3, 0.3}});
  const orthocone::ContactStep step(system, body.moved_with(orthocone::moved_by(0, 0, -0.001)));
  Eigen::VectorXd force = Eigen::VectorXd::Zero(step.n_unknowns());
  const auto report = orthocone::make_contact_solver(system, {})->solve(step, force);

  std::cout << force.reshaped(3, n).row(0).sum() << " N of " << n << " nodes\n";
  return report.converged ? 0 : 3;
}
