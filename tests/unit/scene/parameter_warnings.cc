// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries/parsed.h"

#include <orthocone/base/text.h>
#include <orthocone/body/materials/orthotropic_law.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/scene/half_space_obstacle.h>
#include <orthocone/scene/legs.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace orthocone::test
{
namespace
{
/// Whether the defaults with this change have just one warning, which begins with `entry`.
bool warned(const std::function<void(Parameters &)> &change, const std::string &entry)
{
  Parameters parameters;
  change(parameters);
  const auto warnings = parameter_warnings(parameters);
  return warnings.size() == 1 && warnings.front().compare(0, entry.size(), entry) == 0;
}
} // namespace

TEST(Warnings, AreGivenForWhatIsLegalButSuspicious)
{
  EXPECT_TRUE(parameter_warnings(Parameters()).empty());
  EXPECT_TRUE(warned(
      [](Parameters &p) {
        p.friction.slip_potential = std::array<double, 2>{{1, 20.1}};
      },
      "Friction/Slip potential"));
  EXPECT_TRUE(warned(
      [](Parameters &p) {
        p.friction.slip_potential = std::array<double, 2>{{20.1, 1}};
      },
      "Friction/Slip potential"));
  EXPECT_FALSE(warned(
      [](Parameters &p) {
        p.friction.slip_potential = std::array<double, 2>{{20, 1}};
      },
      "Friction"));
  EXPECT_TRUE(warned([](Parameters &p) { p.load.legs = {move_to(0, 0, -0.51, 1)}; }, "Load program"));
  // The body shears only as far as friction holds it.
  const auto sideways = [](const double mu, const double motion)
  {
    return [=](Parameters &p)
    {
      p.friction.mu = {{mu, mu}};
      p.load.legs = {move_to(motion, -motion, -0.1, 1)};
    };
  };
  EXPECT_TRUE(warned(sideways(3, 0.4), "Load program: |u_t|"));
  EXPECT_FALSE(warned(sideways(3, 0.3), "Load program"));
  EXPECT_FALSE(warned(sideways(0.3, 0.4), "Load program"));
}

TEST(Warnings, AreGivenForElementsThatDoNotResolveTheRimOrLock)
{
  EXPECT_TRUE(warned([](Parameters &p) { p.mesh.degree = 1; }, "Mesh"));
  // A mesh of linear elements that resolves the rim, of a material that it locks for.
  const auto fine = [](Parameters &p)
  {
    p.mesh.degree = 1;
    p.mesh.layers = 16;
    p.mesh.layer_grading = 0.7;
    p.mesh.rim_grading = 0.7;
  };
  EXPECT_FALSE(warned(fine, "Mesh"));
  EXPECT_TRUE(warned(
      [&](Parameters &p)
      {
        fine(p);
        p.material.poisson_ratio = 0.495;
      },
      "Material/Poisson ratio"));
  const auto with = [&](const unsigned int degree, const VolumetricQuadrature quadrature)
  {
    return [=](Parameters &p)
    {
      fine(p);
      p.mesh.degree = degree;
      p.mesh.volumetric_quadrature = quadrature;
      p.material.regions = {{"seal", 5, 0.495}};
    };
  };
  const std::string of_region = "Material/Regions: a Poisson ratio of 0.495 with Mesh/Degree = ";
  for (const unsigned int degree : {1, 2, 3})
  {
    EXPECT_TRUE(warned(with(degree, VolumetricQuadrature::full), of_region));
    EXPECT_FALSE(warned(with(degree, VolumetricQuadrature::projected), of_region));
    EXPECT_EQ(warned(with(degree, VolumetricQuadrature::automatic), of_region), degree == 1);
  }
}

// Nine constants of an isotropic material are that material.
TEST(Warnings, TakeOrthotropicMaterialsByTheirAverage)
{
  const auto orthotropic = [](const double poisson)
  {
    return [=](Parameters &p)
    {
      auto &law = p.material.law.choose<OrthotropicLaw>();
      law.young_moduli = {{70, 70, 70}};
      law.poisson_ratios = {{poisson, poisson, poisson}};
      const double shear = 70 / (2 * (1 + poisson));
      law.shear_moduli = {{shear, shear, shear}};
      p.mesh.volumetric_quadrature = VolumetricQuadrature::full;
    };
  };
  EXPECT_TRUE(warned(orthotropic(0.495), "Material/Poisson ratios, on average 0.495"));
  EXPECT_FALSE(warned(orthotropic(0.4), "Material/Poisson ratios"));
}

TEST(Warnings, AreGivenForALoadProgramThatNeverPresses)
{
  const std::string warning = "Load program: no leg has u_z < 0";
  EXPECT_TRUE(warned(
      [](Parameters &p) {
        p.load.legs = {move_to(0.1, 0, 0, 1), move_to(0, 0, 0.1, 1)};
      },
      warning));
  EXPECT_FALSE(warned(
      [](Parameters &p) {
        p.load.legs = {move_to(0, 0, 0, 1), move_to(0, 0, -1e-6, 1)};
      },
      warning));
  const auto preloaded = [](Parameters &p)
  {
    p.load.preload = {move_to(0, 0, -0.1, 1)};
    p.load.legs = {move_to(0.1, 0, 0, 1)};
  };
  EXPECT_FALSE(warned(preloaded, warning));
  // Legs that are passed through no time do not press.
  const auto no_cycle = [](Parameters &p)
  {
    p.load.preload = {move_to(0.1, 0, 0, 1)};
    p.load.cycles = 0;
  };
  EXPECT_TRUE(warned(no_cycle, warning));
}

TEST(Warnings, CountForcesAndTiltsAsPressing)
{
  const auto has_no_contact = [](const char *const legs)
  {
    return warned([&](Parameters &p) { p.load.legs = *parsed(legs_codec(), legs); },
                  "Load program: no leg has u_z < 0");
  };
  EXPECT_FALSE(has_no_contact("Fz -100 : 1"));
  EXPECT_FALSE(has_no_contact("rx 0.1 : 1"));
  EXPECT_TRUE(has_no_contact("Fz 100 : 1"));
  EXPECT_TRUE(has_no_contact("Fx 100 : 1; rz 0.5 : 1"));
}

TEST(Warnings, KeepComponentsUntilALegNamesThemAgain)
{
  const auto has_shear = [](const char *const legs)
  {
    return warned(
        [&](Parameters &p)
        {
          p.friction.mu = {{3, 3}};
          p.load.cycles = 2;
          p.load.legs = *parsed(legs_codec(), legs);
        },
        "Load program: |u_t|");
  };
  EXPECT_TRUE(has_shear("uz -0.1 : 1; ux 0.4 : 1; uy 0.4 : 1")) << "0.57 mm";
  EXPECT_FALSE(has_shear("uz -0.1 uy 0 : 1; ux 0.4 : 1; ux 0 uy 0.4 : 1"));
  EXPECT_TRUE(has_shear("uz -0.1 : 1; uy 0.4 : 1; ux 0.4 uy 0 : 1")) << "in the second cycle";
}

TEST(Warnings, AreGivenForAHalfSpaceThatIsNone)
{
  const std::string warning = "Obstacle/Young modulus = 70000 is ignored with Obstacle/Kind = rigid";
  for (const ObstacleKind kind : {ObstacleKind::rigid, ObstacleKind::half_space})
    EXPECT_EQ(warned(
                  [&](Parameters &p)
                  {
                    p.obstacle.kind.choose<HalfSpaceKind>().half_space.young_modulus = 70000;
                    p.obstacle.kind = kind;
                  },
                  warning),
              kind.word == ObstacleKind::rigid.word);
}

TEST(Warnings, AreGivenForLargeRotations)
{
  const auto is_large = [](const char *const legs)
  {
    return warned([&](Parameters &p) { p.load.legs = *parsed(legs_codec(), legs); },
                  "Load program: rotations up to 1.5");
  };
  EXPECT_TRUE(is_large("uz -0.1 : 1; ry -1.5 : 1"));
  EXPECT_FALSE(is_large("uz -0.1 : 1; rz 1 : 1; Mz 1e6 : 1"));
}

namespace
{
bool is_warned_of(const ContactSolverOptions &solver, const std::string &warning)
{
  Parameters parameters;
  parameters.contact_solver = solver;
  const auto warnings = parameter_warnings(parameters);
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string &text) { return text.find(warning) != std::string::npos; });
}

