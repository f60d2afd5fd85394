// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "refined_body.h"

#include "multigrid/coarse_solver.h"
#include "multigrid/held_stiffness.h"
#include "multigrid/node_stiffness.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::VectorXd;

namespace
{

/// As mixed_conditions(), except for `follows`, which is not transferred to the levels.
std::vector<NodeRelation> mixed_relations(const RefinedBody &refined)
{
  std::vector<NodeRelation> relations;
  const std::vector<NodeCondition> conditions = mixed_conditions(refined, node_stiffness);
  for (std::size_t i = 0; i < conditions.size(); ++i)
  {
    relations.push_back(
        relation_of(conditions[i], Eigen::Matrix3d(LocalAxes(0).global_in_local(i)), refined.nodes()[i]));
    relations.back().follows.setZero();
  }
  return relations;
}

/// That the matrix makes these forces of the displacement, to the relative accuracy.
template<typename Number>
void expect_product(const NodeStiffness &stiffness, const NodeStiffness::Matrix &matrix,
                    const BodyVector<Number> &displacement, const BodyVector<Number> &forces,
                    const double accuracy)
{
  dealii::Vector<double> by_node(stiffness.n_rows()), image(stiffness.n_rows());
  for (unsigned int dof = 0; dof < stiffness.n_rows(); ++dof)
    by_node[stiffness.row(dof)] = displacement.local_element(dof);
  matrix.vmult(image, by_node);
  for (unsigned int dof = 0; dof < stiffness.n_rows(); ++dof)
    ASSERT_NEAR(image[stiffness.row(dof)], forces.local_element(dof), accuracy * forces.l2_norm());
}

/// Cells that are nearly cubes, none of which is halved.
MeshOptions cells_without_hierarchy(const unsigned int degree, const unsigned int n)
{
  MeshOptions mesh = even_mesh(degree, 0);
  mesh.core_cells = 2 * n;
  mesh.rings = n;
  mesh.layers = 2 * n;
  return mesh;
}
} // namespace

/// What a factorization solves is solved exactly, with whatever contact holds there: six cells, and
/// thousands.
TEST(FactorizedCoarse, IsExact)
{
  for (const MeshOptions &mesh : {even_mesh(1, 0), cells_without_hierarchy(1, 7)})
  {
    RefinedBody refined(default_geometry, mesh, quarter, LocalAxes(0), CoarseMethod::factorized);
    const std::vector<NodeRelation> relations = mixed_relations(refined);
    refined.cycle.hold(relations);
    const HeldStiffness held(refined.stiffness, refined.nodes(), relations);
    const auto right_side = held.right_side(refined.stiffness.make_vector(),
                                            random_numbers(refined.body.discretization.n_free(), 3));
    BodyVector<double> solution = refined.stiffness.make_vector(), image = solution;
    refined.cycle.vmult(solution, right_side);
    held.vmult(image, solution);
    image -= right_side;
    EXPECT_LE(image.l2_norm(), 1e-5 * right_side.l2_norm()); // vectors of the levels are in single precision
  }
}

