// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "../solvers.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// Simultaneous projections with a self-adaptive step: the projection-contraction method of He and Liao (J.
/// Optim. Theory Appl. 112 (2002) 111-128) on one step. It needs products with W only. Its contraction needs
/// the nearest point of the elliptic cone, and the modified displacement that belongs to it. A face's lack of
/// balance is put beside the displacements, and its motion beside the forces: the problem of both together is
/// monotone, too.
class Projections
{
public:
  explicit Projections(const ContactStep &step);

  /// One prediction and one correction.
  void iterate(VectorXd &unknowns);

private:
  VectorXd modified(const VectorXd &unknowns) const;
  VectorXd predicted(const VectorXd &unknowns, const VectorXd &direction, double factor) const;

  const ContactStep &step_;
  std::vector<OrthotropicFriction> laws_; ///< normalized
  VectorXd rho_;                          ///< step of each unknown; the metric of the method is diag(1 / rho)
  double factor_;                         ///< of the steps
};

Projections::Projections(const ContactStep &step)
    : step_(step),
      rho_(step.n_unknowns())
{
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    rho_.segment<3>(3 * node).setConstant(step.system().rho(node));
    laws_.push_back(normalized(ellipse_of(step, node, "uzawa")));
  }
  const double softness = step.system().softness();
  rho_.tail(step.face().n()).setConstant(softness / (1 + softness * step.face().stiffness().norm()));
  factor_ = 1 / (step.system().softness() * rho_.head(3 * step.n_nodes()).maxCoeff());
}

VectorXd Projections::modified(const VectorXd &unknowns) const
{
  VectorXd g(unknowns.size());
  const NodeVector d = step_.displacement(unknowns);
  for (Index node = 0; node < step_.n_nodes(); ++node)
    g.segment<3>(3 * node) = modified_displacement(laws_[node], d.segment<3>(3 * node));
  g.tail(step_.face().n()) = -step_.imbalance(unknowns);
  return g;
}

VectorXd Projections::predicted(const VectorXd &unknowns, const VectorXd &direction,
                                const double factor) const
{
  VectorXd predicted = unknowns - factor * rho_.cwiseProduct(direction);
  for (Index node = 0; node < step_.n_nodes(); ++node)
    predicted.segment<3>(3 * node) = project(laws_[node], predicted.segment<3>(3 * node));
  return predicted;
}

void Projections::iterate(VectorXd &unknowns)
{
  // He and Liao recommend these values: a prediction is accepted if `ratio` <= largest_ratio, and the step
  // grows where it was far too careful.
  constexpr double largest_ratio = 0.9;
  constexpr double careful_ratio = 0.5;
  constexpr double growth = 1.5;
  constexpr double over_relaxation = 1.9;
  constexpr unsigned int most_reductions = 60;

  const VectorXd g = modified(unknowns);
  VectorXd prediction, change, g_predicted, g_change;
  double ratio = 0;
  for (unsigned int reduction = 0; reduction < most_reductions; ++reduction)
  {
    prediction = predicted(unknowns, g, factor_);
    change = unknowns - prediction;
    g_predicted = modified(prediction);
    g_change = factor_ * rho_.cwiseProduct(g - g_predicted);
    const double size = std::sqrt((change.array().square() / rho_.array()).sum());
    if (size == 0)
      return;
    ratio = std::sqrt((g_change.array().square() / rho_.array()).sum()) / size;
    if (ratio <= largest_ratio)
      break;
    factor_ *= 2. / 3 * std::min(1., 1 / ratio);
  }
  const VectorXd descent = change - g_change;
  const double length = (change.array() * descent.array() / rho_.array()).sum() /
                        (descent.array().square() / rho_.array()).sum();
  unknowns = predicted(unknowns, g_predicted, over_relaxation * length * factor_);
  if (ratio <= careful_ratio)
    factor_ *= growth;
}

class Uzawa : public ContactSolver
{
public:
  Uzawa(const ContactSystem &, const ContactSolverOptions &options)
      : options_(options)
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override
  {
    constexpr unsigned int iterations_between_checks = 10;
    // Nothing is kept from one load step to the next, because a resumed run must take the same steps.
    Projections projections(step);
    return iterate_until_converged(step, options_, iterations_between_checks, unknowns,
                                   [&](VectorXd &x) { projections.iterate(x); });
  }

private:
  ContactSolverOptions options_;
};
} // namespace

ContactMethod uzawa_method()
{
  ContactMethod method{"uzawa", "projections of all nodes at once, with an adaptive step size", make<Uzawa>};
  method.needs_ellipses = true;
  return method;
}
} // namespace orthocone
