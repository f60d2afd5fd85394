// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/machine.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace orthocone
{
namespace
{
constexpr double bytes_of_gigabyte = 1e9;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Address space beyond the libraries' that every run needs: two buffers of OpenBLAS and stacks of threads.
constexpr double least_address_space = 0.55e9;
/// The part of an estimate that stands for the program itself, which is mapped already.
constexpr double mapped_program = 0.15e9;

double page_size()
{
  return static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// The number at the beginning of a file; infinite if there is none, as in "max".
double number_in(const std::string &file)
{
  std::ifstream stream(file);
  double value = 0;
  return stream >> value ? value : infinity;
}

/// The limit of a control group, bytes.
double memory_of_group(const std::string &folder, const bool is_unified)
{
  return number_in(folder + (is_unified ? "/memory.max" : "/memory.limit_in_bytes"));
}

/// The number behind a word at the beginning of a line; infinite if there is no such line.
double number_behind(const std::string &word, const std::string &file)
{
  std::ifstream stream(file);
  std::string first;
  for (double value = 0; stream >> first;)
    if (first == word && stream >> value)
      return value;
  return infinity;
}

/// What a control group has left, bytes; files that it has read give their memory back.
double memory_left_in_group(const std::string &folder, const bool is_unified)
{
  const double used = number_in(folder + (is_unified ? "/memory.current" : "/memory.usage_in_bytes")),
               cached = number_behind(is_unified ? "inactive_file" : "total_inactive_file",
                                      folder + "/memory.stat"),
               limit = memory_of_group(folder, is_unified);
  return std::isfinite(limit) && std::isfinite(used) ? limit - used + (std::isfinite(cached) ? cached : 0)
                                                     : infinity;
}

/// How many cores' time a control group allows. Its file has "quota period"; in version 1 these are two
/// files. Infinite for "max" and -1.
double cores_of_group(const std::string &folder, const bool is_unified)
{
  double quota = -1, period = 0;
  if (is_unified)
    std::ifstream(folder + "/cpu.max") >> quota >> period;
  else
  {
    std::ifstream(folder + "/cpu.cfs_quota_us") >> quota;
    std::ifstream(folder + "/cpu.cfs_period_us") >> period;
  }
  return quota > 0 && period > 0 ? quota / period : infinity;
}

/// The cores of this process' affinity; none where the system does not tell.
cpu_set_t own_cores()
{
  cpu_set_t mask;
  CPU_ZERO(&mask);
  if (sched_getaffinity(0, sizeof mask, &mask) != 0)
    CPU_ZERO(&mask);
  return mask;
}

/// Seconds that the cores of this process have been busy since the machine was started; of all cores where a
/// container has given them other numbers; negative where nothing is known.
double busy_seconds()
{
  const cpu_set_t mask = own_cores();
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
    const auto [user, nice, system, idle, iowait, irq, softirq] = ticks;
    const double busy = user + nice + system + irq + softirq;
    if (!words)
      continue;
    if (const auto core = parse_count(name.substr(3)); !core)
      all = busy;
    else if (*core < CPU_SETSIZE && CPU_ISSET(*core, &mask))
    {
      matched += busy;
      ++n_matched;
    }
  }
  const bool is_matched = n_matched > 0 && n_matched == CPU_COUNT(&mask);
  return (is_matched ? matched : all) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Processor time of all threads of this process.
double own_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The names between the colons of "4:cpu,cpuacct:/path" are separated by commas.
bool has_controller(const std::string &line, const std::string &controller)
{
  const std::size_t first = line.find(':'), last = line.find(':', first + 1);
  return last != std::string::npos &&
         ("," + line.substr(first + 1, last - first - 1) + ",").find("," + controller + ",") !=
             std::string::npos;
}
} // namespace

double least_in_control_groups(const std::string &controller,
                               const std::function<double(const std::string &, bool)> &limit_in)
{
  double limit = infinity;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
  {
    const bool is_unified = line.compare(0, 3, "0::") == 0;
    if (!is_unified && !has_controller(line, controller))
      continue;
    const std::string root = is_unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/" + controller;
    std::string path = line.substr(line.rfind(':') + 1);
    // Within a container the path may be the host's, and the root is the container's own group.
    for (;; path.erase(path.rfind('/')))
    {
      limit = std::min(limit, limit_in(root + path, is_unified));
      if (path.find('/') == std::string::npos)
        break;
    }
  }
  return limit;
}

MemoryLimit memory_limit()
{
  MemoryLimit limit{static_cast<double>(sysconf(_SC_PHYS_PAGES)) * page_size() / bytes_of_gigabyte,
                    "this machine has"};
  const auto consider = [&limit](const double bytes, const char *const source)
  {
    if (bytes / bytes_of_gigabyte < limit.gigabytes)
      limit = {bytes / bytes_of_gigabyte, source};
  };
  consider(least_in_control_groups("memory", memory_of_group), "the control group allows");
  consider(std::max(0., free_address_space() - least_address_space) + mapped_program, "'ulimit -v' leaves");
  return limit;
}

double free_gigabytes()
{
  constexpr double kilobyte = 1024;
  return std::min(kilobyte * number_behind("MemAvailable:", "/proc/meminfo"),
                  least_in_control_groups("memory", memory_left_in_group)) /
         bytes_of_gigabyte;
}

double free_address_space()
{
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return infinity;
  const double pages = number_in("/proc/self/statm");
  return static_cast<double>(limit.rlim_cur) - (std::isfinite(pages) ? pages * page_size() : 0);
}

void require_address_space()
{
  const double available = free_address_space();
  if (available >= least_address_space)
    return;
  std::ostringstream text;
  text.precision(2);
  text << "memory: 'ulimit -v' leaves " << std::max(0., available) / bytes_of_gigabyte
       << " GB of address space beside the libraries; allowed is " << least_address_space / bytes_of_gigabyte
       << " GB and more, or 'ulimit -v unlimited'";
  throw InputError(text.str());
}

UsableCores usable_cores()
{
  const cpu_set_t mask = own_cores();
  const long n = CPU_COUNT(&mask) > 0 ? CPU_COUNT(&mask) : sysconf(_SC_NPROCESSORS_ONLN);
  const auto allowed = static_cast<unsigned int>(std::max(1L, n));
  const double granted = std::ceil(least_in_control_groups("cpu", cores_of_group));
  return {allowed, granted < allowed ? static_cast<unsigned int>(std::max(1., granted)) : allowed};
}

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