/// The assembled matrix is what the products cell by cell make, where contact holds nothing and where it
/// does.
TEST(NodeStiffness, MultipliesAsProductsCellByCell)
{
  const RefinedBody refined(default_geometry, even_mesh(2, 0), quarter);
  const Discretization &space = refined.body.discretization;
  NodeStiffness stiffness(space, default_material);
  NodeStiffness::Matrix matrix;
  for (const std::vector<NodeRelation> &relations :
       {std::vector<NodeRelation>(refined.nodes().size()), mixed_relations(refined)})
  {
    stiffness.hold(relations, matrix);
    const HeldStiffness held(refined.stiffness, refined.nodes(), relations);
    BodyVector<double> displacement = refined.all(random_numbers(space.n_free(), 3)), forces = displacement;
    for (std::size_t i = 0; i < relations.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        if (relations[i].hold == Hold::all || (relations[i].hold == Hold::normal && d == 2))
          displacement.local_element(refined.nodes()[i].dofs[d]) = 0;
    held.vmult(forces, displacement);
    expect_product(stiffness, matrix, displacement, forces, 1e-12);
  }
}

/// The same as the levels where friction resists more than any preconditioner bears.
TEST(NodeStiffness, BoundsFrictionAsLevelsDo)
{
  const RefinedBody refined(default_geometry, even_mesh(1, 1), quarter);
  const Discretization &space = refined.body.discretization;
  std::vector<NodeRelation> relations = mixed_relations(refined);
  for (NodeRelation &relation : relations)
    relation.robin *= 1e7;
  Level level(space, default_material);
  level.hold(relations);
  NodeStiffness stiffness(space, default_material);
  NodeStiffness::Matrix matrix;
  stiffness.hold(relations, matrix);
  Level::Vector displacement = level.make_vector(), forces = displacement;
  displacement = refined.all(random_numbers(space.n_free(), 3));
  level.clear_held(displacement);
  level.vmult(forces, displacement);
  expect_product(stiffness, matrix, displacement, forces, 1e-6); // single precision
}

/// The stiffness does no work on a rigid motion, but by what holds the face.
TEST(NodeStiffness, KnowsRigidMotions)
{
  const RefinedBody refined(default_geometry, even_mesh(1, 1), full);
  const NodeStiffness stiffness(refined.body.discretization, default_material);
  const std::vector<double> motions = stiffness.rigid_motions();
  const auto positions = dof_positions(refined.body.discretization);
  const double below = default_geometry.height / 2 - 1e-9; // no cell here borders on the held face
  for (int motion = 0; motion < NodeStiffness::n_rigid_motions; ++motion)
  {
    dealii::Vector<double> displacement(stiffness.n_rows()), forces(stiffness.n_rows());
    for (unsigned int row = 0; row < stiffness.n_rows(); ++row)
      displacement[row] = motions[static_cast<std::size_t>(motion) * stiffness.n_rows() + row];
    stiffness.free().vmult(forces, displacement);
    for (unsigned int dof = 0; dof < refined.body.discretization.n_free(); ++dof)
    {
      const double force = positions[dof][2] < below ? forces[stiffness.row(dof)] : 0;
      EXPECT_NEAR(force, 0, 1e-10 * displacement.l2_norm() * node_stiffness);
    }
  }
}

/// Cells that no coarser ones are known of, thousands of trilinear ones.
TEST(AlgebraicCoarse, DoesWithoutCoarserMeshes)
{
  constexpr unsigned int most_iterations = 13;
  for (const auto &[degree, n] : {std::pair{1U, 8U}, {2U, 4U}})
  {
    const RefinedBody refined(default_geometry, cells_without_hierarchy(degree, n), quarter, LocalAxes(0),
                              CoarseMethod::algebraic);
    EXPECT_EQ(refined.body.discretization.size().cells, 6 * n * n * n);
    EXPECT_LE(iterations(refined, pressed_base(refined), most_iterations), most_iterations) << degree;
  }
}

/// Without a factorization of the finest stiffness, which such a body has no memory for elsewhere.
TEST(CoarseSolver, TakesThousandsOfQuadraticCells)
{
  start_mpi();
  constexpr unsigned int most_iterations = 13, n = 7;
  const MeshOptions options = cells_without_hierarchy(2, n);
  const BodyMesh mesh(default_geometry, options, quarter);
  const Discretization space(mesh.triangulation(), options, default_geometry.top_face);
  EXPECT_EQ(space.size().cells, 6 * n * n * n);
  const MatrixFreeStiffness<double> stiffness(space, default_material);
  BodyVector<double> forces = stiffness.make_vector();
  const VectorXd random = random_numbers(space.n_free(), 3);
  std::copy(random.begin(), random.end(), forces.begin());
  for (const CoarseMethod method : {CoarseMethod::factorized, CoarseMethod::algebraic})
  {
    const VCycle cycle(space, options, default_geometry, default_material, method);
    EXPECT_LE(iterations(stiffness, cycle, forces, most_iterations), most_iterations);
  }
}

/// Contact holds nodes on the coarsest mesh, too: without that, 19 and 21 V-cycles.
TEST(AlgebraicCoarse, KnowsWhatContactHolds)
{
  for (const auto &[degree, most_cycles] : {std::pair{1U, 13U}, {2U, 17U}})
  {
    const RefinedBody refined(default_geometry, cells_without_hierarchy(degree, degree == 1 ? 8 : 4), quarter,
                              LocalAxes(0), CoarseMethod::algebraic);
    const WholeBodyConditions solver(refined.body.condensed.frame(), refined.stiffness,
                                     const_cast<VCycle &>(refined.cycle));
    const unsigned long before = refined.cycle.n_cycles();
    solver.solve({mixed_conditions(refined, node_stiffness), {}, {}}, 1e-8);
    EXPECT_LE(refined.cycle.n_cycles() - before, most_cycles) << degree;
  }
}

/// A run that goes on builds its hierarchy anew, after fewer others: it must be the same, to the last bit.
TEST(AlgebraicCoarse, IsTheSameWhenMadeAgain)
{
  const RefinedBody refined(default_geometry, cells_without_hierarchy(1, 6), quarter);
  const VectorXd forces = random_numbers(refined.body.discretization.n_free(), 3);
  const auto first =
      make_coarse_solver(refined.body.discretization, default_material, CoarseMethod::algebraic);
  const VectorXd expected = first->solve(forces);
  first->hold(mixed_relations(refined));
  const VectorXd held = first->solve(forces);
  EXPECT_NE(held, expected);
  const auto second =
      make_coarse_solver(refined.body.discretization, default_material, CoarseMethod::algebraic);
  second->hold(mixed_relations(refined));
  EXPECT_EQ(second->solve(forces), held);
  second->hold({});
  EXPECT_EQ(second->solve(forces), expected);
}

/// Nodes that are all open are held by nothing.
TEST(AlgebraicCoarse, IsFreeWhereNothingIsHeld)
{
  const RefinedBody refined(default_geometry, cells_without_hierarchy(1, 4), quarter);
  const VectorXd forces = random_numbers(refined.body.discretization.n_free(), 3);
  const auto coarse =
      make_coarse_solver(refined.body.discretization, default_material, CoarseMethod::algebraic);
  const VectorXd expected = coarse->solve(forces);
  coarse->hold(std::vector<NodeRelation>(refined.nodes().size()));
  EXPECT_EQ(coarse->solve(forces), expected);
}
} // namespace orthocone::test
