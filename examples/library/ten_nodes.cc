// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Ten nodes in a row are pressed on a plane and pushed along both axes of friction: units N and mm.
#include <orthocone/contact/solvers/contact_solver.h>

#include <iostream>

int main()
{
  constexpr Eigen::Index n = 10;
  // A force on one node (normal, x, y) moves all: less, the farther they are.
  Eigen::MatrixXd w(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      w.block<3, 3>(3 * i, 3 * j) =
          1e-5 * std::exp(-0.5 * std::abs(i - j)) * Eigen::Vector3d(1, 1.2, 1.2).asDiagonal();
  const orthocone::DenseCompliance compliance(w);
  const orthocone::OrthotropicFriction law{0.30, 0.15, 0.05, 0.20}; // mu_x, mu_y, p_x, p_y
  const orthocone::ContactSystem system(compliance, {n, law});

  Eigen::VectorXd q(3 * n); // where the nodes would be without forces
  for (Eigen::Index i = 0; i < n; ++i)
    q.segment<3>(3 * i) << -0.01, 0.0005 * i, 0.0003 * i;
  const orthocone::ContactStep step(system, q);

  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * n); // to start from
  const auto report = orthocone::make_contact_solver(system, {})->solve(step, force);
  const auto statuses = step.statuses(force, step.displacement(force));
  for (Eigen::Index i = 0; i < n; ++i)
    std::cout << force.segment<3>(3 * i).transpose() << ' ' << static_cast<int>(statuses[i]) << '\n';
  std::cerr << "residual " << report.residual << " after " << report.iterations << " iterations\n";
  return report.converged ? 0 : 3;
}
