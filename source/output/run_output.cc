// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/run_output.h>

#include <orthocone/base/ranks.h>
#include <orthocone/output/step_problem.h>
#include <orthocone/output/vtu.h>
#include <orthocone/surface/surface_tractions.h>

namespace orthocone
{
/// Without fields of a volume where the body has none.
static OutputOptions possible(OutputOptions options, const Scene &scene)
{
  if (!scene.body().mesh().has_mesh())
    options.volume_interval = 0;
  return options;
}

RunOutput::RunOutput(RunFolder &folder, const OutputOptions &options, const Scene &scene,
                     const ContactFieldEvaluator &evaluator)
    : folder_(folder),
      options_(possible(options, scene)),
      last_step_(scene.program().n_steps()),
      scene_(scene),
      evaluator_(evaluator),
      history_(folder, scene.parameters()),
      probes_(folder, options.probes, evaluator),
      lines_(folder, options.lines, evaluator),
      cycles_(folder, scene.parameters()),
      contact_(folder, "contact"),
      volume_(folder, "volume"),
      lower_(folder, "lower")
{
}

void RunOutput::start()
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
  folder_.cut_tables(tables);
  probes_.start(tables);
  contact_.set(fields.contact);
  volume_.set(fields.volume);
  if (scene_.lower() != nullptr)
    lower_.set(fields.volume);
  folder_.remove_fields_after(step);
  lines_.return_to(step, fields.lines);
}

void RunOutput::write(const SolvedStep &step)
{
  history_.write(step);
  probes_.write(step.state);
  write_fields(step.state, step.checks.volume);
  if (options_.problem_interval != 0 && step.state.step % options_.problem_interval == 0)
    write_step_problem(step, problem_file(step.state.step));
}

void RunOutput::write_unsolved(const LoadStep &step, const ContactStep &problem)
{
  if (options_.problem_interval != 0)
    write_unsolved_problem(step, problem, problem_file(step.number));
}

std::string RunOutput::problem_file(const unsigned int step) const
{
  return folder_.place_for(field_file("problem", step, "hdf5")).string();
}

void RunOutput::write_fields(const ContactState &state, const Eigen::VectorXd &volume)
{
  if (is_due(options_.contact_interval, state.step) && !contact_.has(state.step))
    // The fields of a counterface that gives way take a product with its compliance, which is not for two
    // threads.
    contact_.add(state.step,
                 [this, fields = evaluator_.all_fields(state)] { return contact_vtu(evaluator_, fields); });
  if (is_due(options_.volume_interval, state.step) && !volume_.has(state.step))
  {
    write_volume(state, volume);
    write_lower(state);
  }
  if (is_due(options_.line_interval, state.step) && !lines_.is_empty() && !lines_.has(state))
    write_lines(state, volume);
}

Deformation RunOutput::deformation(const ContactState &state, const Eigen::VectorXd &volume) const
{
  const Parameters &parameters = scene_.parameters();
  return {scene_.body().with_motion(state.motion, volume, state.loads),
          free_strain(parameters.load.loads, state.loads, false, parameters.material), state.motion,
          surface_tractions(scene_.surface(), scene_.axes(), state.force)};
}

/// Of the lower body's mirror image.
Deformation RunOutput::lower_deformation(const ContactState &state) const
{
  const Parameters &parameters = scene_.parameters();
  const ElasticBody &body = scene_.lower()->body();
  const NodeVector force = scene_.lower()->own_force(state.force);
  return {body.with_motion({}, body.elastic_displacement(force), state.loads),
          free_strain(parameters.load.loads, state.loads, true, parameters.lower.material),
          {},
          surface_tractions(body.surface(), LowerBody::own_axes(), force)};
}

/// The first process collects the pieces of the others, because it alone writes.
void RunOutput::write_volume(const ContactState &state, const Eigen::VectorXd &volume)
{
  const auto make = [this, found = deformation(state, volume)]
  { return volume_vtu(scene_.body().mesh(), found); };
  if (n_ranks() == 1)
    return volume_.add(state.step, make);
  volume_.add_pieces(state.step, gather_on_first(make()), volume_pvtu);
}

void RunOutput::write_lower(const ContactState &state)
{
  if (scene_.lower() == nullptr)
    return;
  const auto make = [this, found = lower_deformation(state)]
  {
    return volume_vtu(scene_.lower()->body().mesh(), found, scene_.parameters().lower.geometry.is_mirrored());
  };
  lower_.add(state.step, make);
}

void RunOutput::write_lines(const ContactState &state, const Eigen::VectorXd &volume)
{
  lines_.write(state, deformation(state, volume),
               lines_.need_lower() ? lower_deformation(state) : Deformation());
}

void RunOutput::end_with(const ContactState &state)
{
  last_step_ = state.step;
  write_fields(state, scene_.body().elastic_displacement(state.force));
}

void RunOutput::flush()
{
  contact_.flush();
  volume_.flush();
  lower_.flush();
}
} // namespace orthocone
