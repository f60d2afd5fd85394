// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/entry.h>

#include "folder_of_files.h"

#include <orthocone/base/errors.h>
#include <orthocone/entries/files.h>
#include <orthocone/entries/names.h>

#include <gtest/gtest.h>

#include <sstream>

namespace orthocone
{
namespace
{
enum class Fruit
{
  apple,
  pear,
};
} // namespace

template<>
struct Words<Fruit>
{
  static constexpr std::array<std::pair<Fruit, std::string_view>, 2> table{
      {{Fruit::apple, "apple"}, {Fruit::pear, "pear"}}};
};
} // namespace orthocone

namespace orthocone::test
{
namespace
{
/// Two baskets of the same entries, the second in sections with a prefix and only where the first has pears.
struct Baskets
{
  struct Basket
  {
    Fruit fruit = Fruit::apple;
    double weight = 1;
    unsigned int stones = 0;
    std::string label{};
  };

  Baskets()
  {
    Section section(list, "Basket");
    declare(basket, section);
    Section second(list, "Second basket", has_pears(basket, section));
    declare(other, second);
  }

  static Condition has_pears(const Basket &of, const Section &section)
  {
    return {[&of] { return of.fruit == Fruit::pear; },
            [&of, name = section.name()] { return name + "/Fruit = " + to_word(of.fruit); }};
  }

  static void declare(Basket &of, Section &section)
  {
    section.add_word("Fruit", of.fruit, "What is in it.").also_called({"kind of fruit"});
    section.add("Weight", of.weight, number_codec(positive), "In kg.").may_change_on_resume();
    section.add("Stones", of.stones, count_codec(0, 9), "In each.").only_if(has_pears(of, section));
    section.add("Label", of.label, path_codec(), "A picture.").path(of.label);
  }

  Basket basket, other;
  EntryList list;
};

std::string fault_of(EntryList &list, const std::string &assignment)
{
  try
  {
    assign_entry(assignment, list);
    return {};
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace

TEST(Entries, AreThoseOfEverySectionThatHasThem)
{
  const Baskets baskets;
  EXPECT_EQ(baskets.list.sections(), (std::vector<std::string>{"Basket", "Second basket"}));
  EXPECT_EQ(baskets.list.names().size(), 8u);
  EXPECT_TRUE(baskets.list.find("Second basket/Weight")->may_change());
  EXPECT_FALSE(baskets.list.find("Basket/Fruit")->may_change());
  EXPECT_TRUE(baskets.list.is_path("Basket/Label") && !baskets.list.is_path("Basket/Fruit"));
  EXPECT_EQ(baskets.list.find("Basket/Pears"), nullptr);
}

TEST(Entries, SetTheirValuesOrSayWhatIsAllowed)
{
  Baskets baskets;
  EXPECT_EQ(fault_of(baskets.list, "Second basket/Weight=2.5"), "");
  EXPECT_EQ(baskets.other.weight, 2.5);
  EXPECT_EQ(baskets.basket.weight, 1);
  EXPECT_EQ(fault_of(baskets.list, "Basket/Weight=-1"), "--set: Basket/Weight = -1: allowed is a number > 0");
  EXPECT_EQ(fault_of(baskets.list, "Basket/Weight="),
            "--set: Basket/Weight is empty: allowed is a number > 0");
  EXPECT_EQ(fault_of(baskets.list, "Basket/Fruit=plum"),
            "--set: Basket/Fruit = plum: allowed is apple | pear");
  EXPECT_EQ(fault_of(baskets.list, "Basket/Kind of fruit=pear").find("is Basket/Fruit meant?") !=
                std::string::npos,
            true);
  EXPECT_EQ(fault_of(baskets.list, "Basket/Wieght=1").find("is Basket/Weight meant?") != std::string::npos,
            true);
  EXPECT_EQ(baskets.basket.weight, 1) << "what is not allowed changes nothing";
}

TEST(Entries, AreIgnoredWhereAnotherOneSaysSo)
{
  Baskets baskets;
  const Baskets usual;
  EXPECT_TRUE(ignored_entries(baskets.list, usual.list).empty());
  baskets.basket.stones = baskets.other.stones = 3;
  EXPECT_EQ(ignored_entries(baskets.list, usual.list),
            (std::vector<std::string>{"Basket/Stones = 3 is ignored with Basket/Fruit = apple",
                                      "Second basket/Stones = 3 is ignored with Basket/Fruit = apple"}));
  baskets.basket.fruit = Fruit::pear;
  EXPECT_EQ(
      ignored_entries(baskets.list, usual.list),
      (std::vector<std::string>{"Second basket/Stones = 3 is ignored with Second basket/Fruit = apple"}));
}

TEST(Entries, NamePathsFromTheFolderOfTheirFile)
{
  const Folder folder;
  Baskets baskets;
  const std::string text = read_entries(
      folder.write("part/basket.prm", "subsection Basket\n  set Label = ../a.png\nend\n"), baskets.list);
  EXPECT_EQ(baskets.basket.label, folder.path("a.png"));
  EXPECT_EQ(text, "subsection Basket\n  set Label = " + folder.path("a.png") + "\nend\n");
  Baskets again;
  read_entries(folder.write("copy.prm", text), again.list);
  EXPECT_EQ(again.list.values(), baskets.list.values());
}

TEST(Entries, ReadBackAsTheyArePrinted)
{
  const Folder folder;
  Baskets baskets, again;
  baskets.other = {Fruit::pear, 1. / 3, 7, "/tmp/b"};
  std::ostringstream text;
  print_entries(baskets.list, text);
  read_entries(folder.write("all.prm", text.str()), again.list);
  EXPECT_EQ(again.list.values(), baskets.list.values());
}
} // namespace orthocone::test
