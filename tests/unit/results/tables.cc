// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/base/numbers.h>
#include <orthocone/results/tables.h>

#include <set>

namespace orthocone::test
{
namespace
{
/// Cells of a line by the names of their columns.
template<typename Row>
std::map<std::string, std::string> cells_of(const Columns<Row> &columns, const Row &row)
{
  const auto names = split(trimmed(header_line(columns)), ',');
  const auto values = split(trimmed(row_line(columns, row)), ',');
  EXPECT_EQ(names.size(), values.size());
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < names.size(); ++i)
    cells[names[i]] = values[i];
  return cells;
}

template<typename Row>
void expect_well_described(const Columns<Row> &columns)
{
  std::set<std::string> names;
  for (const Column<Row> &column : columns)
  {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(std::string(column.how).empty()) << column.name;
  }
}
} // namespace

TEST(Tables, ColumnsHaveNamesOfTheirOwnAndSayWhatTheyTell)
{
  expect_well_described(history_columns());
  expect_well_described(checks_columns());
  expect_well_described(timing_columns());
  expect_well_described(probe_columns());
  expect_well_described(cycle_columns());
}

TEST(Tables, HistoryTellsRotationsInDegreesAndThePlaceInTheProgram)
{
  ContactState state(1);
  state.step = 7;
  state.motion.components << 0.5, 0, -0.1, 0, 0, pi / 2;
  Totals before;
  before.total_dissipation = 2;
  Totals totals;
  totals.total_dissipation = 5;
  totals.moment = {1, 2, 3};
  totals.held.components << 0, 0, 0, -1, -2, -3;
  const SolvedStep step{state, before, totals, {}, {}, 0, {{}, 7, 1, 2, 3}, "uzawa", "ux uy uz"};
  const auto cells = cells_of(history_columns(), step);
  EXPECT_EQ(cells.at("step"), "7");
  EXPECT_EQ(cells.at("ux"), "0.5");
  EXPECT_EQ(cells.at("rx"), "0");
  EXPECT_EQ(cells.at("rz"), "90");
  EXPECT_EQ(cells.at("moment_y"), "2");
  EXPECT_EQ(cells.at("held_moment_y"), "-2"); // as the legs give it
  EXPECT_EQ(cells.at("held_force_x"), "0");
  EXPECT_EQ(cells.at("dissipation"), "3");
  EXPECT_EQ(cells.at("method"), "uzawa");
  EXPECT_EQ(cells.at("cycle"), "2");
  EXPECT_EQ(cells.at("phase"), "3");
  EXPECT_EQ(cells.at("driven"), "ux uy uz");
}

TEST(Fields, AreNamedOnceAndMirroredWithTheirNode)
{
  std::set<std::string> names;
  ContactFields fields;
  fields.slip = {3, 4, 0};
  fields.nodal_force = {1, 2, 5};
  fields.pressure = 6;
  const ContactFields image = mapped(fields, Eigen::Vector2d(-1, 1).asDiagonal());
  for (const ContactField &field : contact_field_list())
  {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    const Eigen::Vector3d here = field.value(fields);
    Eigen::Vector3d there = field.value(image);
    if (field.n_components() == 3)
      there[0] = -there[0];
    EXPECT_EQ(here, there) << field.name;
    EXPECT_TRUE(field.name != std::string("slip_magnitude") || there[0] == 5);
  }
  EXPECT_EQ(names.count("slip_magnitude"), 1u);
}

TEST(HeldFace, LargestWayCountsAllComponents)
{
  LoadOptions load;
  load.legs = {move_to(0.02, 0, -0.1, 3), move_to(-0.3, 0, 0, 2)};
  EXPECT_EQ(largest_way(load, 20), 0.3);
  load.preload = {move_to(0, 0.5, 0, 1)};
  EXPECT_EQ(largest_way(load, 20), 0.5);
}
} // namespace orthocone::test
