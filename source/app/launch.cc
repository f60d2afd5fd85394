// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "launch.h"

#include <orthocone/base/ranks.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <streambuf>
#include <string>
#include <thread>
#include <vector>

namespace orthocone
{
struct Launch::Mpi
{
  /// Discards what is written.
  class Nowhere : public std::streambuf
  {
    int_type overflow(const int_type character) override { return traits_type::not_eof(character); }
  };

  Mpi()
  {
    int argc = 1; // libraries must not read the other words
    char **argv = words.data();
    session = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
    if (!is_first_rank())
      before = std::cout.rdbuf(&nowhere);
  }

  ~Mpi()
  {
    if (before != nullptr)
      std::cout.rdbuf(before);
  }
  Mpi(const Mpi &) = delete;
  Mpi &operator=(const Mpi &) = delete;

  std::string name = "orthocone";
  std::array<char *, 2> words{{name.data(), nullptr}};
  Nowhere nowhere;
  std::streambuf *before = nullptr;
  std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> session;
};

Launch::Launch(const int argc, const char *const *const argv)
{
  const bool is_batch =
      std::any_of(argv, argv + argc, [](const std::string &word) { return word == "--batch"; });
  if (is_launched() && !is_batch)
    mpi_ = std::make_unique<Mpi>();
  else
    forget_launcher();
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

Launch::~Launch() = default;

void Launch::end(const int code)
{
  if (code == 0)
    mpi_.reset();
  else if (mpi_ != nullptr)
    MPI_Abort(MPI_COMM_WORLD, code); // others may wait for this one
}

void leave_word_to_first_rank()
{
  constexpr std::chrono::seconds enough{10};
  if (!is_first_rank())
    std::this_thread::sleep_for(enough);
}
} // namespace orthocone
