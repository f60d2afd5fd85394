// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <cstdint>
#include <string>
#include <vector>

namespace orthocone
{
/// Arrays of numbers in an HDF5 file. All functions throw FileError, which names the file and the array, for
/// what cannot be read or written.
class Hdf5File
{
public:
  enum class Access
  {
    read,
    extend,
  };

  Hdf5File(std::string name, Access access);
  ~Hdf5File();
  Hdf5File(const Hdf5File &) = delete;
  Hdf5File &operator=(const Hdf5File &) = delete;

  /// Whether there is such a group or array; all groups on the path may be missing.
  bool has(const std::string &path) const;

  /// Whether there is such an array, and values were written to it.
  bool has_values(const std::string &path) const;

  std::vector<int> integers(const std::string &path) const;
  Eigen::VectorXd numbers(const std::string &path) const;

  /// The single integer of an array.
  int integer(const std::string &path) const;

  void make_group(const std::string &path);
  void write(const std::string &path, const Eigen::VectorXd &values);

  /// Closes the file. Before this the content may not be on the disk.
  void close();

  /// Bytes of the file when it was opened.
  std::uintmax_t size() const { return size_; }

  [[noreturn]] void fail(const std::string &what) const;

private:
  std::string name_;
  long long id_ = -1;
  std::uintmax_t size_ = 0;
};
} // namespace orthocone
