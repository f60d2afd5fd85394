// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/output/run_folder.h>
#include <orthocone/results/line_fields.h>

#include <map>
#include <string>
#include <vector>

namespace orthocone
{
/// Names of the files that belong to a run because its parameters name them: the tables of its probes, and
/// those of its lines with '#' in place of the step.
std::vector<std::string> named_files(const OutputOptions &output);

/// line-NAME-NNNN.csv: the fields along each line after a step. All writing throws FileError.
class LineFiles
{
public:
  /// `folder` and `evaluator` must outlive this object. Throws as LinePoints does.
  LineFiles(RunFolder &folder, const std::vector<Line> &lines, const ContactFieldEvaluator &evaluator);

  bool is_empty() const { return lines_.empty(); }

  /// Whether a line has points in the lower body, whose deformation must then be known.
  bool need_lower() const;

  /// Writes the files of a state, once; `lower` counts where need_lower().
  void write(const ContactState &state, const Deformation &upper, const Deformation &lower);

  /// Whether the files of this state are written.
  bool has(const ContactState &state) const { return last_step_ >= state.step; }

  /// Steps whose files are written, as in FieldSteps.
  std::map<std::string, std::vector<unsigned int>> steps() const;

  /// As if no later step than this one had been written, and of earlier ones these.
  void return_to(unsigned int step, const std::map<std::string, std::vector<unsigned int>> &steps);

private:
  struct Named
  {
    std::string name;
    LineFields fields;
    std::vector<unsigned int> steps;
  };

  RunFolder &folder_;
  const ContactFieldEvaluator &evaluator_;
  std::vector<Named> lines_;
  unsigned int last_step_ = 0;
};
} // namespace orthocone
