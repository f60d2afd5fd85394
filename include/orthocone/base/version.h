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

/// Name and version of the program and of the libraries that compute, BLAS as found running.
std::vector<std::pair<std::string, std::string>> versions();

/// What the BLAS that is running says of itself, or the file it comes from.
std::string running_blas();
} // namespace orthocone
