// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/machine_load.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <thread>

namespace orthocone
{
namespace
{
/// Seconds that all cores were busy since the machine was started; negative where nothing is known.
double busy_seconds()
{
  // "cpu user nice system idle iowait irq softirq ...", in ticks
  std::ifstream file("/proc/stat");
  std::string word;
  std::array<double, 7> ticks{};
  file >> word;
  for (double &tick : ticks)
    file >> tick;
  const auto [user, nice, system, idle, iowait, irq, softirq] = ticks;
  return file && word == "cpu"
             ? (user + nice + system + irq + softirq) / static_cast<double>(sysconf(_SC_CLK_TCK))
             : -1;
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
