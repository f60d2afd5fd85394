// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/machine_load.h>

#include <orthocone/base/text.h>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace orthocone
{
namespace
{
/// Seconds that the cores of this process' affinity have been busy since the machine was started; of all
/// cores where a container has given them other numbers; negative where nothing is known.
double busy_seconds()
{
  cpu_set_t mask;
  CPU_ZERO(&mask);
  if (sched_getaffinity(0, sizeof mask, &mask) != 0)
    return -1;
  std::ifstream file("/proc/stat");
  double all = -1, matched = 0;
  int n_matched = 0;
  for (std::string line; std::getline(file, line) && line.compare(0, 3, "cpu") == 0;)
  {
    // "cpu3 user nice system idle iowait irq softirq ...", in ticks; the first line is of all cores
    std::istringstream words(line);
    std::string name;
    std::array<double, 7> ticks{};
    words >> name;
    for (double &tick : ticks)
      words >> tick;
    if (!words)
      continue;
    const auto [user, nice, system, idle, iowait, irq, softirq] = ticks;
    const double busy = user + nice + system + irq + softirq;
    const auto core = parse_count(name.substr(3));
    if (name == "cpu")
      all = busy;
    else if (core && *core < CPU_SETSIZE && CPU_ISSET(*core, &mask))
    {
      matched += busy;
      ++n_matched;
    }
  }
  return (n_matched == CPU_COUNT(&mask) ? matched : all) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double own_seconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}
} // namespace

MachineLoad::MachineLoad()
    : start_(Clock::now()),
      busy_(busy_seconds()),
      by_own_(own_seconds())
{
}

double MachineLoad::busy_cores() const
{
  constexpr std::chrono::milliseconds least(50); // five ticks of the kernel
  std::this_thread::sleep_until(start_ + least);
  const double now = busy_seconds();
  if (busy_ < 0 || now < 0)
    return 0;
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  return std::max(0., (now - busy_) - (own_seconds() - by_own_)) / elapsed.count();
}
} // namespace orthocone
