// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "body/bodies.h"
#include "body/even_mesh.h"
#include "body/mpi.h"
#include "multigrid/elastic_solver.h"
#include "multigrid/whole_body_conditions.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <random>

namespace orthocone::test
{
inline GeometryOptions shape_of(const BodyShape shape)
{
  GeometryOptions geometry;
  geometry.shape = shape;
  return geometry;
}

/// A body by both backends.
struct RefinedBody
{
  RefinedBody(const GeometryOptions &geometry, const MeshOptions &mesh, const SymmetryPlanes &planes,
              const LocalAxes &axes = LocalAxes(0), const CoarseMethod on_coarsest = CoarseMethod::by_size,
              const MaterialOptions &material = default_material)
      : body((start_mpi(), geometry), mesh, material, planes, axes),
        stiffness(body.discretization, material),
        cycle(body.discretization, mesh, geometry, material, on_coarsest),
        elastic(stiffness, cycle)
  {
  }

  const std::vector<ContactNode> &nodes() const { return body.discretization.contact_surface().nodes; }

  BodyVector<double> all(const Eigen::VectorXd &free) const
  {
    BodyVector<double> vector = stiffness.make_vector();
    std::copy(free.begin(), free.end(), vector.begin());
    return vector;
  }
  Eigen::VectorXd free(const BodyVector<double> &vector) const
  {
    return Eigen::Map<const Eigen::VectorXd>(vector.begin(), body.discretization.n_free());
  }

  LoadableBody body;
  MatrixFreeStiffness<double> stiffness;
  VCycle cycle;
  ElasticSolver elastic;
};

/// Forces of a pressed base.
inline BodyVector<double> pressed_base(const RefinedBody &refined)
{
  NodeVector pressure = NodeVector::Zero(3 * static_cast<Eigen::Index>(refined.nodes().size()));
  for (std::size_t i = 0; i < refined.nodes().size(); ++i)
    pressure[3 * static_cast<Eigen::Index>(i)] = refined.nodes()[i].area;
  return refined.all(refined.body.condensed.frame().on_free_unknowns(pressure));
}

/// Iterations of conjugate gradients to eight digits; one more than `most` if those are not enough.
inline unsigned int iterations(const MatrixFreeStiffness<double> &stiffness, const VCycle &cycle,
                               const BodyVector<double> &forces, const unsigned int most)
{
  BodyVector<double> displacement = stiffness.make_vector();
  dealii::SolverControl control(most, 1e-8 * forces.l2_norm(), false, false);
  dealii::SolverCG<BodyVector<double>> cg(control);
  try
  {
    cg.solve(stiffness, displacement, forces, cycle);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    return most + 1;
  }
  return control.last_step();
}

inline unsigned int iterations(const RefinedBody &refined, const BodyVector<double> &forces,
                               const unsigned int most)
{
  return iterations(refined.stiffness, refined.cycle, forces, most);
}

/// Numbers from -1 to 1, the same in every run.
inline Eigen::VectorXd random_numbers(const Eigen::Index n, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return number(generator); });
}

constexpr double node_stiffness = 1e5; // N/mm, as large as a node's own

/// A third of the nodes open, a third stuck, a third slipping, with all that friction couples.
inline std::vector<NodeCondition> mixed_conditions(const RefinedBody &refined, const double stiffness)
{
  std::vector<NodeCondition> conditions;
  for (std::size_t i = 0; i < refined.nodes().size(); ++i)
  {
    const Eigen::VectorXd random = random_numbers(9, 7 + static_cast<unsigned int>(i));
    const bool is_on_plane = !refined.nodes()[i].is_free[0] || !refined.nodes()[i].is_free[1];
    NodeCondition condition;
    condition.n_unknowns = std::array<int, 3>{{0, 3, 2}}[is_on_plane ? i % 2 : i % 3];
    if (condition.n_unknowns == 0)
      condition.fixed = random.head<3>();
    if (condition.n_unknowns == 3)
    {
      condition.basis.setIdentity();
      condition.rows =
          stiffness * (Eigen::Matrix3d::Identity() + 0.1 * random.replicate<1, 3>().topRows<3>());
      condition.right_side = random.tail<3>();
    }
    if (condition.n_unknowns == 2)
    {
      condition.basis.col(0) = Eigen::Vector3d(1, 0.3 * random[0], 0.3 * random[1]).normalized();
      condition.basis.col(1) =
          condition.basis.col(0).cross(Eigen::Vector3d(0.1, random[2], 1).normalized()).normalized();
      condition.rows.col(0) = stiffness * (condition.basis.col(0) + 0.05 * random.segment<3>(3));
      condition.rows.col(1) = 0.4 * stiffness * (condition.basis.col(1) + 0.05 * random.segment<3>(5));
      condition.diagonal[1] = 0.6;
      condition.right_side.head<2>() = random.segment<2>(6);
      condition.fixed = 0.2 * condition.basis.col(0).cross(condition.basis.col(1));
    }
    for (unsigned int d = 0; d < 2; ++d) // nothing happens across a plane of symmetry
      if (!refined.nodes()[i].is_free[d])
        condition.fixed[d + 1] = condition.right_side[d + 1] = 0;
    conditions.push_back(condition);
  }
  return conditions;
}

/// Unknowns of a node's condition that give the change of force, and what is left of it.
inline std::pair<Eigen::Vector3d, double> unknowns_of(const NodeCondition &condition,
                                                      const Eigen::Vector3d &force)
{
  const Eigen::Vector3d x = condition.basis.transpose() * (force - condition.fixed);
  Eigen::Vector3d force_given = condition.fixed;
  force_given += condition.basis.leftCols(condition.n_unknowns) * x.head(condition.n_unknowns);
  return {x, (force - force_given).norm()};
}

/// Largest error of the nodes' equations, N, with the displacements that the compliance makes of the forces.
inline double error_of(const ContactConditions &conditions, const ContactChange &change,
                       const Compliance &compliance)
{
  NodeVector moved;
  compliance.vmult(moved, change.force);
  if (conditions.face.cols() > 0)
    moved += conditions.face * change.face;
  double error = (moved - change.displacement).norm() * node_stiffness;
  for (std::size_t i = 0; i < conditions.nodes.size(); ++i)
  {
    const NodeCondition &condition = conditions.nodes[i];
    const auto place = 3 * static_cast<Eigen::Index>(i);
    const auto [x, left] = unknowns_of(condition, change.force.segment<3>(place));
    error = std::max(error, left);
    for (Eigen::Index k = 0; k < condition.n_unknowns; ++k)
      error = std::max(error, std::abs(condition.rows.col(k).dot(moved.segment<3>(place)) +
                                       condition.diagonal[k] * x[k] - condition.right_side[k]));
  }
  return error;
}
} // namespace orthocone::test
