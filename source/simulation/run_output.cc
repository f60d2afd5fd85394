// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_output.h>

#include <orthocone/parameters/errors.h>
#include <orthocone/simulation/vtu.h>

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
  probes_.start({});
  cycles_.start();
}

bool RunOutput::is_due(const unsigned int interval, const unsigned int step) const
{
  return interval != 0 && (step % interval == 0 || step == last_step_);
}

void RunOutput::return_to(const unsigned int step, const TableMarks &tables, const FieldSteps &fields)
{
  require_fields(contact_, fields.contact);
  require_fields(volume_, fields.volume);
  folder_.cut_tables(tables);
  probes_.start(tables);
  contact_.set(fields.contact);
  volume_.set(fields.volume);
  folder_.remove_fields_after(step);
}

void RunOutput::require_fields(const FieldList &list, const std::vector<unsigned int> &steps) const
{
  for (const unsigned int step : steps)
    if (const std::string file = list.field_file(step);
        !folder_.has(file) || !folder_.ends_with(file, "</VTKFile>\n"))
      throw FileError(folder_.path(file) + (folder_.has(file) ? ": is cut off" : ": is missing") +
                      ", so that the run cannot be continued; without --resume it starts anew");
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
