// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "launch.h"

#include <orthocone/base/ranks.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace orthocone
{
Launch::Launch(const int argc, const char *const *const argv)
{
  const bool is_batch =
      std::any_of(argv, argv + argc, [](const std::string &word) { return word == "--batch"; });
  if (!is_launched() || is_batch)
  {
    forget_launcher();
    return;
  }
  static std::string name = "orthocone";
  static std::array<char *, 2> words{{name.data(), nullptr}};
  int n_words = 1; // libraries must not read the other words
  char **first_word = words.data();
  session_.emplace(n_words, first_word, 1);
  if (!is_first_rank())
  {
    nowhere_.open("/dev/null");
    before_ = std::cout.rdbuf(nowhere_.rdbuf());
  }
}

/// Processes of a batch are runs of their own, each of which may start MPI.
void Launch::forget_launcher()
{
  std::vector<std::string> names;
  for (char **variable = environ; *variable != nullptr; ++variable)
    for (const std::string start : {"OMPI_COMM_WORLD_", "OMPI_MCA_ess", "OMPI_MCA_orte_", "PMIX_", "PMI_"})
      if (std::string(*variable).compare(0, start.size(), start) == 0)
        names.push_back(std::string(*variable).substr(0, std::string(*variable).find('=')));
  for (const std::string &name : names)
    ::unsetenv(name.c_str());
}

Launch::~Launch()
{
  if (before_ != nullptr)
    std::cout.rdbuf(before_);
}

void Launch::end(const int code)
{
  if (code == 0)
    session_.reset();
  else if (session_)
    MPI_Abort(MPI_COMM_WORLD, code); // others may wait for this one
}

void leave_word_to_first_rank()
{
  constexpr std::chrono::seconds enough{10};
  if (!is_first_rank())
    std::this_thread::sleep_for(enough);
}
} // namespace orthocone
