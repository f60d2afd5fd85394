// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Parameter files for tests.
#pragma once

#include <orthocone/base/errors.h>
#include <orthocone/parameters/parameters.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

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

/// The sentence with which a parameter file is rejected, or "" if it is not.
inline std::string rejection(const std::string &file, const std::vector<std::string> &overrides = {})
{
  try
  {
    read_parameters(file, overrides);
    return "";
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace orthocone::test
