// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// The paper's Box 3 for all nodes at once, as its text reads: prediction and correction with the
/// displacements that the forces of the last iteration cause. It diverges where rho times the largest
/// eigenvalue of W exceeds 2, which is nearly everywhere (docs/stability.md), and is there for study only.
class Box3 : public ContactSolver
{
public:
  Box3(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  const ContactSystem &system_;
  ContactSolverOptions options_;
};

Box3::Box3(const ContactSystem &system, const ContactSolverOptions &options)
    : system_(system),
      options_(options)
{
}

SolverReport Box3::solve(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  constexpr unsigned int iterations_between_checks = 5;
  const auto iterate = [&](Eigen::VectorXd &x)
  {
    const BalancingFace face(step, x);
    x.tail(step.face().n()) = face.motion();
    const NodeVector d = step.displacement(x);
    for (Index node = 0; node < step.n_nodes(); ++node)
    {
      const OrthotropicFriction &law = ellipse_of(step, node, "box3");
      const Vector3d g = modified_displacement(law, d.segment<3>(3 * node));
      const double rho = rho_of_box3(system_, node, options_.rho_factor);
      x.segment<3>(3 * node) = project(law, x.segment<3>(3 * node) - rho * g);
    }
  };
  return iterate_until_converged(step, options_, iterations_between_checks, unknowns, iterate,
                                 Diagnosis::none);
}
} // namespace

ContactMethod box3_method()
{
  ContactMethod method{"box3", "the paper's Box 3 for all nodes at once", make<Box3>};
  method.rho = "1 / the smallest diagonal entry of a node's compliance";
  method.is_for_study = true;
  return method;
}
} // namespace orthocone
