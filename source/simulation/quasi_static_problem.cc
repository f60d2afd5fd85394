// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/quasi_static_problem.h>

#include <orthocone/parameters/text.h>
#include <orthocone/simulation/version.h>
#include <orthocone/simulation/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
/// Returns what `work` returns and adds its wall time to `seconds`.
template<typename Work>
auto timed(double &seconds, const Work &work)
{
  struct Adder
  {
    ~Adder() { total += watch.seconds(); }
    double &total;
    Stopwatch watch;
  } adder{seconds, {}};
  return work();
}

OrthotropicFriction friction_of(const FrictionOptions &options)
{
  return {options.mu[0], options.mu[1], options.p[0], options.p[1]};
}

std::string numbered(const std::string &name, const unsigned int step)
{
  constexpr std::size_t digits = 4;
  const std::string number = std::to_string(step);
  return name + "-" + std::string(digits - std::min(digits, number.size()), '0') + number + ".vtu";
}

void add_record(const RunFolder &folder, const std::string &name, const LoadStep &step,
                std::vector<std::pair<double, std::string>> &files)
{
  files.emplace_back(step.number, numbered(name, step.number));
  std::ostringstream text;
  dealii::DataOutBase::write_pvd_record(text, files);
  folder.write(name + ".pvd", text.str());
}

bool is_due(const unsigned int interval, const unsigned int step, const unsigned int n_steps)
{
  return interval != 0 && (step % interval == 0 || step == n_steps);
}
} // namespace

Body::Body(const Parameters &parameters, const SymmetryPlanes &planes)
    : mesh(timed(seconds.mesh, [&] { return BodyMesh(parameters.geometry, parameters.mesh, planes); })),
      discretization(timed(
          seconds.mesh, [&]
          { return Discretization(mesh.triangulation(), parameters.mesh, parameters.geometry.top_face); }))
{
}

QuasiStaticProblem::QuasiStaticProblem(const Parameters &parameters, const ModelChoice &model,
                                       const RunFolder &folder, Log &log)
    : parameters_(parameters),
      model_(model),
      folder_(folder),
      log_(log),
      steps_(load_steps(parameters.load)),
      body_(parameters_, model_.planes),
      factor_(factorize()),
      axes_(parameters_.friction.angle),
      condensed_(timed(body_.seconds.condensation,
                       [&] { return CondensedBody(body_.discretization, factor_, axes_); })),
      problem_(condensed_.compliance(),
               std::vector<OrthotropicFriction>(body_.discretization.contact_surface().nodes.size(),
                                                friction_of(parameters_.friction))),
      solver_(condensed_, problem_, parameters_.contact_solver),
      state_(problem_.n_nodes()),
      evaluator_(body_.discretization.contact_surface(), model_.planes, axes_,
                 friction_of(parameters_.friction)),
      history_(folder_, parameters_.contact_solver.method),
      probes_(folder_, parameters_.output.probes, evaluator_),
      summary_{"running", parameters_, model_, body_.discretization, static_cast<unsigned int>(steps_.size())}
{
}

StiffnessFactor QuasiStaticProblem::factorize()
{
  log_.line(describe_model(parameters_, model_, body_.discretization, steps_.size()));
  for (const auto &[name, version] : versions())
    log_.line(name + " " + version);
  const Stiffness stiffness =
      timed(body_.seconds.assembly, [&] { return Stiffness(body_.discretization, parameters_.material); });
  return timed(body_.seconds.factorization,
               [&] { return StiffnessFactor(stiffness.matrix(), body_.discretization.n_interior()); });
}

QuasiStaticProblem::Outcome QuasiStaticProblem::run()
{
  Outcome outcome{true, ""};
  log_.start_steps();
  for (const LoadStep &step : steps_)
  {
    double seconds = 0;
    const SolverReport report = timed(seconds, [&] { return solver_.solve(state_, step); });
    body_.seconds.contact += seconds;
    if (!report.converged)
    {
      outcome = failure(step, report);
      break;
    }
    timed(body_.seconds.output, [&] { write_step(step, report, seconds); });
  }
  finish(outcome);
  return outcome;
}

void QuasiStaticProblem::write_step(const LoadStep &step, const SolverReport &report, const double seconds)
{
  const Totals totals = compute_totals(evaluator_, state_, condensed_.compliance());
  history_.write(state_, totals, report, seconds);
  probes_.write(state_);
  write_fields(step);
  log_.progress(step, steps_.size(), totals, report);
  summary_.n_solved = step.number;
  summary_.n_iterations += report.iterations;
  summary_.largest_residual = std::max(summary_.largest_residual, report.residual);
  summary_.total_dissipation = totals.total_dissipation;
  summary_.peaks.consider(step.number, totals);
}

void QuasiStaticProblem::write_fields(const LoadStep &step)
{
  const OutputOptions &options = parameters_.output;
  if (is_due(options.contact_interval, step.number, steps_.size()))
  {
    folder_.write(numbered("contact", step.number), contact_vtu(evaluator_, state_));
    add_record(folder_, "contact", step, contact_files_);
  }
  if (is_due(options.volume_interval, step.number, steps_.size()))
  {
    folder_.write(numbered("volume", step.number),
                  volume_vtu(body_.discretization, parameters_.material,
                             condensed_.volume_displacement(state_.top, state_.force)));
    add_record(folder_, "volume", step, volume_files_);
  }
}

void QuasiStaticProblem::finish(const Outcome &outcome)
{
  summary_.status = outcome.is_complete ? "complete" : outcome.message;
  summary_.seconds = body_.seconds;
  summary_.total_seconds = total_.seconds();
  folder_.write("summary.json", summary_json(summary_));
  const PhaseSeconds &seconds = summary_.seconds;
  std::ostringstream text;
  text << std::fixed;
  text.precision(2);
  text << "seconds: mesh " << seconds.mesh << ", assembly " << seconds.assembly << ", factorization "
       << seconds.factorization << ", condensation " << seconds.condensation << ", contact "
       << seconds.contact << ", output " << seconds.output << ", total " << summary_.total_seconds
       << "; files in " << folder_.path();
  log_.line(text.str());
}

QuasiStaticProblem::Outcome QuasiStaticProblem::failure(const LoadStep &step,
                                                        const SolverReport &report) const
{
  const auto &place = body_.discretization.contact_surface().nodes[report.worst_node].position;
  const ContactSolverOptions &options = parameters_.contact_solver;
  std::ostringstream text;
  text << "load step " << step.number << " of " << steps_.size() << " (u_z = " << to_text(step.top[2])
       << " mm) is not solved by " << to_word(options.method) << ", not even in eighths: residual "
       << report.residual << " > tolerance " << options.tolerance << ", penetration " << report.penetration
       << " mm, worst node at (" << place[0] << ", " << place[1] << ") mm after " << report.iterations
       << " iterations.\nThe files of the steps before stay. ";
  if (!std::isfinite(report.residual))
    text << "The forces are no longer numbers: are lengths in mm, forces in N, moduli in MPa?";
  else if (options.method == ContactMethod::newton)
    text << "Try more Contact solver/Maximum iterations, or a tolerance that rounding allows.";
  else
    text << "Try Contact solver/Method = newton, or more Maximum iterations.";
  return {false, text.str()};
}
} // namespace orthocone
