// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_output.h>

#include <orthocone/parameters/errors.h>
#include <orthocone/simulation/vtu.h>

#include <algorithm>

namespace orthocone
{
RunOutput::RunOutput(const RunFolder &folder, const Parameters &parameters, const ContactModel &model)
    : folder_(folder),
      options_(parameters.output),
      material_(parameters.material),
      last_step_(load_steps(parameters.load).size()),
      model_(model),
      history_(folder, parameters.contact_solver.method),
      probes_(folder, parameters.output.probes, model.evaluator()),
      cycles_(folder),
      contact_(folder, "contact"),
      volume_(folder, "volume")
{
}

void RunOutput::start() const
{
  history_.start();
  probes_.start();
  cycles_.start();
}

bool RunOutput::is_due(const unsigned int interval, const unsigned int step) const
{
  return interval != 0 && (step % interval == 0 || step == last_step_);
}

/// Steps up to `step` that have a field file.
std::vector<unsigned int> RunOutput::due_steps(const unsigned int interval, const unsigned int step,
                                               const std::vector<StepRange> &jumped) const
{
  std::vector<unsigned int> steps;
  for (unsigned int number = 1; number <= step; ++number)
    if (is_due(interval, number))
      steps.push_back(number);
  for (const StepRange &range : jumped)
    steps.erase(std::lower_bound(steps.begin(), steps.end(), range.first),
                std::upper_bound(steps.begin(), steps.end(), range.last));
  return steps;
}

void RunOutput::return_to(const unsigned int step, const bool is_last, const std::vector<StepRange> &jumped,
                          const std::map<std::string, std::uintmax_t> &table_sizes)
{
  if (is_last)
    last_step_ = step;
  const auto contact = due_steps(options_.contact_interval, step, jumped);
  const auto volume = due_steps(options_.volume_interval, step, jumped);
  require_fields(contact_, contact);
  require_fields(volume_, volume);
  folder_.cut_tables(table_sizes);
  contact_.set(contact);
  volume_.set(volume);
  folder_.remove_fields_after(step);
}

void RunOutput::require_fields(const FieldList &list, const std::vector<unsigned int> &steps) const
{
  for (const unsigned int step : steps)
    if (!folder_.has(list.field_file(step)))
      throw FileError(folder_.path(list.field_file(step)) +
                      ": is missing, so that the run cannot be continued; without --resume it starts anew");
}

void RunOutput::write(const SolvedStep &step)
{
  history_.write(step);
  probes_.write(step.state);
  write_fields(step.state, step.checks.volume);
}

void RunOutput::write_fields(const ContactState &state, const Eigen::VectorXd &volume)
{
  if (is_due(options_.contact_interval, state.step) && !contact_.has(state.step))
    contact_.add(state.step, [this, state] { return contact_vtu(model_.evaluator(), state); });
  if (is_due(options_.volume_interval, state.step) && !volume_.has(state.step))
    volume_.add(state.step, [this, u = model_.condensed().with_motion(state.top, volume)]
                { return model_.body().vtu(material_, u); });
}

void RunOutput::end_with(const ContactState &state)
{
  last_step_ = state.step;
  write_fields(state, model_.condensed().elastic_displacement(state.force));
}

void RunOutput::flush()
{
  contact_.flush();
  volume_.flush();
}
} // namespace orthocone
