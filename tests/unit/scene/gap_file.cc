// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene/parameter_files.h"

#include <orthocone/scene/gap_file.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
std::string fault_of_file(const std::string &file)
{
  try
  {
    read_gap_file(file);
    return {};
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace

TEST(GapFile, IsBilinearBetweenItsNodes)
{
  const Folder folder;
  // gap = 1 + 2 x - y + x y at x = -1, 1, 3 and y = 2, 5, which a bilinear function is all over.
  const GapGrid grid = read_gap_file(folder.write("gap.txt", "# measured\n-1 2 3  2 3 2\n"
                                                             "-5 3 11 # y = 2\n\n-11 3\t17\r\n"));
  const auto gap = [](const double x, const double y) { return 1 + 2 * x - y + x * y; };
  for (const double x : {-1., -0.3, 1., 2.2, 3.})
    for (const double y : {2., 3.3, 5.})
      EXPECT_NEAR(grid.value(x, y), gap(x, y), 1e-13) << x << " " << y;
  EXPECT_EQ(grid.value(-7, 1), gap(-1, 2)) << "beyond, the nearest place counts";
  EXPECT_TRUE(grid.contains(3, 5) && grid.contains(3 + 1e-12, 2 - 1e-12));
  EXPECT_FALSE(grid.contains(3.1, 3) || grid.contains(0, 1.9) || grid.contains(-1.1, 3));
}

TEST(GapFile, RefusesHolesWithTheirPlace)
{
  const Folder folder;
  const auto fault_of = [&](const std::string &rows)
  { return fault_of_file(folder.write("gap.txt", "0 1 3 0 1 2\n" + rows)); };
  const std::string file = folder.path("gap.txt");
  const std::string finite = ": allowed is a finite number (mm), because a grid has no holes";
  EXPECT_EQ(fault_of("1 2 3\n1 nan 3\n"), file + ":3: number 2 is 'nan'" + finite);
  EXPECT_EQ(fault_of("# x\n1 2 inf\n1 2 3\n"), file + ":3: number 3 is 'inf'" + finite);
  EXPECT_EQ(fault_of("1e999 2 3\n1 2 3\n"), file + ":2: number 1 is '1e999'" + finite);
  EXPECT_EQ(fault_of("1 2 3\n1 3\n"),
            file + ":3: has 2 numbers: allowed are nx = 3 in each row, without holes");
  EXPECT_EQ(fault_of("1 2 3\n"), file + ": has 1 rows: allowed are ny = 2, without holes");
  EXPECT_EQ(fault_of("1 2 3\n1 2 3\n1 2 3\n"), file + ":4: is a row too many: allowed are ny = 2");
}

TEST(GapFile, RefusesAnotherHeadAndWhatIsNoText)
{
  const Folder folder;
  const std::string form = "': allowed is 'x0 dx nx y0 dy ny' (mm, mm, at least 2; the same of y)";
  for (const std::string head : {"0 1 3 0 1", "0 1 3 0 1 2 7", "0 0 3 0 1 2", "0 1 1 0 1 2", "0 1 2.5 0 1 2",
                                 "nan 1 3 0 1 2", "0 1 3 0 -1 2"})
  {
    const std::string file = folder.write("gap.txt", head + "\n1 2 3\n1 2 3\n");
    EXPECT_EQ(fault_of_file(file), file + ":1: '" + head + form);
  }
  const std::string empty = folder.write("empty.txt", " \n");
  EXPECT_EQ(fault_of_file(empty), empty + ": is empty; a grid of gaps is wanted");
  EXPECT_EQ(fault_of_file(folder.write("comment.txt", "# gap\n"))
                .find(folder.path("comment.txt") + ": has no line"),
            0u);
  const std::string binary = folder.write("binary.txt", "0 1\x01");
  EXPECT_EQ(fault_of_file(binary),
            binary + ": is not a text file; a text file with a grid of gaps is wanted");
  EXPECT_THROW(read_gap_file(folder.path("nowhere.txt")), FileError);
}
} // namespace orthocone::test
