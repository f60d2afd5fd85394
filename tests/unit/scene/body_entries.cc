// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"
#include "scene/parameter_files.h"

#include <orthocone/body/materials/orthotropic_law.h>

#include <gtest/gtest.h>

#include <sstream>

namespace orthocone::test
{
TEST(GroupEntries, ReadBackWhatTheyWrite)
{
  const Folder folder;
  const Parameters given =
      read_parameters(folder.write("a.prm", "subsection Geometry\n  set Shape = file\n  set Mesh file = "
                                            "a.msh\n  set Contact surface = the base\n  set Held surface = "
                                            "2\n  set Symmetry surfaces = x0, 7\nend\nsubsection Material\n"
                                            "  set Regions = core: 70000, 0.33 ; 4: 1e3, -0.1\nend\n"));
  EXPECT_EQ(given.geometry.mesh_file, folder.path("a.msh"));
  EXPECT_EQ(given.geometry.symmetry_surfaces, (std::vector<std::string>{"x0", "7"}));
  ASSERT_EQ(given.material.regions.size(), 2u);
  EXPECT_EQ(given.material.regions[1].volume, "4");
  EXPECT_EQ(given.material.regions[1].poisson_ratio, -0.1);
  std::ostringstream text;
  write_parameters(given, text);
  const Parameters again = read_parameters(folder.write("part/b.prm", text.str()));
  EXPECT_EQ(entry_values(again), entry_values(given));
}

TEST(MaterialChecks, WantAnOrthotropicMaterialToStoreEnergy)
{
  Parameters parameters;
  auto &material = parameters.material.law.choose<OrthotropicLaw>();
  const auto is_taken = [&] { return rejection_of([&] { check_parameters(parameters); }).empty(); };
  EXPECT_TRUE(is_taken());
  material.young_moduli = {{100, 1, 1}};
  material.poisson_ratios = {{3, 3, 0.1}};
  EXPECT_TRUE(is_taken()) << "9 / 100 + 9 / 100 + 0.01 + 1.8 / 100 < 1";
  material.poisson_ratios = {{11, 0, 0}};
  EXPECT_FALSE(is_taken());
  material.poisson_ratios = {{0, 0, 1.01}};
  EXPECT_FALSE(is_taken());
  material.young_moduli = {{1, 1, 1}};
  material.poisson_ratios = {{0.6, 0.6, 0.6}}; // each is fine
  EXPECT_FALSE(is_taken());
}

TEST(MaterialChecks, NameWhatCannotGoTogether)
{
  Parameters parameters;
  parameters.material.law = "orthotropic";
  parameters.mesh.backend = BodyBackend::multigrid;
  EXPECT_NE(rejection_of([&] { check_parameters(parameters); }).find("Material/Law = orthotropic with"),
            std::string::npos);
  parameters = Parameters();
  parameters.material.regions = {{"core", 1, 0}};
  EXPECT_EQ(rejection_of([&] { check_parameters(parameters); }),
            "Material/Regions is set without a mesh file: allowed is nothing, or Geometry/Shape = file, "
            "because regions are physical volumes of the file");
}
} // namespace orthocone::test
