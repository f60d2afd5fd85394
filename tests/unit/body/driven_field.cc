// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What the held face does to a body whose supports do not follow it.
#include "body/bodies.h"

#include <orthocone/body/backends/factorized_body.h>

#include <gtest/gtest.h>

#include <set>

namespace orthocone::test
{
namespace
{
/// A whole box of 4 x 3 x 2 mm with these supports.
struct SupportedBox
{
  explicit SupportedBox(const std::vector<Support> &supports)
      : options(with(supports)),
        body(
            options, ModelSymmetry(), [](const ContactSurface &) { return LocalAxes(0.3); },
            [](const Body &) {}, seconds)
  {
  }

  static BodyOptions with(const std::vector<Support> &supports)
  {
    BodyOptions options;
    options.geometry.shape = BodyShape::box;
    options.geometry.sizes = {{4, 3, 2}};
    options.geometry.supports = supports;
    options.mesh.cells = {{4, 3, 2}};
    options.mesh.degree = 2;
    options.mesh.volumetric_quadrature = VolumetricQuadrature::full; // as the other assembly
    return options;
  }

  const BodyOptions options;
  PhaseSeconds seconds;
  const FactorizedBody body;
};
} // namespace

// The field of each motion, by an assembly that is not the program's: at rest on the supports, rigid at the
// held face, and in equilibrium elsewhere. Its energies are the stiffness between both.
TEST(DrivenField, IsInEquilibrium)
{
  const SupportedBox box({{"x+", {{true, false, true}}}, {"y-", {{true, true, true}}}});
  const FactorizedBody &body = box.body;
  const Discretization &space = body.mesh().solid();
  const LameParameters lame(box.options.material);
  ASSERT_NE(body.driven(), nullptr);
  Eigen::MatrixXd fields(space.n_dofs(), n_rigid_components), forces = fields;
  for (unsigned int j = 0; j < n_rigid_components; ++j)
  {
    RigidMotion unit;
    unit[j] = 1;
    fields.col(j) = body.with_motion(unit, Eigen::VectorXd::Zero(space.n_free()));
    forces.col(j) = internal_forces(
        space,
        [&](const dealii::FEValues<3> &values, const unsigned int q)
        { return stress_of(strains_in_cell(values, space.dof_handler(), fields.col(j))[q], lame); },
        3);
    const std::set<unsigned int> supported(space.supported().begin(), space.supported().end());
    EXPECT_LE(forces.col(j).head(space.n_free()).norm(), 1e-10 * forces.col(j).norm());
    for (unsigned int dof = space.n_free(); dof < space.n_owned(); ++dof)
      EXPECT_NEAR(fields(dof, j),
                  supported.count(dof) > 0
                      ? 0
                      : unit.at(space.position(dof) - space.held_centre())[space.direction(dof)],
                  1e-12);
  }
  const Eigen::MatrixXd energies = fields.transpose() * forces;
  EXPECT_GT(energies.norm(), 1);
  EXPECT_LE((energies - body.driven()->conjugates).norm(), 1e-10 * energies.norm());
}

// Betti: the work of contact forces on the displacement by a motion of the face is that of the wrench by
// which the face keeps its place under these forces, taken from the reactions of an independent assembly.
TEST(DrivenField, KeepsReciprocity)
{
  const SupportedBox box({{"x+", {{true, false, false}}}, {"y-", {{true, true, true}}}});
  const FactorizedBody &body = box.body;
  const Discretization &space = body.mesh().solid();
  const LameParameters lame(box.options.material);
  const NodeVector force = uneven_forces(static_cast<Eigen::Index>(body.surface().nodes.size()));
  const Eigen::VectorXd u = body.with_motion({}, body.elastic_displacement(force));
  const Eigen::VectorXd reactions = internal_forces(
      space,
      [&](const dealii::FEValues<3> &values, const unsigned int q)
      { return stress_of(strains_in_cell(values, space.dof_handler(), u)[q], lame); },
      3);
  const std::set<unsigned int> supported(space.supported().begin(), space.supported().end());
  Wrench face;
  for (unsigned int dof = space.n_free(); dof < space.n_owned(); ++dof)
    if (supported.count(dof) == 0)
    {
      Eigen::Vector3d reaction = Eigen::Vector3d::Zero();
      reaction[space.direction(dof)] = reactions[dof];
      face.add(reaction, space.position(dof) - space.held_centre());
    }
  const Wrench wrench = body.wrench(force); // which the face balances
  EXPECT_LE((wrench.components + face.components).norm(), 1e-10 * face.components.norm());
}

// Supports that a motion does not meet leave the body as rigid as without them.
TEST(DrivenField, VanishesAlongARoller)
{
  const SupportedBox box({{"x+", {{true, false, false}}}});
  const DrivenField &field = *box.body.driven();
  for (const unsigned int along : {1, 2})
  {
    EXPECT_EQ(field.volume.col(along).norm(), 0);
    EXPECT_EQ(field.conjugates.col(along).norm(), 0);
  }
  EXPECT_GT(field.conjugates(0, 0), 0);
}
} // namespace orthocone::test
