// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "elastic_solver.h"
#include "whole_body_conditions.h"

#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// The compliance of a body without a dense W: every product is a solution of the body.
class MultigridCompliance : public Compliance
{
public:
  /// `of_nodes` is node_compliance(). `accuracy` is the relative error of equilibrium of a product. All that
  /// is passed by reference must outlive the compliance.
  MultigridCompliance(const ContactFrame &frame, const MatrixFreeStiffness<double> &stiffness, VCycle &cycle,
                      Eigen::VectorXd of_nodes, double accuracy);

  Eigen::Index n_nodes() const override { return of_nodes_.size(); }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  ContactChange approximate(const NodeVector &force) const override;
  ContactChange held_at(const Eigen::VectorXd &displacement) const override;
  SolutionMemory &memory() const override { return *memory_; }
  double norm(const Eigen::VectorXd &residual) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
  double softness() const override;

  // For solvers that share the body.
  const MatrixFreeStiffness<double> &stiffness() const { return stiffness_; }
  VCycle &cycle() const { return cycle_; }
  unsigned int n_free() const { return frame_.n_free(); }

  /// Contact forces (3 n, N, local axes) on the degrees of freedom of the body.
  BodyVector<double> on_body(const NodeVector &force) const;

  /// Displacement of the contact nodes (3 n, mm, local axes). A direction that symmetry holds has a
  /// compliance of its own.
  NodeVector contact_displacement(const BodyVector<double> &body, const NodeVector &force) const;

  /// Displacement of the free degrees of freedom (mm) under forces on them (N).
  Eigen::VectorXd displacement(const Eigen::VectorXd &forces) const;

  /// The same under contact forces.
  Eigen::VectorXd body_displacement(const NodeVector &force) const;

private:
  class Memory : public SolutionMemory
  {
  public:
    explicit Memory(const MultigridCompliance &compliance);
    void remember(const NodeVector &force, const BodyPart &body) override;
    std::vector<Eigen::VectorXd> forget_trials(const NodeVector &force) override;
    void restore(const std::vector<Eigen::VectorXd> &accepted) override;

    ElasticSolver elastic;
    ContactChange last; ///< what remember() was given last

  private:
    const MultigridCompliance &compliance_;
  };

  BodyVector<double> solution(const NodeVector &force) const
  {
    return memory_->elastic.solve(on_body(force), accuracy_);
  }

  const ContactFrame &frame_;
  const MatrixFreeStiffness<double> &stiffness_;
  VCycle &cycle_;
  Eigen::VectorXd of_nodes_; ///< mm/N
  double accuracy_;
  std::unique_ptr<Memory> memory_;
};
} // namespace orthocone
