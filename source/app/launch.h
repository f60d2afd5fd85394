// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <memory>

namespace orthocone
{
/// The start and end of a process that mpirun has started with others. The first process prints for all.
class Launch
{
public:
  Launch(int argc, const char *const *argv);
  ~Launch();

  /// To be called when the exit code is known. If a process fails, mpirun ends the others.
  void end(int code);

private:
  static void forget_launcher();

  struct Mpi;
  std::unique_ptr<Mpi> mpi_;
};

/// Waits, so that the first process can say why all fail, and end them.
void leave_word_to_first_rank();
} // namespace orthocone
