// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <boost/crc.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
namespace posix
{
/// Device and inode: they distinguish a folder from another one that has taken its name.
using Identity = std::pair<std::uintmax_t, std::uintmax_t>;
} // namespace posix

/// Size and checksum of a CSV file at some moment, from its first byte on.
struct TableMark
{
  std::uintmax_t size = 0;    ///< bytes
  std::uint32_t checksum = 0; ///< CRC-32

  bool operator==(const TableMark &other) const { return size == other.size && checksum == other.checksum; }
};

/// Marks of the CSV files by their names.
using TableMarks = std::map<std::string, TableMark>;

/// Folder that receives the files of one run. All writing throws FileError, which names file and cause, and
/// leaves what was written before unchanged. Where several processes share a run, the first one has the
/// folder. The folders of the others have no path: they are empty, and what is written there is lost.
/// Nothing that a file of the folder says can name anything outside of it: all names are those of the
/// manifest (else FileError), and links are not followed.
class RunFolder
{
public:
  /// Creates the folder if necessary; a folder of the system is refused. No other run writes there until this
  /// object is destroyed, or the process ends in any way. Throws FileError.
  explicit RunFolder(const std::optional<std::filesystem::path> &path);
  ~RunFolder();
  RunFolder(const RunFolder &) = delete;
  RunFolder &operator=(const RunFolder &) = delete;

  /// Throws FileError where the folder has files with the names of a run's files that no run has made.
  /// `named` are named_files() of the run.
  void require_own(const std::vector<std::string> &named) const;

  /// Removes the files that an earlier run left; all others stay. `parameters` becomes the content of
  /// parameters.prm, which distinguishes the run from others. `parameter_file` and `named` are stored, too.
  /// Returns the parameter file of the earlier run, if it was another one.
  std::optional<std::string> start_anew(const std::string &parameters, const std::string &parameter_file,
                                        const std::vector<std::string> &named);

  /// Stores which tables of probes and files of lines belong to the run; others belong to the user.
  void mark(const std::string &parameter_file, const std::vector<std::string> &named);

  /// Removes the field files of steps after `step`.
  void remove_fields_after(unsigned int step);

  /// Writes a file, which appears under its name only when it is complete.
  void write(const std::string &name, const std::string &content);

  /// The same. When this returns, the file is on the disk, and so are all that were written before.
  void write_durably(const std::string &name, const std::string &content);

  /// The path for a file that a library writes by itself, as NAME.part and then under its name.
  std::filesystem::path place_for(const std::string &name);

  /// Appends in one piece. Throws FileError if the file is not as this run has left it.
  void append(const std::string &name, const std::string &content);

  /// Content of a file. Throws FileError if it cannot be read, is no ordinary file or larger than those of a
  /// run.
  std::string read(const std::string &name) const;

  /// Whether there is this file of a run; false for names that no run writes.
  bool has(const std::string &name) const;
  bool is_nowhere() const { return path_.empty(); }

  /// Whether the file exists and ends with these bytes.
  bool ends_with(const std::string &name, const std::string &end) const;
  void remove(const std::string &name);

  /// Marks of the CSV files that this run has written or continued.
  TableMarks tables() const;

  /// Throws FileError if a CSV file is missing or does not begin with its marked content.
  void require_tables(const TableMarks &marks) const;

  /// Cuts the CSV files back to these marks, which must fit them, and removes the others.
  void cut_tables(const TableMarks &marks);

  /// The folder, or a file in it, as messages show it.
  std::string path(const std::string &name = "") const;

private:
  /// A file that grows.
  struct Growing
  {
    std::uintmax_t size = 0;
    boost::crc_32_type crc{};
  };

  void lock();
  std::filesystem::path place_of(const std::string &name) const;
  void require_same_folder() const;
  bool is_of_a_run() const;
  /// The marked content of the tables. Throws as require_tables().
  std::map<std::string, Growing> marked_tables(const TableMarks &marks) const;
  std::vector<std::string> marked_lines() const;
  std::vector<std::string> own_tables() const;
  std::set<std::string> own_line_files() const;
  std::vector<std::string> files() const;
  std::filesystem::path write_part(const std::string &name, const std::string &content, bool durably);
  void replace(const std::string &name, const std::string &content, bool durably);

  std::filesystem::path path_;
  int lock_ = -1;                          ///< descriptor of the folder itself
  posix::Identity identity_{};             ///< of the folder when the run began
  std::set<std::string> not_on_disk_;      ///< files written since the last write_durably()
  std::map<std::string, Growing> growing_; ///< files that append() has written
};
} // namespace orthocone
