// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/output/log.h>
#include <orthocone/output/run_folder.h>

#include <functional>
#include <future>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// Numbers of the steps that have a field file, in their order.
struct FieldSteps
{
  std::vector<unsigned int> contact;
  std::vector<unsigned int> volume;
  std::map<std::string, std::vector<unsigned int>> lines{}; ///< by the names of the lines
};

/// Name of the field file of a step. `kind` is "contact" or "volume". `ending` is "pvtu" for a file that
/// names the pieces of several processes.
std::string field_file(const std::string &kind, unsigned int step, const std::string &ending = "vtu");

/// Throws FileError if the field file of one of the steps is missing or cut off.
void require_fields(const RunFolder &folder, const std::string &kind, const std::vector<unsigned int> &steps);

/// The same for the files of lines.
void require_lines(const RunFolder &folder, const std::map<std::string, std::vector<unsigned int>> &lines);

/// The field files of a run and the .pvd file that names them. A thread of its own makes the content of a
/// file while the next step is solved; it is written when the next one comes. The .pvd file can only be
/// replaced as a whole, which costs more from step to step. So it is written only some time after the last
/// time, or by flush(). Writing throws FileError.
class FieldList
{
public:
  FieldList(RunFolder &folder, const std::string &name);

  /// Lists the files of these steps and no others; without steps there is no .pvd file.
  void set(const std::vector<unsigned int> &steps);

  /// Begins to make the field file of a step. `make` returns its content, and must not write anything else.
  void add(unsigned int step, const std::function<std::string()> &make);

  /// Writes the pieces of several processes. `list` returns the content of the file that names them.
  void add_pieces(unsigned int step, const std::vector<std::string> &pieces,
                  const std::function<std::string(const std::vector<std::string> &)> &list);

  /// Steps whose files are written.
  std::vector<unsigned int> steps() const;

  /// Whether `step` or a later one has been added.
  bool has(unsigned int step) const;

  /// Writes all that has been added, and brings the .pvd file up to date.
  void flush();

private:
  void write_pending();
  void write_file(unsigned int step, const std::string &file, const std::string &content);
  void write_list();

  RunFolder &folder_;
  std::string name_;
  std::vector<std::pair<double, std::string>> files_;
  bool is_up_to_date_ = true;
  Stopwatch since_writing_;
  double least_seconds_ = 0; ///< from one writing to the next
  unsigned int pending_step_ = 0;
  std::future<std::string> pending_;
};
} // namespace orthocone
