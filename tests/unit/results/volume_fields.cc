// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/volume_fields.h>

#include <gtest/gtest.h>

#include <set>

namespace orthocone::test
{
namespace
{
VolumeField field_named(const std::string &name)
{
  for (const VolumeField &field : volume_field_list())
    if (field.name == name)
      return field;
  throw std::logic_error("no field " + name);
}
} // namespace

TEST(VolumeFields, HaveNamesUnitsAndMeaningsOfTheirOwn)
{
  std::set<std::string> names;
  for (const VolumeField &field : volume_field_list())
  {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(std::string(field.unit).empty(), std::string(field.name) == "region") << field.name;
    EXPECT_NE(std::string(field.how), "") << field.name;
  }
}

// A bar under tension has the tension itself, equal pressure from all sides nothing, and pure shear sqrt(3)
// of the shear stress.
TEST(VolumeFields, KnowTheEquivalentStressOfSimpleStates)
{
  const VolumeField equivalent = field_named("von_mises_stress");
  PointFields tension, pressure, shear;
  tension.stress[0][0] = 3;
  for (unsigned int i = 0; i < 3; ++i)
    pressure.stress[i][i] = -5;
  shear.stress[0][2] = 2;
  EXPECT_NEAR(equivalent.value(tension)[0], 3, 1e-14);
  EXPECT_NEAR(equivalent.value(pressure)[0], 0, 1e-14);
  EXPECT_NEAR(equivalent.value(shear)[0], 2 * std::sqrt(3), 1e-14);
}

// A shear of 2 MPa is a tension and a pressure of 2 MPa.
TEST(VolumeFields, HaveThePrincipalStressesInOrder)
{
  PointFields point;
  point.stress[1][2] = 2;
  point.stress[0][0] = 1;
  for (const auto &[name, value] : {std::pair("principal_stress_1", 2.), std::pair("principal_stress_2", 1.),
                                    std::pair("principal_stress_3", -2.)})
    EXPECT_NEAR(field_named(name).value(point)[0], value, 1e-14);
}

TEST(VolumeFields, HaveTheirComponentsInOrder)
{
  PointFields point;
  point.displacement = {1, 2, 3};
  point.stress[0][1] = 4;
  point.stress[2][2] = 5;
  const auto displacement = field_named("displacement").value(point);
  const auto stress = field_named("stress").value(point);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_EQ(displacement[i], i + 1);
  for (unsigned int i = 0; i < 9; ++i)
    EXPECT_EQ(stress[i], i == 1 || i == 3 ? 4 : i == 8 ? 5 : 0) << i;
}
} // namespace orthocone::test
