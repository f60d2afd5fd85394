// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// From here on SIGINT, SIGTERM and SIGHUP end the program with the exit code of an interruption: at once,
/// until let_steps_finish() is called. A file that grows beyond a limit of the system (SIGXFSZ) becomes a
/// failed write. A screen that is gone (SIGPIPE) is no reason to stop.
void catch_signals();

/// From here on the first of these signals asks the program to stop after the present iteration; a second one
/// ends it at once.
void let_steps_finish();

/// Whether a signal asked to stop.
bool stop_is_requested();
} // namespace orthocone
