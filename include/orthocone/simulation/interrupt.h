// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// From here on the first SIGINT or SIGTERM asks the program to stop after the present step; a second one
/// ends it at once. A file that grows beyond a limit of the system (SIGXFSZ) becomes a failed write.
void catch_signals();

/// Whether a signal asked to stop.
bool stop_is_requested();
} // namespace orthocone
