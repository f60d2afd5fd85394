// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/control_group.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace orthocone
{
namespace
{
/// The names between the colons of "4:cpu,cpuacct:/path" are separated by commas.
bool has_controller(const std::string &line, const std::string &controller)
{
  const std::size_t first = line.find(':');
  const std::size_t last = line.find(':', first + 1);
  if (first == std::string::npos || last == std::string::npos)
    return false;
  const std::string names = "," + line.substr(first + 1, last - first - 1) + ",";
  return names.find("," + controller + ",") != std::string::npos;
}
} // namespace

double least_in_control_groups(const std::string &controller,
                               const std::function<double(const std::string &, bool)> &limit_in)
{
  double limit = std::numeric_limits<double>::infinity();
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
} // namespace orthocone
