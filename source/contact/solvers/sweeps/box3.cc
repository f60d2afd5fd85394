// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "../solvers.h"

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// The paper's Box 3: a prediction tau = r - rho G(d) of the force of a node and its correction, the nearest
/// point of the cone, with the literal p and rho = factor / min(w_nn, w_xx, w_yy). It converges where it is a
/// contraction, which is not guaranteed: docs/theory.md, section 3.
class Box3 : public ContactSolver
{
public:
  Box3(const ContactSystem &system, const ContactSolverOptions &options, const char *const name)
      : system_(system),
        options_(options),
        name_(name)
  {
    for (Index node = 0; node < system.n_nodes(); ++node)
      rho_.push_back(options.rho_factor / system.compliance().diagonal_block(node).diagonal().minCoeff());
  }

protected:
  Vector3d corrected(const ContactStep &step, const Index node, const Vector3d &force,
                     const Vector3d &displacement) const
  {
    const OrthotropicFriction &law = ellipse_of(step, node, name_);
    return project(law, force - rho_[node] * modified_displacement(law, displacement));
  }

  const ContactSystem &system_;
  ContactSolverOptions options_;

private:
  const char *name_;        ///< of the method
  std::vector<double> rho_; ///< N/mm
};

/// Node by node: each feels the forces that those before it have got in the same sweep.
class Feng2006 : public Box3
{
public:
  Feng2006(const ContactSystem &system, const ContactSolverOptions &options)
      : Box3(system, options, "feng2006")
  {
    dense_compliance(system, "feng2006");
  }

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override
  {
    constexpr unsigned int iterations_between_checks = 5;
    return iterate_until_converged(step, options_, iterations_between_checks, unknowns,
                                   [&](Eigen::VectorXd &x) { sweep(step, x); });
  }

private:
  void sweep(const ContactStep &step, Eigen::VectorXd &unknowns) const;
};

void Feng2006::sweep(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  const DenseView &w = *system_.compliance().dense();
  BalancingFace face(step, unknowns);
  auto force = unknowns.head(3 * step.n_nodes());
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    Vector3d d = step.q().segment<3>(3 * node) + w.middleCols<3>(3 * node).transpose() * force;
    if (step.face().n() > 0)
      d += face.displacement(node);
    const Vector3d r = force.segment<3>(3 * node);
    force.segment<3>(3 * node) = corrected(step, node, r, d);
    if (step.face().n() > 0)
      face.add(node, force.segment<3>(3 * node) - r);
  }
  unknowns.tail(step.face().n()) = face.motion();
}

/// All nodes at once, as the paper's text reads: with the displacements that the forces of the last iteration
/// cause. It diverges where rho times the largest eigenvalue of W exceeds 2, which is nearly everywhere
/// (docs/stability.md), and is there for study only.
class Box3AtOnce : public Box3
{
public:
  Box3AtOnce(const ContactSystem &system, const ContactSolverOptions &options)
      : Box3(system, options, "box3")
  {
  }

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override
  {
    constexpr unsigned int iterations_between_checks = 5;
    const auto iterate = [&](Eigen::VectorXd &x)
    {
      x.tail(step.face().n()) = BalancingFace(step, x).motion();
      const NodeVector d = step.displacement(x);
      for (Index node = 0; node < step.n_nodes(); ++node)
        x.segment<3>(3 * node) = corrected(step, node, x.segment<3>(3 * node), d.segment<3>(3 * node));
    };
    return iterate_until_converged(step, options_, iterations_between_checks, unknowns, iterate,
                                   Balance::unknown);
  }
};
} // namespace

ContactMethod feng2006_method()
{
  ContactMethod method{"feng2006", "the paper's Box 3, node by node", make<Feng2006>};
  method.rho = "1 / the smallest diagonal entry of a node's compliance";
  method.needs_ellipses = true;
  return method;
}

ContactMethod box3_method()
{
  ContactMethod method{"box3", "the paper's Box 3 for all nodes at once", make<Box3AtOnce>};
  method.rho = "1 / the smallest diagonal entry of a node's compliance";
  method.needs_ellipses = true;
  method.is_for_study = true;
  return method;
}
} // namespace orthocone
