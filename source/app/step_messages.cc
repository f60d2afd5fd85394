// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "step_messages.h"

#include <orthocone/base/version.h>
#include <orthocone/contact/solvers/diagnosis.h>
#include <orthocone/output/motion_text.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/parameters.h>

#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
/// "load step 3 of 45 (u_z = -0.06 mm)".
std::string name_of(const LoadStep &step, const LoadSteps &steps)
{
  return "load step " + std::to_string(step.number) + " of " + std::to_string(steps.size()) + " (" +
         MotionText(steps.different(), steps.loads())(step, " = ") + ")";
}
} // namespace

std::string unsolved_step_text(const LoadStep &step, const LoadSteps &steps,
                               const ContactSolverOptions &options, const SolverReport &report,
                               const Scene &scene)
{
  const auto &worst = scene.surface().nodes[report.worst_node];
  const bool is_dense = scene.system().compliance().dense() != nullptr;
  std::ostringstream text;
  text << name_of(step, steps) << " is not solved by " << options.method
       << ", not even in eight parts, or from a state without forces: residual " << report.residual
       << " > tolerance " << options.tolerance << ", penetration " << report.penetration
       << " mm, worst node at (" << worst.position[0] << ", " << worst.position[1] << ") mm after "
       << report.iterations << " iterations.\nThe files of earlier steps are kept. "
       << diagnosis(options, report, is_dense);
  return text.str();
}

/// What a body without a held face can do where contact does not hold it: "along z and about y".
static std::string motions_in_words(const std::vector<unsigned int> &components)
{
  std::string text;
  for (const unsigned int component : components)
    text += (text.empty()                       ? ""
             : &component == &components.back() ? " and "
                                                : ", ") +
            std::string(component < 3 ? "along " : "about ") + "xyz"[component % 3];
  return text;
}

std::string no_equilibrium_text(const LoadStep &step, const LoadSteps &steps, const double carried,
                                const BodyUnknowns &unknowns)
{
  constexpr double percent = 100;
  const std::vector<unsigned int> &loose = unknowns.loose_components();
  std::ostringstream text;
  text << name_of(step, steps) << " has no equilibrium: the load on the "
       << (loose.empty() ? "held face" : "body") << " is more than contact and friction can carry"
       << (loose.empty() ? "" : ", which alone hold it " + motions_in_words(loose)) << ".\nThe first "
       << std::setprecision(3) << percent * carried
       << " % of the leg are carried (to 1 %), and the files of earlier steps are kept. ";
  if (step.by_force[2] && step.force[2] > 0)
    text << "A positive Fz pulls the body off, and a negative one presses it.";
  else
    text << "Take smaller forces in this leg, or a motion.";
  return text.str();
}

std::string broken_step_text(const LoadStep &step, const LoadSteps &steps, const std::string &why)
{
  return name_of(step, steps) + " is not solved: " + why + ". The files of earlier steps are kept";
}

std::string too_few_jumps_text(const std::size_t n_computed, const std::size_t n_left)
{
  return std::to_string(n_computed) + " load steps are computed, and no more are allowed, but " +
         std::to_string(n_left) +
         " are left, because too few cycles were jumped: take a larger bound for "
         "jumps (Load program/Jump when periodic, Load program/Jump change of friction, Wear/Largest depth "
         "of a "
         "jump), or fewer Cycles";
}

std::string wrong_step_text(const LoadStep &step, const LoadSteps &steps, const std::string &which,
                            const BodyBackend backend)
{
  const std::string remedy = backend == BodyBackend::multigrid
                                 ? ", and Mesh/Backend = condensed solves hard steps more exactly."
                                 : ".";
  return name_of(step, steps) + " is solved, but fails a check: " + which +
         ".\nThe files of earlier steps are kept" +
         (which.rfind("Checks/", 0) == 0 ? "; section Checks sets the bounds" + remedy : ".");
}

void report_versions_and_warnings(const Parameters &parameters, Log &log)
{
  for (const auto &[name, version] : versions())
    log.note(name + " " + version);
  for (const std::string &warning : parameter_warnings(parameters))
    log.line("warning: " + warning);
}
} // namespace orthocone
