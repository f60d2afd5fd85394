// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The parameter files that come with the program, for --list and --new.
#pragma once

#include <filesystem>
#include <string>

namespace orthocone
{
/// Their folder beside the running program: in its source tree, or where it is installed. Throws FileError if
/// there is neither.
std::filesystem::path folder_of_shipped_scenes();

/// A line for each parameter file of a folder and its subfolders: the path, which can be run as it is, and
/// the first sentence of the comment at its head. Throws FileError for a file that cannot be read.
std::string shipped_scenes(const std::filesystem::path &folder);

/// Copies the rig of this name, a file of the folder "rigs", to a new file. Throws InputError for a name that
/// is none and for a file that exists or ends in another way than .prm, and FileError where it cannot be
/// written.
void copy_rig(const std::string &rig, const std::string &file);
} // namespace orthocone
