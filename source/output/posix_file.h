// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Operations on files that the standard library lacks: writing with the cause of a failure, to the disk,
// under a lock. All functions throw FileError, which names file and cause.
#pragma once

#include <orthocone/output/run_folder.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace orthocone::posix
{
/// Creates a file, or replaces one. A symbolic link is replaced, not followed.
void write(const std::filesystem::path &file, const std::string &content);

/// Appends, and returns the new size; on failure the file is cut back to its old content. `size` is the size
/// (bytes) that the file must have before; without it the file is created if necessary. A symbolic link is
/// not followed.
std::uintmax_t append(const std::filesystem::path &file, const std::string &content,
                      std::optional<std::uintmax_t> size);

/// Content of a file of a run folder, which must be an ordinary one of `most` bytes at most. A symbolic link
/// is not followed.
std::string read(const std::filesystem::path &file, std::size_t most);

/// Passes the first `size` bytes of such a file to `use`, in pieces. Returns whether the file has so many.
bool read_pieces(const std::filesystem::path &file, std::uintmax_t size,
                 const std::function<void(const char *piece, std::size_t n)> &use);

/// The first `size` bytes, or all of a shorter file.
std::string head(const std::filesystem::path &file, std::size_t size);

/// The last `size` bytes, or all of a shorter file.
std::string tail(const std::filesystem::path &file, std::size_t size);

void rename(const std::filesystem::path &from, const std::filesystem::path &to);

/// Cuts an ordinary file. A symbolic link is not followed.
void cut(const std::filesystem::path &file, std::uintmax_t size);

/// The identity of a file or folder; a default one where it does not exist.
Identity identity(const std::filesystem::path &file);

/// Returns when the content of a file, or the names in a folder, are on the disk.
void synchronize(const std::filesystem::path &file);

/// Lock of a folder, which the system releases with the descriptor, however the process ends.
struct FolderLock
{
  int descriptor;
  bool is_taken; ///< whether another process has it; false where the file system has no locks
};
FolderLock lock_folder(const std::filesystem::path &folder);

void close(int descriptor);
} // namespace orthocone::posix
