// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: a field of the contact files is one value of type ContactField, a line
// of contact_field_list() in source/results/contact_fields.cc.
#include "results/scenes.h"

namespace orthocone::test
{
namespace
{
/// The angle between slip and friction force, which a slip rule other than the cone's own opens.
double slip_angle(const ContactFields &fields)
{
  const Eigen::Vector2d slip = fields.slip.head<2>(), friction = fields.friction_traction.head<2>();
  const double along = -slip.dot(friction), across = slip[0] * friction[1] - slip[1] * friction[0];
  return slip.norm() > 0 && friction.norm() > 0 ? std::abs(std::atan2(across, along)) : 0;
}

const ContactField field{"slip_angle", "rad", "between slip and the reversed friction", slip_angle};
} // namespace

// Where all slips along (3, 4) with a circle as slip ellipse, friction is along the slip.
TEST(ExampleField, IsZeroWhereSlipIsCollinear)
{
  Parameters parameters = small_scene();
  parameters.friction.slip_potential = std::array<double, 2>{{1, 1}};
  parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(0.6, 0.8, -0.01, 1)};
  TestScene collinear(parameters);
  collinear.march();
  parameters.friction.slip_potential = std::nullopt;
  TestScene associated(parameters);
  associated.march();
  double largest = 0;
  for (const ContactFields &fields : collinear.evaluator.all_fields(collinear.state))
    if (fields.status == NodeStatus::slip)
    {
      EXPECT_LT(field.value(fields)[0], 0.02);
    }
  for (const ContactFields &fields : associated.evaluator.all_fields(associated.state))
    if (fields.status == NodeStatus::slip)
      largest = std::max(largest, field.value(fields)[0]);
  EXPECT_GT(largest, 0.3) << "atan(4/3) - atan(4/3 / 4) = 0.6 for mu = (0.3, 0.15)";
  EXPECT_EQ(field.n_components(), 1u);
}
} // namespace orthocone::test
