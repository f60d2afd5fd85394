// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/fault_list.h>

#include <orthocone/base/errors.h>

#include <algorithm>

namespace orthocone
{
std::string FaultList::text() const
{
  const std::size_t n = faults_.size(), n_told = std::min(n, most_told);
  std::string all;
  for (std::size_t i = 0; i < n_told; ++i)
    all += (i == 0 ? "" : "; ") + faults_[i];
  if (n > n_told)
    all += "; and " + std::to_string(n - n_told) + (n == n_told + 1 ? " fault more" : " faults more");
  return all;
}

void FaultList::throw_if_any(const std::string &begin, const std::string &end) const
{
  if (!faults_.empty())
    throw InputError(begin + text() + end);
}

std::string enumeration(const std::vector<std::string> &things)
{
  constexpr std::size_t most = 4;
  const std::size_t n = things.size(), n_told = n > most ? most - 1 : n;
  std::string all;
  for (std::size_t i = 0; i < n_told; ++i)
    all += (i == 0 ? "" : i + 1 == n ? " and " : ", ") + things[i];
  return n > n_told ? all + " and " + std::to_string(n - n_told) + " more" : all;
}
} // namespace orthocone
