// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace orthocone::test
{
/// A folder with a folder "part" in it that is gone after the test.
class Folder
{
public:
  Folder()
      : path_(std::filesystem::temp_directory_path() / ("orthocone-test-" + std::to_string(::getpid())))
  {
    std::filesystem::create_directories(path_ / "part");
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  /// Writes a file and returns its path.
  std::string write(const std::string &name, const std::string &content) const
  {
    std::ofstream(path_ / name) << content;
    return path(name);
  }

  std::string path(const std::string &name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
};
} // namespace orthocone::test
