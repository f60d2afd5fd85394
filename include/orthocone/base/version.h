// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// Version and git revision of the program.
std::string program_version();

/// Names and versions of the program and of the libraries that compute. The BLAS is the one that runs.
std::vector<std::pair<std::string, std::string>> versions();
} // namespace orthocone
