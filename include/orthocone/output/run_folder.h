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

/// What a CSV file was at a moment, from its first byte on.
struct TableMark
{
  std::uintmax_t size = 0;    ///< bytes
  std::uint32_t checksum = 0; ///< CRC-32

  bool operator==(const TableMark &other) const { return size == other.size && checksum == other.checksum; }
};

/// Marks of the CSV files by their names.
using TableMarks = std::map<std::string, TableMark>;

/// Folder that receives the files of one run. All writing throws FileError, naming file and cause, and leaves
/// what was written before as it was. Where several processes share a run, the first one has the folder.
/// Those of the others have no path: they are empty, and what is written there is gone.
class RunFolder
{
public:
  /// Creates the folder if need be and makes sure that no other run writes there until this object is
  /// destroyed (or the process ends in whatever way).
  explicit RunFolder(const std::optional<std::filesystem::path> &path);
  ~RunFolder();
  RunFolder(const RunFolder &) = delete;
  RunFolder &operator=(const RunFolder &) = delete;

  /// Throws FileError where files of a run's names lie in the folder that no run has made. `probes`: the
  /// tables that the run is going to write for its probes.
  void require_own(const std::vector<std::string> &probes) const;

  /// Removes the files that an earlier run left; whatever else lies there stays. `parameters` becomes the
  /// content of parameters.prm, which distinguishes the run from others. `parameter_file` and
  /// `probes` are kept, too; returns the parameter file of the earlier run, if it was another one.
  std::optional<std::string> start_anew(const std::string &parameters, const std::string &parameter_file,
                                        const std::vector<std::string> &probes) const;

  /// Keeps which tables of probes are the run's; others are the user's.
  void mark(const std::string &parameter_file, const std::vector<std::string> &probes) const;

  /// Removes the field files of steps after `step`.
  void remove_fields_after(unsigned int step) const;

  /// The file appears under its name only when complete.
  void write(const std::string &name, const std::string &content) const;

  /// The same, and the file is on the disk, as are all that were written before, when this returns.
  void write_durably(const std::string &name, const std::string &content) const;

  /// The place of a file that a library writes by itself: as NAME.part, then under its name.
  std::filesystem::path place_for(const std::string &name) const;

  /// Appends in one piece. Throws FileError if the file is not what this run has left.
  void append(const std::string &name, const std::string &content) const;

  /// Content of a file. Throws FileError.
  std::string read(const std::string &name) const;

  bool has(const std::string &name) const;
  bool is_nowhere() const { return path_.empty(); }

  /// Whether the file is there and its last bytes are these.
  bool ends_with(const std::string &name, const std::string &end) const;
  void remove(const std::string &name) const;

  /// Marks of the CSV files that this run has written or gone on with.
  TableMarks tables() const;

  /// Throws FileError if a CSV file is missing or does not begin with what it was.
  void require_tables(const TableMarks &marks) const;

  /// Cuts the CSV files back to these marks, which they must fit, and removes the others.
  void cut_tables(const TableMarks &marks) const;

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
  void require_same_folder() const;
  bool is_of_a_run() const;
  std::vector<std::string> marked_lines() const;
  std::vector<std::string> own_tables() const;
  std::vector<std::string> files() const;
  std::filesystem::path write_part(const std::string &name, const std::string &content, bool durably) const;
  void replace(const std::string &name, const std::string &content, bool durably) const;

  std::filesystem::path path_;
  int lock_ = -1;                                  ///< descriptor of the folder itself
  posix::Identity identity_{};                     ///< of the folder when the run began
  mutable std::set<std::string> not_on_disk_;      ///< files written since the last write_durably()
  mutable std::map<std::string, Growing> growing_; ///< files that append() has written
};
} // namespace orthocone
