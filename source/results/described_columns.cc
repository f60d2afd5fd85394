// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/described_columns.h>

#include <orthocone/results/contact_fields.h>
#include <orthocone/results/tables.h>
#include <orthocone/results/volume_fields.h>

namespace orthocone
{
namespace
{
/// The lines of one file. An `Item` has a name, a unit, and a text on its meaning.
template<typename Item>
std::string lines(const std::string &file, const std::vector<Item> &items)
{
  std::string text;
  for (const Item &item : items)
    text += file + "\t" + item.name + "\t" + item.unit + "\t" + item.how + "\n";
  return text;
}
} // namespace

std::string described_columns()
{
  return lines("history.csv", history_columns()) + lines("probe-NAME.csv", probe_columns()) +
         lines("cycles.csv", cycle_columns()) + lines("checks.csv", checks_columns()) +
         lines("timing.csv", timing_columns()) + lines("contact-NNNN.vtu", contact_field_list()) +
         lines("volume-NNNN.vtu", volume_field_list());
}
} // namespace orthocone
