// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace orthocone::test
{
/// A run folder that is gone after the test.
struct ScratchFolder
{
  ScratchFolder()
      : path(std::filesystem::temp_directory_path() / ("orthocone-folder-" + std::to_string(::getpid())))
  {
  }
  ~ScratchFolder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};
} // namespace orthocone::test
