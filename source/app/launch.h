// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/mpi.h>

#include <fstream>
#include <optional>

namespace orthocone
{
/// The start and end of a process that mpirun has started with others. The first process prints for all.
class Launch
{
public:
  Launch(int argc, const char *const *argv);
  ~Launch();
  Launch(const Launch &) = delete;
  Launch &operator=(const Launch &) = delete;

  /// To be called when the exit code is known. If a process fails, mpirun ends the others.
  void end(int code);

private:
  static void forget_launcher();

  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> session_;
  std::ofstream nowhere_;            ///< takes what all processes but the first one print
  std::streambuf *before_ = nullptr; ///< of std::cout
};

/// Waits, so that the first process can say why all fail, and end them.
void leave_word_to_first_rank();
} // namespace orthocone
