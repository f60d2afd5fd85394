// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/output/field_list.h>
#include <orthocone/output/history.h>
#include <orthocone/output/line_files.h>
#include <orthocone/results/cycles.h>
#include <orthocone/scene/load_program.h>

namespace orthocone
{
/// The files of a run that grow with its steps: tables and fields. It knows earlier steps only by the names
/// of their files. Writing throws FileError.
class RunOutput
{
public:
  /// All arguments but `options` must outlive the output.
  RunOutput(RunFolder &folder, const OutputOptions &options, const Scene &scene,
            const ContactFieldEvaluator &evaluator);

  /// Starts the tables.
  void start();

  /// Takes the files back to their content after `step`, with these tables and fields. Probes that are new
  /// since then get tables that begin here. The files must be those that find_checkpoint() has checked.
  void return_to(unsigned int step, const TableMarks &tables, const FieldSteps &fields);

  void write(const SolvedStep &step);
  void write(const CycleRow &row) { cycles_.write(row); }

  /// Writes the problem of StepSolver::unsolved(), whatever the interval of problems, unless this is 0.
  void write_unsolved(const LoadStep &step, const ContactStep &problem);

  /// Writes the fields that are due after the last step of a run that ends before its program does.
  void end_with(const ContactState &state);

  /// Steps whose field files are written; complete after flush().
  FieldSteps fields() const { return {contact_.steps(), volume_.steps(), lines_.steps()}; }

  /// Writes the field files that are still in the making, and brings the .pvd files up to date.
  void flush();

private:
  bool is_due(unsigned int interval, unsigned int step) const;
  std::string problem_file(unsigned int step) const;
  Deformation deformation(const ContactState &state, const Eigen::VectorXd &volume) const;
  Deformation lower_deformation(const ContactState &state) const;
  void write_volume(const ContactState &state, const Eigen::VectorXd &volume);
  void write_lower(const ContactState &state);
  void write_lines(const ContactState &state, const Eigen::VectorXd &volume);
  void write_fields(const ContactState &state, const Eigen::VectorXd &volume);

  RunFolder &folder_;
  const OutputOptions options_;
  unsigned int last_step_; ///< of the program, or of the run if it ended earlier
  const Scene &scene_;
  const ContactFieldEvaluator &evaluator_;
  History history_;
  ProbeHistories probes_;
  LineFiles lines_;
  CycleTable cycles_;
  FieldList contact_;
  FieldList volume_;
  FieldList lower_; ///< the steps of volume_, if there is such a body
};
} // namespace orthocone
