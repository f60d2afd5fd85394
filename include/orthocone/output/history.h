// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The CSV files of a run. Only timing.csv depends on the clock: the same run with the same number of threads
// gives the same bytes in the others. All writing throws FileError.
#pragma once

#include <orthocone/output/run_folder.h>
#include <orthocone/results/cycles.h>
#include <orthocone/results/solved_step.h>
#include <orthocone/results/tables.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
/// history.csv, checks.csv and timing.csv: one row a step.
class History
{
public:
  History(RunFolder &folder, const Parameters &parameters);

  /// Starts the tables with the names of their columns.
  void start();
  void write(const SolvedStep &step);

private:
  RunFolder &folder_;
  const Columns<SolvedStep> columns_; ///< of history.csv
};

/// File names of the tables of these probes.
std::vector<std::string> probe_files(const std::vector<Probe> &probes);

/// probe-NAME.csv: the history of the node nearest to each probe, in the image where the probe lies.
class ProbeHistories
{
public:
  ProbeHistories(RunFolder &folder, const std::vector<Probe> &probes, const ContactFieldEvaluator &evaluator);

  /// Starts the tables that are not in `there`.
  void start(const TableMarks &there);
  void write(const ContactState &state);

private:
  struct Place
  {
    std::string file;
    unsigned int node;
    Eigen::Matrix2d map; ///< from the model to the image
  };

  RunFolder &folder_;
  const ContactFieldEvaluator &evaluator_;
  std::vector<Place> places_;
};

/// cycles.csv: a row for every completed cycle, and for cycles that are jumped.
class CycleTable
{
public:
  CycleTable(RunFolder &folder, const Parameters &parameters);

  void start();
  void write(const CycleRow &row);

private:
  RunFolder &folder_;
  const Columns<CycleRow> columns_;
};
} // namespace orthocone
