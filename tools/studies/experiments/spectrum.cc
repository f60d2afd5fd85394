// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <Eigen/Eigenvalues>

#include <iostream>

namespace orthocone::studies
{
namespace
{
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd symmetric_eigenvalues(const MatrixXd &matrix)
{
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

/// diag(1, Q^2) of the law at every node.
VectorXd weights(const OrthotropicFriction &law, const Eigen::Index n_nodes)
{
  const Eigen::Vector2d q = slip_weights(law);
  return Vector3d(1, q[0], q[1]).replicate(n_nodes, 1);
}
} // namespace

void spectrum(const Words &words)
{
  const SceneWords scene(words);
  const Scene model(scene.parameters, choose_model(scene.parameters));
  const ContactSystem &problem = model.system();
  const DenseView &w = *problem.compliance().dense();
  const Eigen::Index n = problem.n_nodes();
  const VectorXd of_w = symmetric_eigenvalues(w);
  // Box 3 while all stick: r <- r - rho C (q + W r) with the weights C of the literal p. C W is similar to a
  // symmetric matrix.
  VectorXd root = weights(*problem.law(0).ellipse(), n);
  for (Eigen::Index node = 0; node < n; ++node)
    root.segment<3>(3 * node) /= problem.compliance().diagonal_block(node).diagonal().minCoeff();
  root = root.cwiseSqrt();
  const VectorXd of_box3 = symmetric_eigenvalues(root.asDiagonal() * w * root.asDiagonal());
  // The scaled operator D C W D, of which the problem is the isotropic one with a coefficient of 1.
  const VectorXd d =
      Vector3d(1, problem.law(0).ellipse()->mu_x, problem.law(0).ellipse()->mu_y).replicate(n, 1);
  const MatrixXd scaled =
      d.cwiseProduct(weights(*problem.law(0).ellipse(), n)).asDiagonal() * w * d.asDiagonal();
  const VectorXd of_scaled = symmetric_eigenvalues(0.5 * (scaled + scaled.transpose()));
  std::cout << "contact_nodes,condition,box3_lambda,symmetric_least,symmetric_largest\n"
            << n << "," << of_w.maxCoeff() / of_w.minCoeff() << "," << of_box3.maxCoeff() << ","
            << of_scaled.minCoeff() << "," << of_scaled.maxCoeff() << "\n";
}
} // namespace orthocone::studies
