// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "batch_child.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace orthocone
{
/// What a batch runs.
struct BatchProgram
{
  Runner run;

  /// Whether the run of these words may be forked by a keeper, which calls `prepare` with them before.
  std::function<bool(const std::vector<std::string> &)> can_prepare;
  std::function<void(const std::vector<std::string> &)> prepare;
};

/// --batch: runs each line of standard input, a JSON array of words, in a process of its own. That process is
/// a copy of this one, whose libraries are loaded already, or of a keeper beside it, which has prepared the
/// run: loading and preparing take longer than a small run. Each line is answered with one line: {"exit":
/// code (or 128 + the signal that ended it), "cpu_seconds": of the run and its preparation, "seconds":,
/// "message": its error output, "output": its standard output}.
///
/// `jobs` is the number of runs at a time. With 0 it is one after the other; otherwise answers come in the
/// order in which runs end, with "line", the number of their line from 1. Ctrl-C ends the batch with the
/// answers of the present runs. Returns whether all lines were answered. Throws FileError where an answer
/// cannot be written.
bool run_batch(const BatchProgram &program, unsigned int jobs, std::ostream &answers);
} // namespace orthocone