std::vector<std::string> all_methods()
{
  std::vector<std::string> words;
  for (const ContactMethod &method : contact_methods())
    words.emplace_back(method.word);
  return words;
}
} // namespace

TEST(Warnings, AreGivenForARelaxationThatTheMethodIgnores)
{
  const std::string warning = "Contact solver/Relaxation = 1.2 is ignored";
  for (const std::string &method : all_methods())
    for (const double relaxation : {1., 1.2})
      EXPECT_EQ(is_warned_of({method, 1e-10, 5000, relaxation}, warning),
                method != "gauss-seidel" && relaxation != 1)
          << method;
}

TEST(Warnings, AreGivenForARhoThatTheMethodIgnores)
{
  const std::string warning = "Contact solver/Rho factor = 0.5 is ignored";
  for (const std::string &method : all_methods())
    for (const double factor : {1., 0.5})
      EXPECT_EQ(is_warned_of({method, 1e-10, 5000, 1, factor}, warning),
                (method == "gauss-seidel" || method == "uzawa") && factor != 1)
          << method;
}

TEST(Warnings, AreGivenForMethodsThatAreThereToFail)
{
  for (const std::string &method : all_methods())
    EXPECT_EQ(is_warned_of({method}, "is there to show where it fails"),
              method == "box3" || method == "plain-newton")
        << method;
}
} // namespace orthocone::test
