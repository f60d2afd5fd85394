// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/json_schema.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace orthocone
{
namespace
{
enum class Colour
{
  red,
  green,
};
} // namespace

template<>
struct Words<Colour>
{
  static constexpr std::array<std::pair<Colour, std::string_view>, 2> table{
      {{Colour::red, "red"}, {Colour::green, "green"}}};
};
} // namespace orthocone

namespace orthocone::test
{
TEST(JsonSchema, HasEveryEntryWithItsWordsDefaultAndUnit)
{
  EntryList list;
  Section section(list, "Paint");
  Colour colour = Colour::green;
  double thickness = 0.5;
  section.add_word("Colour", colour, "What it looks like.");
  section.add("Thickness", thickness, number_codec(positive), "Of a layer.").unit("mm");
  unsigned int coats = 2;
  section.add("Coats", coats, count_codec(1, 9), "How many.");
  std::string sample;
  section.add("Sample", sample, path_codec(), "A picture.").path(sample);
  const auto schema = nlohmann::json::parse(json_schema(list, "Paints"));
  EXPECT_EQ(schema.at("title"), "Paints");
  EXPECT_EQ(schema.at("additionalProperties"), false) << "misspelt sections are marked";
  const auto &paint = schema.at("properties").at("Paint");
  EXPECT_EQ(paint.at("additionalProperties"), false);
  const auto &entries = paint.at("properties");
  EXPECT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries.at("Coats").at("default").dump(), "2");
  EXPECT_EQ(entries.at("Sample").at("format"), "path");
  EXPECT_FALSE(entries.at("Coats").contains("format"));
  EXPECT_EQ(entries.at("Colour").at("enum"), nlohmann::json({"red", "green"}));
  EXPECT_EQ(entries.at("Colour").at("default"), "green");
  EXPECT_EQ(entries.at("Thickness").at("default"), 0.5);
  EXPECT_EQ(entries.at("Thickness").at("type"), nlohmann::json({"number", "string"})) << "0.5, or '500 um'";
  EXPECT_NE(entries.at("Thickness").at("description").get<std::string>().find("Unit: mm"), std::string::npos);
}
} // namespace orthocone::test
