// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// The method's iterations on one step. A face's lack of balance is put beside the displacements, and its
/// motion beside the forces: the problem of both together is monotone, too. Its contraction needs the nearest
/// point of the elliptic cone, and the modified displacement that belongs to it.
class Projections
{
public:
  explicit Projections(const ContactStep &step);

  /// One prediction and one correction; `factor` scales the steps and is adapted.
  void iterate(VectorXd &unknowns, double &factor) const;

  const VectorXd &rho() const { return rho_; }

private:
  VectorXd modified(const VectorXd &unknowns) const;
  VectorXd predicted(const VectorXd &unknowns, const VectorXd &direction, double factor) const;

  const ContactStep &step_;
  std::vector<OrthotropicFriction> laws_; ///< normalized
  VectorXd rho_;                          ///< step of each unknown; the metric of the method is diag(1 / rho)
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
  rho_.tail(step.face().n()).setConstant(step.system().softness());
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

void Projections::iterate(VectorXd &unknowns, double &factor) const
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
    prediction = predicted(unknowns, g, factor);
    change = unknowns - prediction;
    g_predicted = modified(prediction);
    g_change = factor * rho_.cwiseProduct(g - g_predicted);
    const double size = std::sqrt((change.array().square() / rho_.array()).sum());
    if (size == 0)
      return;
    ratio = std::sqrt((g_change.array().square() / rho_.array()).sum()) / size;
    if (ratio <= largest_ratio)
      break;
    factor *= 2. / 3 * std::min(1., 1 / ratio);
  }
  const VectorXd descent = change - g_change;
  const double length = (change.array() * descent.array() / rho_.array()).sum() /
                        (descent.array().square() / rho_.array()).sum();
  unknowns = predicted(unknowns, g_predicted, over_relaxation * length * factor);
  if (ratio <= careful_ratio)
    factor *= growth;
}

/// Simultaneous projections with a self-adaptive step: the projection-contraction method of He and Liao (J.
/// Optim. Theory Appl. 112 (2002) 111-128). It needs products with W only.
class Uzawa : public ContactSolver
{
public:
  Uzawa(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  const ContactSystem &system_;
  ContactSolverOptions options_;
};

Uzawa::Uzawa(const ContactSystem &system, const ContactSolverOptions &options)
    : system_(system),
      options_(options)
{
}

SolverReport Uzawa::solve(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr unsigned int iterations_between_checks = 10;
  const Projections projections(step);
  // Nothing is kept from one load step to the next, because a resumed run must take the same steps.
  double factor = 1 / (system_.softness() * projections.rho().head(3 * step.n_nodes()).maxCoeff());
  return iterate_until_converged(step, options_, iterations_between_checks, unknowns,
                                 [&](VectorXd &x) { projections.iterate(x, factor); });
}
} // namespace

ContactMethod uzawa_method()
{
  ContactMethod method{"uzawa", "simultaneous projections with adaptive step", make<Uzawa>};
  return method;
}
} // namespace orthocone
