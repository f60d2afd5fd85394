// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene/parameter_files.h"

#include <orthocone/base/numbers.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/program_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

namespace orthocone::test
{
namespace
{
LoadOptions read(const Folder &folder, const std::string &content, LoadOptions load = {})
{
  load.program_file = folder.write("signal.csv", content);
  read_program_file(load);
  return load;
}

std::string fault_of(const Folder &folder, const std::string &content)
{
  try
  {
    read(folder, content);
    return {};
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}

/// A file of one component, a value a line.
std::string signal_text(const std::vector<double> &values)
{
  std::ostringstream text;
  text << "ux [um]\n";
  for (const double value : values)
    text << value << "\n";
  return text.str();
}

std::vector<unsigned int> cycles_of(const LoadOptions &load)
{
  std::vector<unsigned int> cycles;
  for (const Leg &leg : load.rows)
    cycles.push_back(leg.row->cycle);
  return cycles;
}

/// The last rows of complete cycles, counted from 0.
std::vector<std::size_t> ends_of(const LoadOptions &load)
{
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < load.rows.size(); ++i)
    if (load.rows[i].row->ends_cycle)
      ends.push_back(i);
  return ends;
}
} // namespace

/// The rows of a file are the legs that say the same, to the last bit.
TEST(ProgramFile, RowsAreLegsOfOneStep)
{
  const Folder folder;
  LoadOptions by_legs, load = read(folder, "ux,Fz\n0,-10\n0.01,-10.5\n-0.02,-7\n");
  by_legs.legs.clear();
  for (const auto &[u_x, f_z] : {std::pair(0., -10.), std::pair(0.01, -10.5), std::pair(-0.02, -7.)})
  {
    by_legs.legs.emplace_back();
    by_legs.legs.back().targets[0] = Drive{false, u_x};
    by_legs.legs.back().targets[2] = Drive{true, f_z};
  }
  for (const unsigned int n : {1U, 3U})
  {
    for (auto *const legs : {&load.rows, &by_legs.legs})
      for (Leg &leg : *legs)
        leg.steps = n;
    const LoadSteps of_file = LoadProgram(load).steps(), of_legs = LoadProgram(by_legs).steps();
    ASSERT_EQ(of_file.size(), 3 * n);
    ASSERT_EQ(of_legs.size(), 3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
    {
      EXPECT_EQ(of_file[i].motion, of_legs[i].motion);
      EXPECT_EQ(of_file[i].force.components, of_legs[i].force.components);
      EXPECT_EQ(of_file[i].by_force, of_legs[i].by_force);
    }
  }
}

TEST(ProgramFile, ReadsUnitsSeparatorsAndComments)
{
  const Folder folder;
  for (const std::string separator : {",", ";", "\t", " ; "})
  {
    std::string text = "# of the machine\r\ntime [ms]|ux (um)|\"Fz [kN]\"|rz [rad]|My [N m]\r\n"
                       "500|12|-1.5|0.01|2\r\n\r\n1500|-12|-1.25|0|1e-3\r\n";
    for (std::size_t at; (at = text.find('|')) != std::string::npos;)
      text.replace(at, 1, separator);
    const LoadOptions load = read(folder, text);
    ASSERT_EQ(load.rows.size(), 2u) << separator;
    const Leg &first = load.rows[0], &second = load.rows[1];
    EXPECT_DOUBLE_EQ(*first.motion(0), 0.012);
    EXPECT_EQ(first.targets[2], (Drive{true, -1500}));
    EXPECT_DOUBLE_EQ(*first.motion(5), 0.01 / radians_per_degree);
    EXPECT_EQ(first.targets[4], (Drive{true, 2000}));
    EXPECT_DOUBLE_EQ(*first.row->time, 0.5);
    EXPECT_DOUBLE_EQ(*second.row->time, 1.5);
    EXPECT_EQ(second.row->line, 5u);
    EXPECT_FALSE(first.motion(1));
  }
}

/// Between two rows time passes evenly, and a repeated file goes on with it.
TEST(ProgramFile, StepsHaveTheirTimes)
{
  const Folder folder;
  LoadOptions load;
  load.steps_per_row = 2;
  load.cycles = 3;
  load.preload = {move_to(0, 0, -0.1, 2)};
  load = read(folder, "time,ux\n10,1\n11,0\n12,-1\n13,0\n", load);
  const LoadSteps steps = LoadProgram(load).steps();
  ASSERT_EQ(steps.size(), 2u + 3 * 8);
  EXPECT_EQ(*steps[1].time, 9);
  for (std::size_t i = 2; i < steps.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(*steps[i].time, 9 + 0.5 * (static_cast<double>(i) - 1));
    EXPECT_EQ(steps[i].cycle, 1 + (i - 2) / 8);
    EXPECT_EQ(steps[i].ends_cycle, (i - 2) % 8 == 7);
  }
}

/// A noisy sine behind a press: one cycle a period, whatever its phase, offset and number of rows.
TEST(ProgramFile, FindsTheCyclesOfANoisySignal)
{
  const Folder folder;
  unsigned int random = 1;
  const auto noise = [&]
  {
    random = 1103515245 * random + 12345;
    return static_cast<double>(random >> 16) / 65536 - 0.5;
  };
  for (const double rows_a_cycle : {8., 17.3, 100.})
    for (const double offset : {0., 3., -40.})
      for (const double sign : {1., -1.})
      {
        constexpr unsigned int n_cycles = 5, n_before = 4;
        std::vector<double> values(n_before, 0.);
        const auto n_rows = static_cast<unsigned int>(std::lround(n_cycles * rows_a_cycle));
        for (unsigned int i = 1; i <= n_rows; ++i)
          values.push_back(offset * (1 - std::cos(2 * pi * i / rows_a_cycle)) / 2 +
                           sign * 50 * std::sin(2 * pi * i / rows_a_cycle) + 2 * noise());
        const LoadOptions load = read(folder, signal_text(values));
        const std::vector<std::size_t> ends = ends_of(load);
        ASSERT_EQ(ends.size(), n_cycles) << rows_a_cycle << " " << offset << " " << sign;
        EXPECT_EQ(load.n_cycles(), n_cycles);
        for (unsigned int k = 1; k <= n_cycles; ++k)
          EXPECT_NEAR(static_cast<double>(ends[k - 1]), n_before - 1 + k * rows_a_cycle,
                      1 + rows_a_cycle / 40);
        for (unsigned int i = 0; i < n_before - 1; ++i)
          EXPECT_EQ(load.rows[i].row->cycle, 0u);
      }
}

TEST(ProgramFile, FindsCyclesOfFewRows)
{
  const Folder folder;
  using Cycles = std::vector<unsigned int>;
  using Ends = std::vector<std::size_t>;
  // Alternating, from the middle, with pauses, and behind the last cycle a half one.
  LoadOptions load = read(folder, signal_text({5, -5, 0, 0, 5, 5, -5, 0, 5}));
  EXPECT_EQ(cycles_of(load), (Cycles{1, 1, 1, 1, 2, 2, 2, 2, 3}));
  EXPECT_EQ(ends_of(load), (Ends{3, 7}));
  // Pulsating: the extreme where it sets out ends a cycle.
  load = read(folder, signal_text({4, 8, 4, 0, 4, 8, 4, 0}));
  EXPECT_EQ(ends_of(load), (Ends{3, 7}));
  // Behind a preload it sets out from there.
  LoadOptions preloaded;
  preloaded.preload = {move_to(0.008, 0, -0.1, 1)};
  load = read(folder, signal_text({0, 8, 0, 8}), preloaded);
  EXPECT_EQ(ends_of(load), (Ends{1, 3}));
  // No cycle at all: the file is one.
  load = read(folder, signal_text({1, 2, 3, 4}));
  EXPECT_EQ(cycles_of(load), (Cycles{1, 1, 1, 1}));
  EXPECT_EQ(ends_of(load), (Ends{3}));
}

TEST(ProgramFile, TakesCyclesThatAreCounted)
{
  const Folder folder;
  const LoadOptions load = read(folder, "cycle;ux\n0;0\n0;0.1\n1;0.2\n1;0.3\n2;0.2\n");
  EXPECT_EQ(cycles_of(load), (std::vector<unsigned int>{0, 0, 1, 1, 2}));
  EXPECT_EQ(ends_of(load), (std::vector<std::size_t>{3, 4}));
  const LoadSteps steps = LoadProgram(load).steps();
  EXPECT_EQ(steps[1].phase, 1u);
  EXPECT_EQ(steps[2].phase, 0u);
  EXPECT_EQ(steps[4].phase, 0u);
  EXPECT_EQ(load.n_cycles(), 2u);
}

TEST(ProgramFile, RefusesWithTheLineAndTheRemedy)
{
  const Folder folder;
  const std::string file = folder.path("signal.csv");
  const auto expect = [&](const std::string &content, const std::string &fault)
  { EXPECT_EQ(fault_of(folder, content).substr(0, fault.size() + file.size()), file + fault); };
  expect("ux\n", ": has no row");
  expect("ux;Fz\n1;2\n1;\n",
         ":3: column 'Fz' is '': allowed is a finite number, because a signal has no gaps");
  expect("ux;Fz\n1;2\nx;1\n", ":3: column 'ux' is 'x': allowed is a finite number");
  expect("ux;Fz\n1;2\n1,5;1\n", ":3: column 'ux' is '1,5': allowed is a finite number with a decimal point");
  expect("ux;Fz\n1;2\n1;nan\n", ":3: column 'Fz' is 'nan': allowed is a finite number");
  expect("ux,Fz\n1,2\n1,5,1\n",
         ":3: has 3 cells: allowed are the 2 of the header; with a decimal comma write ';'");
  expect("ux,Fz\n1,2\n1\n", ":3: has 1 cell: allowed are the 2 of the header");
  expect("ux,Fq\n1,2\n", ":1: column 'Fq': allowed is time, cycle, or a name of ux, uy");
  expect("ux,Fx\n1,2\n", ":1: column 'Fx': allowed is a component once in a leg; ux and Fx are the same");
  expect("ux,\n1,2\n", ":1: column 2 has no name");
  expect("time,cycle\n1,1\n", ":1: no column drives the held face");
  expect("time,time,ux\n1,1,1\n", ":1: column 'time' is there twice");
  expect("ux [N]\n1\n", ":1: column 'ux' has the unit 'N': allowed are mm, um");
  expect("ux [mm\n1\n", ":1: column 'ux [mm': allowed is a name");
  expect("time;ux\n1;1\n1;2\n", ":3: column 'time' is 1 and does not increase: allowed is more than 1");
  expect("cycle;ux\n1;1\n3;2\n", ":3: column 'cycle' is 3: allowed is 1 or 2");
  expect("cycle;ux\n0.5;1\n", ":2: column 'cycle' is 0.5: allowed is 0 or 1");
}
} // namespace orthocone::test
