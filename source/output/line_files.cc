// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/line_files.h>

#include <orthocone/output/field_list.h>
#include <orthocone/output/history.h>
#include <orthocone/results/tables.h>

#include <algorithm>

namespace orthocone
{
std::vector<std::string> named_files(const OutputOptions &output)
{
  std::vector<std::string> names = probe_files(output.probes);
  for (const Line &line : output.lines)
    names.push_back("line-" + line.name + "-#.csv");
  return names;
}

LineFiles::LineFiles(RunFolder &folder, const std::vector<Line> &lines,
                     const ContactFieldEvaluator &evaluator)
    : folder_(folder),
      evaluator_(evaluator)
{
  for (const Line &line : lines)
    lines_.push_back({line.name, LineFields(line, evaluator), {}});
}

bool LineFiles::need_lower() const
{
  return std::any_of(lines_.begin(), lines_.end(),
                     [](const Named &line) { return line.fields.is_in_lower(); });
}

void LineFiles::write(const ContactState &state, const Deformation &upper, const Deformation &lower)
{
  const std::vector<ContactFields> contact = evaluator_.all_fields(state);
  for (Named &line : lines_)
  {
    std::string text = header_line(line_columns());
    for (const LinePoint &point : line.fields.at(contact, upper, lower))
      text += row_line(line_columns(), point);
    folder_.write(field_file("line-" + line.name, state.step, "csv"), text);
    line.steps.push_back(state.step);
  }
  last_step_ = state.step;
}

std::map<std::string, std::vector<unsigned int>> LineFiles::steps() const
{
  std::map<std::string, std::vector<unsigned int>> steps;
  for (const Named &line : lines_)
    steps[line.name] = line.steps;
  return steps;
}

void LineFiles::return_to(const unsigned int step,
                          const std::map<std::string, std::vector<unsigned int>> &steps)
{
  last_step_ = step;
  for (Named &line : lines_)
    if (const auto written = steps.find(line.name); written != steps.end())
      line.steps = written->second;
}
} // namespace orthocone
