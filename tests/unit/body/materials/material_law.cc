// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material_law.h>

#include "rejection.h"

#include <orthocone/body/materials/material.h>
#include <orthocone/body/materials/orthotropic_law.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
/// A law that gives its tangent alone: that of fibres along (cos a, sin a, 0).
class Fibres : public MaterialLaw
{
public:
  explicit Fibres(const double angle, const double stiffness = 5)
      : angle_(angle),
        stiffness_(stiffness)
  {
  }
  std::unique_ptr<MaterialLaw> clone() const override { return std::make_unique<Fibres>(*this); }
  std::optional<ElasticTangent> tangent() const override
  {
    Strain along;
    along[0][0] = std::cos(angle_) * std::cos(angle_);
    along[1][1] = std::sin(angle_) * std::sin(angle_);
    along[0][1] = std::sin(angle_) * std::cos(angle_);
    return 2 * dealii::identity_tensor<3>() + stiffness_ * outer_product(along, along);
  }

private:
  double angle_, stiffness_;
};

/// Why a material of these fibres does not have a symmetry.
std::string asymmetry_of_fibres(const double angle, const ModelSymmetry &symmetry)
{
  auto &kinds = kinds_of<MaterialLaw>();
  kinds.push_back({"fibres", "", [=] { return std::make_unique<Fibres>(angle); }});
  MaterialOptions options;
  options.law = "fibres";
  const std::string why = Material(options).asymmetry(symmetry);
  kinds.pop_back();
  return why;
}
} // namespace

TEST(MaterialLaw, HasTheAverageOfItsTangent)
{
  OrthotropicLaw law;
  law.young_moduli = {{100, 50, 2000}};
  law.poisson_ratios = {{0.3, 0.05, 0.01}};
  law.shear_moduli = {{11, 1200, 13}};
  const IsotropicConstants expected = law.average(), found = law.MaterialLaw::average();
  EXPECT_NEAR(found.young_modulus, expected.young_modulus, 1e-12 * expected.young_modulus);
  EXPECT_NEAR(found.poisson_ratio, expected.poisson_ratio, 1e-12);
}

TEST(MaterialLaw, StoresEnergy)
{
  const MaterialOptions options;
  EXPECT_EQ(rejection_of([&] { Fibres(0.3, -1.99).check(options); }), "");
  EXPECT_NE(rejection_of([&] { Fibres(0.3, -2.01).check(options); }).find("stiffness, now -0.0"),
            std::string::npos);
  for (const double poisson : {-0.99, 0.49})
  {
    OrthotropicLaw law;
    law.poisson_ratios.fill(poisson);
    EXPECT_EQ(rejection_of([&] { law.MaterialLaw::check(options); }), "");
    law.poisson_ratios.fill(0.51);
    EXPECT_NE(rejection_of([&] { law.MaterialLaw::check(options); }), "");
  }
}

TEST(MaterialLaw, IsSymmetricAboutItsAxesAlone)
{
  const ModelSymmetry of_four(SymmetryPlanes{true, true}), of_two(SymmetryPlanes{false, true}), of_one;
  for (const double angle : {0., M_PI / 2})
    for (const ModelSymmetry &symmetry : {of_four, of_two, of_one})
      EXPECT_EQ(asymmetry_of_fibres(angle, symmetry), "");
  EXPECT_EQ(asymmetry_of_fibres(0.3, of_four), "Material/Law = fibres has other axes than x, y and z");
  EXPECT_NE(asymmetry_of_fibres(0.3, of_two), "");
  EXPECT_EQ(asymmetry_of_fibres(0.3, of_one), "");
  EXPECT_EQ(asymmetry_of_fibres(0, ModelSymmetry::of_revolution()),
            "Material/Law = fibres has axes along x and y");
}
} // namespace orthocone::test
