// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/memory.h>

#include <orthocone/base/control_group.h>
#include <orthocone/base/errors.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr double gigabyte = 1e9;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Address space beyond the libraries' that every run needs: buffers of OpenBLAS and stacks of threads.
constexpr double least_address_space = 0.4e9;

/// The part of an estimate that stands for the program itself, which is mapped already.
constexpr double program = 0.15e9;

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

/// The rest of the address space, bytes.
double free_address_space()
{
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return infinity;
  const double pages = number_in("/proc/self/statm");
  return static_cast<double>(limit.rlim_cur) - (std::isfinite(pages) ? pages * page_size() : 0);
}
} // namespace

MemoryLimit memory_limit()
{
  MemoryLimit limit{static_cast<double>(sysconf(_SC_PHYS_PAGES)) * page_size() / gigabyte,
                    "this machine has"};
  const auto consider = [&limit](const double bytes, const char *const source)
  {
    if (bytes / gigabyte < limit.gigabytes)
      limit = {bytes / gigabyte, source};
  };
  consider(least_in_control_groups("memory", memory_of_group), "the control group allows");
  consider(std::max(0., free_address_space() - least_address_space) + program, "'ulimit -v' leaves");
  return limit;
}

void require_address_space()
{
  const double available = free_address_space();
  if (available >= least_address_space)
    return;
  std::ostringstream text;
  text.precision(2);
  text << "memory: 'ulimit -v' leaves " << std::max(0., available) / gigabyte
       << " GB of address space beside the libraries; allowed is " << least_address_space / gigabyte
       << " GB and more, or 'ulimit -v unlimited'";
  throw InputError(text.str());
}
} // namespace orthocone
