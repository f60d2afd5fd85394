// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>

#include <Eigen/Dense>

#include <functional>
#include <memory>
#include <vector>

namespace orthocone
{
/// A dense W, whoever owns its memory: 3 n x 3 n, mm/N.
using DenseView = Eigen::Map<const Eigen::MatrixXd>;

/// Solutions of a body, from which later ones start. This one remembers none.
class SolutionMemory
{
public:
  virtual ~SolutionMemory() = default;

  /// Remembers a body under these forces (N) that the caller has found.
  virtual void remember(const NodeVector & /*force*/, const BodyPart &) {}

  /// To be called with the forces (N) of an accepted state. Of all that was remembered it keeps what comes
  /// from the last accepted states, and returns that. A new compliance of the same body whose memory gets it
  /// by restore() answers as this one does from then on, to the last bit. Empty where answers do not depend
  /// on earlier ones.
  virtual std::vector<Eigen::VectorXd> forget_trials(const NodeVector & /*force*/) { return {}; }
  virtual void restore(const std::vector<Eigen::VectorXd> &) {}
};

/// Compliance W (3 n x 3 n, mm/N) of an elastic body condensed to its n contact nodes: forces r of the
/// obstacle on the body (N) cause displacements W r of the contact nodes (mm). W is symmetric and positive
/// definite. A direction in which a node cannot move (a symmetry plane) has a compliance of its own, coupled
/// with nothing, so that it never carries a force. docs/theory.md, section 2. Sizes are asserted, not
/// checked. A body that is solved iteratively throws SolveError where it cannot be solved.
class Compliance
{
public:
  virtual ~Compliance() = default;

  /// n, the number of contact nodes.
  virtual Eigen::Index n_nodes() const = 0;

  /// displacement (mm) = W force (N), both of size 3 n_nodes().
  virtual void vmult(NodeVector &displacement, const NodeVector &force) const = 0;

  /// The part of W force that is known without long work: all of it, or a displacement and the forces (N)
  /// that the body lacks of its equilibrium then. Motions of a face are not included.
  virtual ContactChange approximate(const NodeVector &force) const;

  /// The contact forces (N) that hold a body whose free degrees of freedom have this displacement (mm), and
  /// what the body lacks then. Throws std::logic_error where there is no body.
  virtual ContactChange held_at(const Eigen::VectorXd &displacement) const;

  /// What answers start from where the body is solved iteratively: they differ by its content within their
  /// accuracy, and add to it.
  virtual SolutionMemory &memory() const;

  /// Norm (N) of the forces that the body lacks, BodyPart::residual, over all processes that have a part of
  /// it.
  virtual double norm(const Eigen::VectorXd &residual) const { return residual.norm(); }

  /// The 3 x 3 block of W of one node, mm/N.
  virtual Eigen::Matrix3d diagonal_block(Eigen::Index node) const = 0;

  /// W itself where the backend has it, else null.
  virtual const DenseView *dense() const { return nullptr; }

  /// The three entries of W force that belong to one node, mm.
  virtual Eigen::Vector3d displacement_at(Eigen::Index node, const NodeVector &force) const;

  /// Whether most nodes do not feel each other, so that a sweep over all costs little beside a factorization.
  virtual bool is_sparse() const { return false; }

  /// The compliance of the same body whose contact nodes hang on springs of this softness (mm/N), W +
  /// softness I. Its conditions are solved exactly. Null where W is not known.
  virtual std::unique_ptr<Compliance> on_springs(double softness) const;

  /// A solver of linearized contact laws where the backend has one, else null. `softness` is softness(). The
  /// solver must not outlive the compliance.
  virtual std::unique_ptr<ConditionSolver> condition_solver(double softness) const;

  /// Iterations of GMRES that its condition solvers have taken so far, each with a product of a half-space
  /// without a matrix; 0 with other compliances.
  virtual unsigned long n_gmres_iterations() const { return 0; }

  /// Largest eigenvalue of W (mm/N), estimated from below to about 0.1 %.
  virtual double softness() const;
};

/// Largest eigenvalue of a symmetric, positive definite matrix (3 n_nodes x 3 n_nodes) that is known by its
/// products. Lanczos' method approaches it from below until a product changes it by no more than the share
/// `settled`.
double largest_eigenvalue(Eigen::Index n_nodes, double settled,
                          const std::function<NodeVector(const NodeVector &)> &product);

/// Compliance stored as a dense matrix. It remembers the last product, because solver, report and results ask
/// for the same one. So only one thread at a time may use it.
class DenseCompliance : public Compliance
{
public:
  /// `matrix`: W, 3 n x 3 n, symmetric, mm/N.
  explicit DenseCompliance(Eigen::MatrixXd matrix);

  /// The same without a copy: the memory behind `view` must outlive the compliance and stay unchanged.
  explicit DenseCompliance(const DenseView &view);

  DenseCompliance(DenseCompliance &&) = default; // moved matrices keep their place
  DenseCompliance(const DenseCompliance &) = delete;

  Eigen::Index n_nodes() const override { return matrix_.rows() / 3; }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  const DenseView *dense() const override { return &matrix_; }
  Eigen::Vector3d displacement_at(Eigen::Index node, const NodeVector &force) const override;
  std::unique_ptr<Compliance> on_springs(double softness) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;

private:
  Eigen::MatrixXd own_{};
  DenseView matrix_;
  mutable NodeVector last_force_{};
  mutable NodeVector last_displacement_{};
};
} // namespace orthocone
