// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Functions that the two halves of RunFolder share: writing (run_folder.cc), and the owners of files
// (run_folder_owner.cc).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace orthocone::run_folder
{
/// Throws FileError: "FILE: TASK (CAUSE)".
[[noreturn]] void fail(const std::filesystem::path &file, const std::string &task, const std::string &cause);

/// Throws FileError for a folder of the system, such as / or /etc, which the superuser could fill with
/// results.
void require_not_of_system(const std::filesystem::path &folder);

/// Names in a folder, sorted; none where there is no folder.
std::vector<std::string> names_in(const std::filesystem::path &folder);
} // namespace orthocone::run_folder
