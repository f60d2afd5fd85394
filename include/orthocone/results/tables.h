// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The columns of the CSV files of a run. Readers find columns by name: new ones come at the end, none
// changes.
#pragma once

#include <orthocone/results/cycles.h>
#include <orthocone/results/line_fields.h>
#include <orthocone/results/solved_step.h>
#include <orthocone/results/table.h>

namespace orthocone
{
/// A contact node after a step, as the table of a probe lists it.
struct ProbedStep
{
  const ContactState &state;
  ContactFields fields; ///< of the image where the probe lies
};

/// The columns of history.csv, checks.csv, timing.csv, probe-NAME.csv, cycles.csv and line-NAME-NNNN.csv.
const Columns<SolvedStep> &history_columns();

/// The columns of history.csv with two more for each load: the load, and its conjugate.
Columns<SolvedStep> with_loads(Columns<SolvedStep> columns, const std::vector<Load> &loads);

/// The same with the columns of several contact surfaces behind, whose names begin with those of the
/// surfaces.
Columns<SolvedStep> with_surfaces(Columns<SolvedStep> columns, const std::vector<std::string> &surfaces);

/// The same with the columns of friction with memory behind, where there is one.
Columns<SolvedStep> with_factor(Columns<SolvedStep> columns, const FrictionOptions &friction);
Columns<CycleRow> with_factor(Columns<CycleRow> columns, const FrictionOptions &friction);
const Columns<SolvedStep> &checks_columns();
const Columns<SolvedStep> &timing_columns();
const Columns<ProbedStep> &probe_columns();
const Columns<CycleRow> &cycle_columns();
const Columns<LinePoint> &line_columns();

/// The output of --columns: a line for each column of the CSV files and each field of the VTU files, with
/// file, name, unit and meaning separated by tabs. docs/results.md is made from it.
std::string described_columns();
} // namespace orthocone
