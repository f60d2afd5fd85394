// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "gauss_seidel.h"

#include "../solvers.h"

#include <orthocone/base/stop_point.h>
#include <orthocone/contact/law/natural_map.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
Vector3d relaxed(const FrictionLaw &law, const OneNodeProblem &one, const Vector3d &others,
                 const Vector3d &old, const double relaxation)
{
  const Vector3d exact = solve_one_node(law, one, others, old);
  return relaxation == 1 ? exact : admissible_force(law, old + relaxation * (exact - old));
}

bool has_long_slip_ellipse(const FrictionLaw &law)
{
  constexpr double most = 50; // times as long as wide
  return law.ellipse() != nullptr && law.ellipse()->p().maxCoeff() > most * law.ellipse()->p().minCoeff();
}
} // namespace

GaussSeidel::GaussSeidel(const ContactSystem &system, const ContactSolverOptions &options)
    : system_(system),
      options_(options)
{
  dense_compliance(system, "gauss-seidel");
  for (Index node = 0; node < system.n_nodes(); ++node)
  {
    const Eigen::Matrix3d block = system.compliance().diagonal_block(node);
    nodes_.push_back({block, block.inverse()});
  }
}

void GaussSeidel::sweep(const ContactStep &step, Eigen::VectorXd &unknowns, const double relaxation) const
{
  stop_point();
  if (step.face().n() > 0)
  {
    sweep_with_face(step, unknowns, relaxation);
    return;
  }
  const Compliance &compliance = system_.compliance();
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    const OneNodeProblem &one = nodes_[node];
    const Vector3d old = unknowns.segment<3>(3 * node);
    const Vector3d others =
        step.q().segment<3>(3 * node) + compliance.displacement_at(node, unknowns) - one.compliance * old;
    unknowns.segment<3>(3 * node) = relaxed(step.law(node), one, others, old, relaxation);
  }
}

/// The same, where every node feels the face besides the other nodes, and itself through the face.
void GaussSeidel::sweep_with_face(const ContactStep &step, Eigen::VectorXd &unknowns,
                                  const double relaxation) const
{
  const DenseView &w = *system_.compliance().dense();
  BalancingFace face(step, unknowns);
  auto force = unknowns.head(3 * step.n_nodes());
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    OneNodeProblem one = nodes_[node];
    one.compliance += face.compliance(node);
    one.stiffness = one.compliance.inverse();
    const Vector3d old = force.segment<3>(3 * node);
    const Vector3d others = step.q().segment<3>(3 * node) + face.displacement(node) +
                            w.middleCols<3>(3 * node).transpose() * force - one.compliance * old;
    force.segment<3>(3 * node) = relaxed(step.law(node), one, others, old, relaxation);
    face.add(node, force.segment<3>(3 * node) - old);
  }
  unknowns.tail(step.face().n()) = face.motion();
}

/// Sweeps come no nearer to the solution than they are told, and of a slip ellipse that is long, slip along
/// the shorter axis hardly counts in the residual. So they are told less where there is one, and judged by
/// what was asked.
SolverReport GaussSeidel::solve(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  constexpr unsigned int iterations_between_checks = 5;
  constexpr double stricter = 0.1;
  ContactSolverOptions told = options_;
  if (std::any_of(step.laws().begin(), step.laws().end(), has_long_slip_ellipse))
    told.tolerance *= stricter;
  SolverReport report =
      iterate_until_converged(step, told, iterations_between_checks, unknowns,
                              [&](Eigen::VectorXd &x) { sweep(step, x, options_.relaxation); });
  if (!report.converged && report.residual <= options_.tolerance)
    return make_report(step, unknowns, report.iterations, options_.tolerance, std::move(report.trace));
  return report;
}

ContactMethod gauss_seidel_method()
{
  ContactMethod method{"gauss-seidel", "sweeps of exact one-node solutions alone", make<GaussSeidel>};
  method.has_relaxation = true;
  return method;
}
} // namespace orthocone
