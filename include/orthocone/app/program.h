// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// The program: does what its command line asks for, and ends the process with the exit code. Who has kinds
/// of their own (kinds_of) adds them before. Has to be called from main(), once.
[[noreturn]] void run_program(int argc, const char *const *argv);
} // namespace orthocone
