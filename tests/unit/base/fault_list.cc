// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/fault_list.h>

#include <orthocone/base/errors.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(FaultList, TellsAllUpToABound)
{
  FaultList faults;
  EXPECT_NO_THROW(faults.throw_if_any("a: "));
  for (std::size_t n = 1; n <= FaultList::most_told; ++n)
    faults.add("is " + std::to_string(n));
  EXPECT_EQ(faults.text(), "is 1; is 2; is 3; is 4");
  faults.add("is 5");
  EXPECT_EQ(faults.text(), "is 1; is 2; is 3; is 4; and 1 fault more");
  for (unsigned int n = 0; n < 1000; ++n)
    faults.add("is another");
  try
  {
    faults.throw_if_any("a: ", ": allowed is b");
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const InputError &error)
  {
    EXPECT_STREQ(error.what(), "a: is 1; is 2; is 3; is 4; and 1001 faults more: allowed is b");
  }
}

TEST(Enumeration, NamesFourThingsAtMost)
{
  EXPECT_EQ(enumeration({}), "");
  EXPECT_EQ(enumeration({"a"}), "a");
  EXPECT_EQ(enumeration({"a", "b"}), "a and b");
  EXPECT_EQ(enumeration({"a", "b", "c", "d"}), "a, b, c and d");
  EXPECT_EQ(enumeration({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}
} // namespace orthocone::test
