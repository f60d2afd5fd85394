// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_output.h>

#include <orthocone/parameters/errors.h>
#include <orthocone/simulation/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <sstream>

namespace orthocone
{
namespace
{
std::string numbered(const std::string &name, const unsigned int step)
{
  constexpr std::size_t digits = 4;
  const std::string number = std::to_string(step);
  return name + "-" + std::string(digits - std::min(digits, number.size()), '0') + number + ".vtu";
}

bool is_due(const unsigned int interval, const unsigned int step, const unsigned int n_steps)
{
  return interval != 0 && (step % interval == 0 || step == n_steps);
}
} // namespace

RunOutput::RunOutput(const RunFolder &folder, const Parameters &parameters, const ContactModel &model)
    : folder_(folder),
      options_(parameters.output),
      material_(parameters.material),
      n_steps_(load_steps(parameters.load).size()),
      model_(model),
      history_(folder, parameters.contact_solver.method),
      probes_(folder, parameters.output.probes, model.evaluator())
{
}

void RunOutput::start() const
{
  history_.start();
  probes_.start();
}

void RunOutput::return_to(const unsigned int step,
                          const std::map<std::string, std::uintmax_t> &table_sizes) const
{
  require_fields("contact", options_.contact_interval, step);
  require_fields("volume", options_.volume_interval, step);
  folder_.cut_tables(table_sizes);
  write_records("contact", options_.contact_interval, step);
  write_records("volume", options_.volume_interval, step);
  folder_.remove_fields_after(step);
}

void RunOutput::require_fields(const std::string &name, const unsigned int interval,
                               const unsigned int step) const
{
  for (unsigned int number = 1; number <= step; ++number)
    if (is_due(interval, number, n_steps_) && !folder_.has(numbered(name, number)))
      throw FileError(folder_.path(numbered(name, number)) +
                      ": is missing, so that the run cannot be continued; without --resume it starts anew");
}

/// The .pvd file, which names the field files of all steps up to `step`.
void RunOutput::write_records(const std::string &name, const unsigned int interval,
                              const unsigned int step) const
{
  std::vector<std::pair<double, std::string>> files;
  for (unsigned int number = 1; number <= step; ++number)
    if (is_due(interval, number, n_steps_))
      files.emplace_back(number, numbered(name, number));
  if (files.empty())
    return folder_.remove(name + ".pvd");
  std::ostringstream text;
  dealii::DataOutBase::write_pvd_record(text, files);
  folder_.write(name + ".pvd", text.str());
}

void RunOutput::write(const SolvedStep &step) const
{
  const ContactState &state = step.state;
  history_.write(step);
  probes_.write(state);
  if (is_due(options_.contact_interval, state.step, n_steps_))
  {
    folder_.write(numbered("contact", state.step), contact_vtu(model_.evaluator(), state));
    write_records("contact", options_.contact_interval, state.step);
  }
  if (is_due(options_.volume_interval, state.step, n_steps_))
  {
    folder_.write(
        numbered("volume", state.step),
        model_.body().vtu(material_, model_.condensed().volume_displacement(state.top, state.force)));
    write_records("volume", options_.volume_interval, state.step);
  }
}
} // namespace orthocone
