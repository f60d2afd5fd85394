// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <filesystem>
#include <string>

namespace orthocone
{
/// Folder that receives the files of one run. All writing throws FileError, naming file and cause.
class RunFolder
{
public:
  /// Creates the folder if need be and makes sure that files can be written there.
  explicit RunFolder(const std::filesystem::path &path);

  /// Removes the files that an earlier run left; whatever else lies there stays.
  void remove_earlier_run() const;

  /// The file appears under its name only when complete.
  void write(const std::string &name, const std::string &content) const;

  /// Appends in one piece.
  void append(const std::string &name, const std::string &content) const;

  std::string path(const std::string &name = "") const;

private:
  std::filesystem::path path_;
};
} // namespace orthocone
