// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace orthocone
{
/// Runs a command line, without the name of the program, and returns its exit code.
using Runner = std::function<int(const std::vector<std::string> &)>;

/// --batch: runs each line of `lines`, a JSON array of words, in a process of its own. That process is a copy
/// of this one, whose libraries are loaded already: loading them takes longer than a small run. Each line is
/// answered with one line: {"exit": code (or 128 + the signal that ended it), "cpu_seconds": of the run,
/// "seconds":, "message": its error output, "output": its standard output}. Ctrl-C ends the batch with the
/// answer of the present run. Returns whether all lines were answered.
bool run_batch(std::istream &lines, std::ostream &answers, const Runner &run);
} // namespace orthocone
