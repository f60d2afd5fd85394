// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/field_list.h>
#include <orthocone/output/history.h>
#include <output/run_files.h>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace orthocone::test
{
using namespace run_folder;

TEST(RunFiles, KnowWhatARunWrites)
{
  for (const std::string name : {"history.csv", "probe-P.csv", "probe-a.b.csv", "log.txt", "summary.json",
                                 "contact.pvd", "checkpoint/state", "checkpoint/state.part", "log.txt.part",
                                 "line-P-0001.csv", "line-a-b_2-0001-12345.csv", "line-P-0001.csv.part"})
    EXPECT_NE(run_file(name), nullptr) << name;
  for (const std::string name :
       {"", "mine.csv", "history.csv2", "a-history.csv", "probe-P.txt", "probe-.cs", "contact-001.vtu",
        "contact-0001.vtu.bak", "contact-00x1.vtu", ".part", "contact-1234567890.vtu", "summary_json",
        "state",
        // names that lead out of the folder, or end early for the system
        "probe-x/../../thesis.csv", "probe-/../x.csv", "probe-/etc/x.csv", "volume-0001./../../x.vtu",
        "volume-0001.0/1.vtu", "line-../x-0001.csv", "line-/etc-0001.csv", "line-x-0001/../y-0001.csv",
        // lines without name or step
        "line-0001.csv", "line--0001.csv", "line-P.csv", "line-P-001.csv", "line-P-0001.vtu",
        "line-P-0001x.csv", "../history.csv", "checkpoint/../history.csv", "checkpoint/state/../x",
        "/history.csv", "probe-x.csv/", "./history.csv"})
    EXPECT_EQ(run_file(name), nullptr) << name;
  EXPECT_EQ(run_file(std::string("probe-x\0.csv", 12)), nullptr);
  EXPECT_EQ(run_file("probe-P.csv")->kind, FileKind::probe_table);
  EXPECT_EQ(run_file("line-P-0001.csv")->kind, FileKind::line_file);
}

TEST(RunFiles, HaveNamesAndPurposesOfTheirOwn)
{
  std::set<std::string> names;
  for (const RunFile &file : run_files())
  {
    EXPECT_TRUE(names.insert(file.pattern).second) << file.pattern;
    EXPECT_FALSE(std::string(file.what).empty()) << file.pattern;
  }
  EXPECT_EQ(fixed_names(FileKind::table).size(), 4u);
  EXPECT_TRUE(fixed_names(FileKind::probe_table).empty());
}

TEST(RunFiles, TellTheStepOfAFieldFile)
{
  for (const unsigned int step : {0U, 7U, 9999U, 10000U, 123456U})
    for (const char *const kind : {"contact", "volume"})
      EXPECT_EQ(step_of(field_file(kind, step)), step);
  EXPECT_EQ(step_of("line-a-0003-0012.csv"), 12U) << "numbers may be part of the name";
  EXPECT_FALSE(step_of("contact.pvd"));
  EXPECT_FALSE(step_of("contact-0007.vtu.part"));
  EXPECT_FALSE(step_of("probe-0007.csv"));
}
} // namespace orthocone::test
