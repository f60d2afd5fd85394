// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/log.h>
#include <orthocone/simulation/run_folder.h>

#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// A .pvd file, which names the field files of a run. It can only be replaced as a whole, which would cost
/// more and more from step to step: additions are written when the last time was a while ago, or by flush().
class FieldList
{
public:
  FieldList(const RunFolder &folder, const std::string &name);

  /// Name of the field file of a step.
  std::string field_file(unsigned int step) const;

  /// Names the files of these steps and no others; without any there is no .pvd file.
  void set(const std::vector<unsigned int> &steps);
  void add(unsigned int step);

  /// Whether `step` or a later one has been added.
  bool has(unsigned int step) const;

  /// Brings the .pvd file up to date.
  void flush();

private:
  const RunFolder &folder_;
  std::string name_;
  std::vector<std::pair<double, std::string>> files_;
  bool is_up_to_date_ = true;
  Stopwatch since_writing_;
  double least_seconds_ = 0; ///< from one writing to the next
};
} // namespace orthocone
