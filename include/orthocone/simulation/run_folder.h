// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace orthocone
{
/// Folder that receives the files of one run. All writing throws FileError, naming file and cause, and leaves
/// what was written before as it was.
class RunFolder
{
public:
  /// Creates the folder if need be and makes sure that no other run writes there until this object is
  /// destroyed (or the process ends in whatever way).
  explicit RunFolder(const std::filesystem::path &path);
  ~RunFolder();
  RunFolder(const RunFolder &) = delete;
  RunFolder &operator=(const RunFolder &) = delete;

  /// Removes the files that an earlier run left; whatever else lies there stays. `parameters` becomes the
  /// content of parameters.prm, which marks the folder as one of a run, and as one of this run.
  void start_anew(const std::string &parameters) const;

  /// Removes the field files of steps after `step`.
  void remove_fields_after(unsigned int step) const;

  /// The file appears under its name only when complete.
  void write(const std::string &name, const std::string &content) const;

  /// The same, and the file is on the disk, as are all that were written before, when this returns.
  void write_durably(const std::string &name, const std::string &content) const;

  /// Appends in one piece.
  void append(const std::string &name, const std::string &content) const;

  /// Content of a file. Throws FileError.
  std::string read(const std::string &name) const;

  bool has(const std::string &name) const;
  void remove(const std::string &name) const;

  /// Sizes of the CSV files, which grow from step to step.
  std::map<std::string, std::uintmax_t> table_sizes() const;

  /// Throws FileError if a CSV file is missing, shorter than this, or has no line that ends there.
  void require_tables(const std::map<std::string, std::uintmax_t> &sizes) const;

  /// Cuts the CSV files back to these sizes, if all are long enough, and removes the others.
  void cut_tables(const std::map<std::string, std::uintmax_t> &sizes) const;

  std::string path(const std::string &name = "") const;

private:
  void lock();
  std::filesystem::path write_part(const std::string &name, const std::string &content, bool durably) const;
  void replace(const std::string &name, const std::string &content, bool durably) const;

  std::filesystem::path path_;
  int lock_ = -1;                             ///< descriptor of the folder itself
  mutable std::set<std::string> not_on_disk_; ///< files written since the last write_durably()
};
} // namespace orthocone
