// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The CSV files of a run. Nothing in them depends on the clock but timing.csv: the same run with the same
// number of threads gives the same bytes.
#pragma once

#include <orthocone/contact/contact_solver.h>
#include <orthocone/parameters/options.h>
#include <orthocone/simulation/run_folder.h>
#include <orthocone/simulation/step_checks.h>
#include <orthocone/simulation/totals.h>

namespace orthocone
{
/// A solved step, as the tables tell it.
struct SolvedStep
{
  const ContactState &state;
  const Totals &before; ///< of the step before
  const Totals &totals;
  const SolverReport &report;
  const StepChecks &checks;
  double seconds; ///< of the solver
};

/// history.csv, checks.csv and timing.csv: one row a step.
class History
{
public:
  History(const RunFolder &folder, ContactMethod method);

  /// Starts the tables with the names of their columns.
  void start() const;
  void write(const SolvedStep &step) const;

private:
  const RunFolder &folder_;
  ContactMethod method_;
};

/// probe-NAME.csv: the node nearest to each probe, in the image where the probe lies.
class ProbeHistories
{
public:
  ProbeHistories(const RunFolder &folder, const std::vector<Probe> &probes,
                 const ContactFieldEvaluator &evaluator);

  /// Starts the tables that are not there yet.
  void start(const TableMarks &there) const;
  void write(const ContactState &state) const;

private:
  struct Place
  {
    std::string file;
    unsigned int node;
    Eigen::Matrix2d map; ///< from the model to the image
  };

  const RunFolder &folder_;
  const ContactFieldEvaluator &evaluator_;
  std::vector<Place> places_;
};
} // namespace orthocone
