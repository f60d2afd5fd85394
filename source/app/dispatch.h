// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
/// Does what a command line asks for. Returns the exit code, whatever happens.
int guarded_dispatch(int argc, const char *const *argv);
} // namespace orthocone
