// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "counterface_conditions.h"

#include "node_values.h"

#include <orthocone/base/ranks.h>
#include <orthocone/surface/joined_conditions.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// Displacements u of the body (mm), and behind them the unknowns x of the contact nodes (N) and y of the
/// face (mm). Every process knows all of x and y, but the vector has them in the first one alone, so that
/// each counts once in scalar products.
using Unknowns = dealii::LinearAlgebra::distributed::BlockVector<double>;

VectorXd of_contact(const Unknowns &unknowns)
{
  const auto n = static_cast<Index>(unknowns.block(1).size());
  VectorXd numbers = VectorXd::Zero(n);
  if (is_first_rank())
    numbers = entries(unknowns.block(1), n);
  sum_over_ranks(numbers.data(), static_cast<std::size_t>(n));
  return numbers;
}

void set_contact(Unknowns &unknowns, const VectorXd &nodes, const VectorXd &face)
{
  if (is_first_rank())
    entries(unknowns.block(1), nodes.size() + face.size()) << nodes, face;
}

/// The equations of CounterfaceConditions::solve().
class Equations
{
public:
  Equations(const MultigridCompliance &body, const Compliance &counterface,
            const ContactConditions &conditions)
      : body_(body),
        counterface_(counterface),
        conditions_(conditions),
        joined_(conditions)
  {
  }

  Index n_nodes() const { return joined_.basis.cols(); } ///< unknowns of the nodes
  Index n_face() const { return conditions_.face.cols(); }
  const ContactConditions &conditions() const { return conditions_; }

  Unknowns make_vector() const;
  void vmult(Unknowns &result, const Unknowns &unknowns) const;
  Unknowns right_side() const;
  ContactChange change(const Unknowns &unknowns) const;

  /// What remains of the nodes' equations for displacements of the body alone (mm).
  VectorXd tested(const BodyVector<double> &displacement) const
  {
    return joined_.rows.transpose() *
           body_.contact_displacement(displacement, NodeVector::Zero(joined_.rows.rows()));
  }

  /// The unknowns of the nodes that make these forces, which the conditions allow.
  VectorXd unknowns_of(const NodeVector &force) const;

private:
  /// What forces do to the balance of the face; no number without one.
  VectorXd of_face(const NodeVector &force) const
  {
    return n_face() > 0 ? VectorXd(conditions_.face.transpose() * force) : VectorXd();
  }

  NodeVector moved(const BodyVector<double> &displacement, const NodeVector &force,
                   const VectorXd &face) const;

  const MultigridCompliance &body_;
  const Compliance &counterface_;
  const ContactConditions &conditions_;
  JoinedConditions joined_;
};

Unknowns Equations::make_vector() const
{
  const auto n = static_cast<dealii::types::global_dof_index>(n_nodes() + n_face());
  dealii::IndexSet owned(n);
  if (is_first_rank())
    owned.add_range(0, n);
  Unknowns unknowns(2);
  unknowns.block(0) = body_.stiffness().make_vector();
  unknowns.block(1).reinit(owned, MPI_COMM_WORLD);
  unknowns.collect_sizes();
  return unknowns;
}

/// The displacement of the contact nodes relative to the counterface.
NodeVector Equations::moved(const BodyVector<double> &displacement, const NodeVector &force,
                            const VectorXd &face) const
{
  NodeVector given_way;
  counterface_.vmult(given_way, force);
  NodeVector moved = body_.contact_displacement(displacement, force) + given_way;
  if (n_face() > 0)
    moved += conditions_.face * face;
  return moved;
}

void Equations::vmult(Unknowns &result, const Unknowns &unknowns) const
{
  const VectorXd contact = of_contact(unknowns);
  const VectorXd nodes = contact.head(n_nodes()), face = contact.tail(n_face());
  const NodeVector force = joined_.basis * nodes;
  body_.stiffness().vmult(result.block(0), unknowns.block(0));
  result.block(0) -= body_.on_body(force);
  VectorXd balance = of_face(force);
  if (conditions_.face_stiffness.size() > 0)
    balance -= conditions_.face_stiffness * face;
  set_contact(result,
              joined_.rows.transpose() * moved(unknowns.block(0), force, face) +
                  joined_.diagonal.cwiseProduct(nodes),
              balance);
}

Unknowns Equations::right_side() const
{
  Unknowns right_side = make_vector();
  right_side.block(0) = body_.on_body(joined_.fixed);
  entries(right_side.block(0), conditions_.residual.size()) += conditions_.residual;
  const NodeVector of_fixed = moved(body_.stiffness().make_vector(), joined_.fixed, VectorXd::Zero(n_face()));
  set_contact(right_side, joined_.right_side - joined_.rows.transpose() * of_fixed,
              VectorXd(conditions_.face_right_side.head(n_face())) - of_face(joined_.fixed));
  return right_side;
}

