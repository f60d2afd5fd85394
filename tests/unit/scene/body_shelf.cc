// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Bodies that scenes share: which ones are the same, and that they have the bits of bodies of their own.
#include "folder_of_files.h"

#include <orthocone/scene/body_shelf.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace orthocone::test
{
namespace
{
/// A box on a roller, so that its field of loads depends on the axes, too.
BodyOptions kept_box()
{
  BodyOptions options;
  options.geometry.shape = BodyShape::box;
  options.geometry.sizes = {{4, 3, 2}};
  options.geometry.supports = {{"x+", {{true, false, false}}}};
  options.mesh.cells = {{3, 2, 1}};
  options.mesh.degree = 1;
  return options;
}

/// A body of this shelf, with axes that are turned by this angle (degrees).
std::shared_ptr<const FactorizedBody> body_of(BodyShelf &shelf, const BodyOptions &options,
                                              const double angle, unsigned int &n_meshed)
{
  PhaseSeconds seconds;
  return shelf.body(
      options, ModelSymmetry(), [angle](const ContactSurface &) { return LocalAxes(angle); },
      [&](const Body &) { ++n_meshed; }, seconds);
}
} // namespace

TEST(BodyShelf, HasTheBitsOfNewBodies)
{
  BodyShelf shelf, none;
  unsigned int n_meshed = 0;
  shelf.collect("box");
  body_of(shelf, kept_box(), 45, n_meshed);
  shelf.collect("");
  ASSERT_FALSE(shelf.is_empty());
  for (const double angle : {0., 90., 30., -123.4})
  {
    const auto kept = body_of(shelf, kept_box(), angle, n_meshed),
               made = body_of(none, kept_box(), angle, n_meshed);
    EXPECT_EQ(*kept->compliance().dense(), *made->compliance().dense()) << angle;
    ASSERT_NE(made->driven(), nullptr);
    EXPECT_EQ(kept->driven()->contact, made->driven()->contact) << angle;
    EXPECT_EQ(kept->driven()->conjugates, made->driven()->conjugates) << angle;
    const NodeVector force = NodeVector::LinSpaced(made->compliance().n_nodes() * 3, 1, 2);
    EXPECT_EQ(kept->elastic_displacement(force), made->elastic_displacement(force)) << angle;
  }
  EXPECT_EQ(n_meshed, 9U); // every body announces its mesh
  EXPECT_EQ(&body_of(shelf, kept_box(), 10, n_meshed)->mesh(),
            &body_of(shelf, kept_box(), 20, n_meshed)->mesh());
  shelf.drop("box");
  EXPECT_TRUE(shelf.is_empty());
}

// It depends on the half-space and on the axes of friction, and on nothing else that a scene has beside its
// body.
TEST(BodyShelf, HasTheComplianceOfTheGround)
{
  const auto sum_of = [](const std::string &modulus, const double angle, const double mu)
  {
    Parameters parameters = with_section(
        Parameters(), "Obstacle", {{"Obstacle/Kind", "half-space"}, {"Obstacle/Young modulus", modulus}});
    static_cast<BodyOptions &>(parameters) = kept_box();
    parameters.geometry.supports.clear();
    parameters.mesh.model = ModelKind::full;
    parameters.friction.angle = angle;
    parameters.friction.mu = {{mu, mu / 2}};
    return Eigen::MatrixXd(*Scene(parameters, choose_model(parameters)).compliance().dense());
  };
  const Eigen::MatrixXd first = sum_of("1000", 0, 0.3), softer = sum_of("500", 0, 0.3),
                        turned = sum_of("1000", 20, 0.3);
  BodyShelf &shelf = BodyShelf::of_process();
  shelf.collect("scene");
  sum_of("1000", 0, 0.3);
  shelf.collect("");
  EXPECT_EQ(sum_of("1000", 0, 0.1), first);
  EXPECT_EQ(sum_of("500", 0, 0.1), softer);
  EXPECT_EQ(sum_of("1000", 20, 0.1), turned);
  EXPECT_NE(softer, first);
  EXPECT_NE(turned, first);
  unsigned int n_made = 0;
  const auto make = [&]
  {
    ++n_made;
    return Eigen::MatrixXd(Eigen::MatrixXd::Identity(3, 3));
  };
  shelf.collect("other");
  for (const char *const key : {"a", "b", "a", "b"})
    shelf.compliance([key] { return std::string(key); }, make);
  shelf.collect("");
  EXPECT_EQ(n_made, 2U);
  shelf.drop("other");
  shelf.compliance([] { return std::string("a"); }, make);
  EXPECT_EQ(n_made, 3U);
  shelf.drop("scene");
  EXPECT_TRUE(shelf.is_empty());
}

TEST(BodyShelf, KeepsNothingUnlessAsked)
{
  BodyShelf shelf;
  unsigned int n_meshed = 0;
  body_of(shelf, kept_box(), 0, n_meshed);
  EXPECT_TRUE(shelf.is_empty());
}

// The symmetry, every entry of a body, loads, and what the program sets beside the entries.
TEST(BodyShelf, DistinguishesBodies)
{
  std::set<std::string> keys;
  unsigned int n = 0;
  const auto add = [&](const BodyOptions &options, const ModelSymmetry &symmetry = {})
  {
    keys.insert(body_key(options, symmetry));
    EXPECT_EQ(keys.size(), ++n);
  };
  add(kept_box());
  add(kept_box(), SymmetryPlanes{true, false});
  add(kept_box(), ModelSymmetry::of_plane_strain(1, true));
  add(kept_box(), ModelSymmetry::of_plane_strain(2, true));
  add(kept_box(), ModelSymmetry::of_plane_strain(2, false));
  BodyOptions changed = kept_box();
  changed.material.young_modulus = std::nextafter(changed.material.young_modulus, 0);
  add(changed);
  changed.geometry.supports.clear();
  add(changed);
  changed.mesh.coarsenings = 1;
  add(changed);
  changed.geometry.faces_down = false;
  add(changed);
  changed.geometry.is_lower = true;
  add(changed);
  for (const char *const loads :
       {"p: pressure on x-", "p: pressure on y-", "p: pressure on x- ; q: pressure on y-"})
  {
    Parameters parameters = with_section(Parameters(), "Load program", {{"Load program/Loads", loads}});
    changed.geometry.loads = parameters.load.loads;
    add(changed);
  }
  EXPECT_EQ(body_key(kept_box(), {}), body_key(kept_box(), {}));
}

TEST(BodyShelf, DistinguishesContentsOfFiles)
{
  const Folder folder;
  BodyOptions options;
  options.geometry.shape = BodyShape::file;
  options.geometry.mesh_file = folder.write("part.msh", "one");
  const std::string first = body_key(options, {});
  EXPECT_EQ(body_key(options, {}), first);
  folder.write("part.msh", "two");
  EXPECT_NE(body_key(options, {}), first);
}
} // namespace orthocone::test
