// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/machine.h>
#include <orthocone/base/threads.h>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace orthocone::test
{
namespace
{
constexpr double large = 1e5; // unknowns
using Product = void(const char *, const char *, const int *, const int *, const int *, const double *,
                     const double *, const int *, const double *, const int *, const double *, double *,
                     const int *);

/// Leaves `bytes` of the address space.
void leave_address_space(const double bytes)
{
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max = std::size_t{1} << 40;
  setrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = static_cast<rlim_t>(static_cast<double>(limit.rlim_cur) - free_address_space() + bytes);
  setrlimit(RLIMIT_AS, &limit);
}

/// A function of OpenBLAS, or null with another BLAS.
template<typename Function>
Function *of_openblas(const char *const name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}

/// Makes OpenBLAS choose its kernels again.
void choose_kernels_again()
{
  of_openblas<void()>("gotoblas_dynamic_quit")();
  of_openblas<void()>("gotoblas_dynamic_init")();
}

void multiply(Product &product)
{
  constexpr int n = 400; // large enough for OpenBLAS to want a buffer
  const std::vector<double> matrix(n * n, 1.);
  std::vector<double> result(n * n);
  const double one = 1, zero = 0;
  for (int i = 0; i < 20; ++i)
    product("N", "N", &n, &n, &n, &one, matrix.data(), &n, matrix.data(), &n, &zero, result.data(), &n);
}

/// Two threads of BLAS at once where all of the address space is taken. Ends the process: 0 done, 1 no
/// OpenBLAS.
[[noreturn]] void multiply_without_address_space()
{
  void *const blas = dlopen("libopenblas.so.0", RTLD_NOW | RTLD_GLOBAL);
  auto *const product = blas == nullptr ? nullptr : reinterpret_cast<Product *>(dlsym(blas, "dgemm_"));
  if (product == nullptr)
    ::_exit(1);
  std::vector<std::thread> threads;
  std::atomic<bool> may_begin{false};
  for (int i = 0; i < 2; ++i)
    threads.emplace_back(
        [&]
        {
          while (!may_begin)
            std::this_thread::yield();
          multiply(*product);
        });
  leave_address_space(600e6);
  if (map_blas_buffers(2) != 2)
    ::_exit(2);
  leave_address_space(20e6); // less than a buffer
  may_begin = true;
  ::alarm(60);
  for (std::thread &thread : threads)
    thread.join();
  ::_exit(0);
}
} // namespace

// As on AMD's processors with AVX-512, where OpenBLAS takes the kernels of AVX2.
TEST(Kernels, AreThoseOfTheProcessorWhereOpenBlasTakesOlderOnes)
{
#if defined(__x86_64__)
  constexpr const char *variable = "OPENBLAS_CORETYPE";
  dlopen("libopenblas.so.0", RTLD_NOW | RTLD_GLOBAL); // this binary needs no BLAS otherwise
  const auto name = of_openblas<char *()>("openblas_get_corename");
  if (name == nullptr || of_openblas<void()>("gotoblas_dynamic_init") == nullptr ||
      !__builtin_cpu_supports("avx2"))
    GTEST_SKIP() << "no OpenBLAS that chooses, or no AVX2";
  const char *const given = std::getenv(variable);
  const std::string wanted = given == nullptr ? "" : given;
  for (const std::string older : {"Prescott", "Haswell"})
  {
    ::setenv(variable, older.c_str(), 1);
    choose_kernels_again();
    ASSERT_EQ(name(), older);
    use_kernels_of_this_processor();
    EXPECT_EQ(name(), older) << "what the environment asks for, it gets";
    ::unsetenv(variable);
    use_kernels_of_this_processor();
    EXPECT_STREQ(name(), __builtin_cpu_supports("avx512vl") ? "SkylakeX" : "Haswell");
  }
  wanted.empty() ? ::unsetenv(variable) : ::setenv(variable, wanted.c_str(), 1);
  choose_kernels_again();
#else
  GTEST_SKIP() << "kernels are chosen for x86-64 alone";
#endif
}

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

/// OpenBLAS looks for room for ever where there is none. SIGALRM ends what waits.
TEST(ThreadsDeathTest, HaveTheBuffersOfBlasThatAreMapped)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs the whole of the address space";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(multiply_without_address_space(), testing::ExitedWithCode(0), "");
}

TEST(Threads, HaveAllBuffersWithoutALimit)
{
  EXPECT_EQ(map_blas_buffers(5), 5U);
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