ContactChange Equations::change(const Unknowns &unknowns) const
{
  const VectorXd contact = of_contact(unknowns);
  ContactChange change;
  change.force = joined_.fixed + joined_.basis * contact.head(n_nodes());
  change.face = contact.tail(n_face());
  change.displacement = moved(unknowns.block(0), change.force, change.face);
  BodyVector<double> forces = body_.stiffness().make_vector(), lacking = body_.on_body(change.force);
  body_.stiffness().vmult(forces, unknowns.block(0));
  lacking -= forces;
  const auto n = static_cast<Index>(body_.n_free());
  change.body = {entries(unknowns.block(0), n), entries(lacking, n)};
  return change;
}

VectorXd Equations::unknowns_of(const NodeVector &force) const
{
  VectorXd unknowns(n_nodes());
  Index place = 0;
  for (std::size_t i = 0; i < conditions_.nodes.size(); ++i)
  {
    const NodeCondition &node = conditions_.nodes[i];
    const Eigen::Vector3d own = force.segment<3>(3 * static_cast<Index>(i));
    if (node.n_unknowns > 0)
      unknowns.segment(place, node.n_unknowns) =
          node.basis.leftCols(node.n_unknowns).householderQr().solve(own);
    place += node.n_unknowns;
  }
  return unknowns;
}

/// An approximate inverse of the equations.
class Preconditioner
{
public:
  Preconditioner(const Equations &equations, const VCycle &cycle, const ConditionSolver &on_counterface,
                 const double softness)
      : equations_(equations),
        cycle_(cycle),
        on_counterface_(on_counterface),
        softness_(softness),
        conditions_(equations.conditions())
  {
    for (NodeCondition &node : conditions_.nodes)
    {
      node.rows *= softness;
      node.fixed.setZero();
    }
    conditions_.face_stiffness *= softness;
    conditions_.residual.resize(0);
  }

  void vmult(Unknowns &result, const Unknowns &right_side) const
  {
    constexpr double accuracy = 0.1;
    cycle_.vmult(result.block(0), right_side.block(0));
    const VectorXd of_right_side = of_contact(right_side);
    const VectorXd nodes = of_right_side.head(equations_.n_nodes()) - equations_.tested(result.block(0));
    Index place = 0;
    for (NodeCondition &node : conditions_.nodes)
    {
      node.right_side.head(node.n_unknowns) = nodes.segment(place, node.n_unknowns);
      place += node.n_unknowns;
    }
    conditions_.face_right_side = of_right_side.tail(equations_.n_face());
    const ContactChange change = on_counterface_.solve(conditions_, accuracy);
    set_contact(result, equations_.unknowns_of(change.force), softness_ * change.face);
  }

private:
  const Equations &equations_;
  const VCycle &cycle_;
  const ConditionSolver &on_counterface_;
  double softness_; ///< of both together, relative to the counterface
  mutable ContactConditions conditions_;
};
} // namespace

CounterfaceConditions::CounterfaceConditions(const MultigridCompliance &body, const double softness_of_body,
                                             const Compliance &counterface,
                                             const double softness_of_counterface)
    : body_(body),
      counterface_(counterface),
      softness_ratio_(softness_of_counterface / softness_of_body),
      on_counterface_(counterface.condition_solver(softness_of_counterface))
{
}

/// The conditions of the nodes are relations between contact forces r = fixed + basis x and displacements d
/// of the body relative to the counterface, whose compliance W_c is known by its products:
///   K u - basis x = residual + fixed,
///   rows^T (u + W_c (fixed + basis x) + face y) + diagonal x = right_side,   face^T r - S y = g.
/// If u is eliminated, W + W_c stands in the place of W_c, where W is the compliance of the body. All bodies
/// are like half-spaces to short waves, so that W is close to a multiple of W_c. Therefore flexible GMRES is
/// preconditioned by a V-cycle for u, without contact, and by the conditions on the counterface alone for x
/// and y, as much softer as both are together.
ContactChange CounterfaceConditions::solve(const ContactConditions &conditions, const double accuracy) const
{
  // Beyond them Newton's method corrects what is left. Each keeps two vectors of the body, for which the
  // estimate of memory has room.
  constexpr unsigned int most_iterations = 60;
  body_.cycle().release();
  const Equations equations(body_, counterface_, conditions);
  const Unknowns right_side = equations.right_side();
  Unknowns unknowns = equations.make_vector();
  dealii::IterationNumberControl control(most_iterations, accuracy * right_side.l2_norm(), false, false);
  dealii::SolverFGMRES<Unknowns> gmres(control,
                                       dealii::SolverFGMRES<Unknowns>::AdditionalData(most_iterations));
  gmres.solve(equations, unknowns, right_side,
              Preconditioner(equations, body_.cycle(), *on_counterface_, 1 + 1 / softness_ratio_));
  return equations.change(unknowns);
}
} // namespace orthocone
