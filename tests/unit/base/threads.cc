// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/machine.h>
#include <orthocone/base/threads.h>

#include <gtest/gtest.h>

#include <sched.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

namespace orthocone::test
{
namespace
{
constexpr double large = 1e5; // unknowns
} // namespace

TEST(Threads, LeaveCoresToOthers)
{
  const UsableCores eight{8, 8}, two{2, 2};
  EXPECT_EQ(choose_threads(large, eight, 0).number, 8u);
  EXPECT_EQ(choose_threads(large, eight, 0.3).number, 8u) << "a task now and then";
  EXPECT_EQ(choose_threads(large, eight, 3.1).number, 5u);
  EXPECT_EQ(choose_threads(large, two, 1.6).number, 1u);
  EXPECT_EQ(choose_threads(large, two, 4).number, 1u) << "as many as there are cores, and more";
  EXPECT_EQ(choose_threads(large, two, 4).reason, "2 cores, others busy on 4");
}

/// In a container on a large machine others have their own cores.
TEST(Threads, AreNoMoreThanAControlGroupGrants)
{
  EXPECT_EQ(choose_threads(large, {64, 4}, 20).number, 4u);
  EXPECT_EQ(choose_threads(large, {64, 4}, 62).number, 2u);
  EXPECT_EQ(choose_threads(large, {64, 4}, 80).number, 1u);
}

TEST(Threads, AreOneForASmallModelOrOneCore)
{
  EXPECT_EQ(choose_threads(1000, {8, 8}, 0).number, 1u);
  EXPECT_FALSE(depends_on_load(1000, {8, 8}));
  EXPECT_EQ(choose_threads(large, {1, 1}, 0).number, 1u);
  EXPECT_FALSE(depends_on_load(large, {8, 1}));
  EXPECT_TRUE(depends_on_load(large, {2, 2}));
}

TEST(Threads, AreNoMoreThanTheCoresOfTheProcess)
{
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  const UsableCores all = usable_cores();
  EXPECT_EQ(all.allowed, static_cast<unsigned int>(CPU_COUNT(&before)));
  EXPECT_LE(all.granted, all.allowed);
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core)
    if (CPU_ISSET(core, &before))
      CPU_SET(core, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_cores().allowed, 1u);
  EXPECT_EQ(usable_cores().granted, 1u);
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

TEST(Threads, OfBlasAreWhatIsSet)
{
  const unsigned int before = blas_threads();
  {
    const BlasThreads small(10);
    EXPECT_EQ(blas_threads(), 1u);
  }
  EXPECT_EQ(blas_threads(), before);
  const BlasThreads large_one(100000);
  EXPECT_EQ(blas_threads(), before);
}

/// What this process does itself is not what others do.
TEST(MachineLoad, DoesNotCountThisProcess)
{
  const MachineLoad idle;
  const double others = idle.busy_cores(); // waits
  const MachineLoad busy;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  volatile unsigned long n = 0;
  while (std::chrono::steady_clock::now() < end)
    n = n + 1;
  const double with_us = busy.busy_cores();
  EXPECT_GE(others, 0);
  EXPECT_GE(with_us, 0);
  EXPECT_LE(with_us, std::thread::hardware_concurrency()) << "not more cores than there are";
}

TEST(ControlGroups, AreThoseAboveTheProcessToo)
{
  std::set<std::string> seen;
  const double least = least_in_control_groups("cpu",
                                               [&](const std::string &folder, bool)
                                               {
                                                 seen.insert(folder);
                                                 return static_cast<double>(folder.size());
                                               });
  if (seen.empty())
    GTEST_SKIP() << "no control groups here";
  EXPECT_EQ(least, static_cast<double>(seen.begin()->size())) << "the shortest name is that of the root";
  for (const std::string &folder : seen)
    EXPECT_EQ(folder.rfind("/sys/fs/cgroup", 0), 0u) << folder;
}
} // namespace orthocone::test
