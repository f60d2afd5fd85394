// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/surface_places.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
/// Two cubes of 2 mm side by side along x, from x = -1 to 3, y = 0 to 2, z = 5 to 7; a node beside them.
GmshFile two_cubes(const double noise = 0)
{
  GmshFile file;
  for (const double z : {5., 7.})
    for (const double y : {0., 2.})
      for (const double x : {-1., 1., 3.})
        file.nodes.push_back({{x, y, z + (x == 1 ? noise : 0)}});
  file.nodes.push_back({{100, 100, 100}});
  for (const unsigned int n : {0U, 1U})
    file.hexahedra.push_back({{{n, n + 1, n + 4, n + 3, n + 6, n + 7, n + 10, n + 9}}, 0});
  return file;
}

std::size_t n_faces(const GmshFile &file, const std::string &place)
{
  const MeshBox box(file);
  const auto plane = box.find(place);
  EXPECT_TRUE(plane) << place;
  return plane ? n_faces_in(file, box, *plane) : 0;
}
} // namespace

TEST(SurfacePlaces, AreFacesOnTheOutsideWithAllNodesInAPlane)
{
  const GmshFile cubes = two_cubes();
  for (const auto &[place, n] :
       {std::pair("x min", 1U), std::pair("x max", 1U), std::pair("y min", 2U), std::pair("y  max", 2U),
        std::pair("z min", 2U), std::pair("z max", 2U), std::pair("x = -1", 1U), std::pair("x=3", 1U),
        std::pair("z =7e0", 2U), std::pair("y = -0", 2U), std::pair("x = 1", 0U), std::pair("z = 6", 0U),
        std::pair("x = 100", 0U)})
    EXPECT_EQ(n_faces(cubes, place), n) << place;
  EXPECT_EQ(list_places(cubes, MeshBox(cubes)),
            "x min (-1), x max (3), y min (0), y max (2), z min (5), z max (7)");
}

// Of the longest side, 4 mm, a millionth.
TEST(SurfacePlaces, ForgiveTheRoundingOfSinglePrecision)
{
  EXPECT_EQ(n_faces(two_cubes(3.9e-6), "z max"), 2U);
  EXPECT_EQ(n_faces(two_cubes(3.9e-6), "z = 7"), 2U);
  EXPECT_EQ(n_faces(two_cubes(4.1e-6), "z max"), 0U);
  const GmshFile rough = two_cubes(0.1);
  EXPECT_EQ(list_places(rough, MeshBox(rough)), "x min (-1), x max (3), y min (0), y max (2)");
}

TEST(SurfacePlaces, AreNoOtherWords)
{
  const MeshBox box(two_cubes());
  for (const std::string text :
       {"",       " ",     "x",   "z",       "x ",       "z mx",        "z min max", "zmin",
        "Z min",  "w min", "min", "z = nan", "z = inf",  "x = 1e400",   "x =",       "x = 0 mm",
        "x == 0", "= 0",   "x 0", "x = 0 1", "\xff\xfe", "z\xc2\xa0min"})
    EXPECT_FALSE(box.find(text)) << text;
}

TEST(SurfacePlaces, KnowTheSamePlaneByOtherWords)
{
  const MeshBox box(two_cubes());
  EXPECT_TRUE(box.are_same(*box.find("z min"), *box.find("z = 5")));
  EXPECT_FALSE(box.are_same(*box.find("z min"), *box.find("x = 5")));
  EXPECT_FALSE(box.are_same(*box.find("z min"), *box.find("z max")));
}
} // namespace orthocone::test
