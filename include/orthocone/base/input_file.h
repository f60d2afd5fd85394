// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace orthocone
{
/// An open file that comes from outside: it may be anything. Opening does not wait, reading is bounded by the
/// caller, and a pipe that nobody writes into is given up. All functions throw FileError, which begins with
/// the file's name.
class InputFile
{
public:
  enum class Links
  {
    followed,
    refused, ///< only for the last part of the path
  };

  /// `name` is the file's name in messages.
  InputFile(const std::filesystem::path &path, std::string name, Links links = Links::followed);
  ~InputFile();
  InputFile(const InputFile &) = delete;
  InputFile &operator=(const InputFile &) = delete;

  bool is_ordinary() const { return is_ordinary_; }
  bool is_folder() const { return is_folder_; }

  /// Bytes of an ordinary file when it was opened; 0 for others.
  std::uintmax_t size() const { return size_; }

  /// Goes to this byte of an ordinary file.
  void go_to(std::uintmax_t place);

  /// Reads up to `most` bytes into `bytes` and returns their number; 0 at the end. Waits for a pipe's writer,
  /// five seconds at most for one that never comes.
  std::size_t read(char *bytes, std::size_t most);

  /// The bytes from here on, `most` at most.
  std::string read(std::size_t most);

private:
  [[noreturn]] void fail(int cause) const;

  std::string name_;
  int descriptor_;
  bool is_pipe_ = false;
  bool is_folder_ = false;
  bool is_ordinary_ = false;
  bool has_read_ = false;
  std::uintmax_t size_ = 0;
};
} // namespace orthocone
