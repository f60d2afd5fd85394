// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "launch.h"

#include <orthocone/base/ranks.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <iostream>
#include <streambuf>
#include <string>
#include <thread>
#include <vector>

namespace orthocone
{
struct Launch::Mpi
{
  /// Takes what is written, and forgets it.
  class Nowhere : public std::streambuf
  {
    int_type overflow(const int_type character) override { return traits_type::not_eof(character); }
  };

  explicit Mpi(std::vector<std::string> given)
      : words(std::move(given))
  {
    for (std::string &word : words)
      pointers.push_back(word.data());
    int argc = static_cast<int>(pointers.size());
    pointers.push_back(nullptr);
    char **argv = pointers.data();
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

  std::vector<std::string> words;
  std::vector<char *> pointers;
  Nowhere nowhere;
  std::streambuf *before = nullptr;
  std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> session;
};

Launch::Launch(const int argc, const char *const *const argv)
{
  if (is_launched())
    mpi_ = std::make_unique<Mpi>(std::vector<std::string>(argv, argv + argc));
}

Launch::~Launch() = default;

void Launch::end(const int code)
{
  if (code == 0)
    mpi_.reset();
  else if (mpi_ != nullptr)
    static_cast<void>(mpi_.release()); // it would wait for the others
}

void leave_word_to_first_rank()
{
  constexpr std::chrono::seconds enough{10};
  if (!is_first_rank())
    std::this_thread::sleep_for(enough);
}
} // namespace orthocone
