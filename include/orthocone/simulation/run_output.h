// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/contact_model.h>
#include <orthocone/simulation/history.h>
#include <orthocone/simulation/load_program.h>

namespace orthocone
{
/// The files of a run that grow with its steps: tables and fields. Holds no memory of earlier steps.
class RunOutput
{
public:
  /// All but `parameters` must outlive the output.
  RunOutput(const RunFolder &folder, const Parameters &parameters, const ContactModel &model);

  /// Starts the tables.
  void start() const;

  /// Brings the files back to what they were after `step`, when the tables had these sizes. Throws FileError
  /// before it touches anything, if they cannot be.
  void return_to(unsigned int step, const std::map<std::string, std::uintmax_t> &table_sizes) const;

  void write(const SolvedStep &step) const;

private:
  void require_fields(const std::string &name, unsigned int interval, unsigned int step) const;
  void write_records(const std::string &name, unsigned int interval, unsigned int step) const;

  const RunFolder &folder_;
  const OutputOptions options_;
  const MaterialOptions material_;
  const unsigned int n_steps_;
  const ContactModel &model_;
  const History history_;
  const ProbeHistories probes_;
};
} // namespace orthocone
