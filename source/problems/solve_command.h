// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace orthocone
{
/// The program orthocone-solve. Returns its exit code.
int solve_command(const std::vector<std::string> &arguments, std::ostream &out, std::ostream &errors);
} // namespace orthocone
