// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// The paper's Box 3 node by node: one prediction-correction for each node in a sweep, with the literal p and
/// rho = 1 / min(w_nn, w_xx, w_yy). Its convergence is not guaranteed: docs/theory.md, section 3.
class Feng2006 : public ContactSolver
{
public:
  Feng2006(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  void sweep(const ContactStep &step, Eigen::VectorXd &unknowns) const;

  const ContactSystem &system_;
  ContactSolverOptions options_;
  std::vector<double> rho_;
};

Feng2006::Feng2006(const ContactSystem &system, const ContactSolverOptions &options)
    : system_(system),
      options_(options)
{
  dense_compliance(system, "feng2006");
  for (Index node = 0; node < system.n_nodes(); ++node)
    rho_.push_back(rho_of_box3(system, node, options.rho_factor));
}

void Feng2006::sweep(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  const DenseView &w = *system_.compliance().dense();
  BalancingFace face(step, unknowns);
  auto force = unknowns.head(3 * step.n_nodes());
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = ellipse_of(step, node, "feng2006");
    Vector3d d = step.q().segment<3>(3 * node) + w.middleCols<3>(3 * node).transpose() * force;
    if (step.face().n() > 0)
      d += face.displacement(node);
    const Vector3d r = force.segment<3>(3 * node);
    force.segment<3>(3 * node) = project(law, r - rho_[node] * modified_displacement(law, d));
    if (step.face().n() > 0)
      face.add(node, force.segment<3>(3 * node) - r);
  }
  unknowns.tail(step.face().n()) = face.motion();
}

SolverReport Feng2006::solve(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  constexpr unsigned int iterations_between_checks = 5;
  return iterate_until_converged(step, options_, iterations_between_checks, unknowns,
                                 [&](Eigen::VectorXd &x) { sweep(step, x); });
}
} // namespace

ContactMethod feng2006_method()
{
  ContactMethod method{"feng2006", "the paper's Box 3, node by node", make<Feng2006>};
  method.rho = "1 / the smallest diagonal entry of a node's compliance";
  return method;
}
} // namespace orthocone
