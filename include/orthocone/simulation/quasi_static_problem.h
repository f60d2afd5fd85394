// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/history.h>
#include <orthocone/simulation/log.h>
#include <orthocone/simulation/step_solver.h>
#include <orthocone/simulation/summary.h>

namespace orthocone
{
/// Mesh and unknowns of the body: all that --check needs. Holds the wall times of all phases, of which its
/// own are the first.
struct Body
{
  Body(const Parameters &parameters, const SymmetryPlanes &planes);

  PhaseSeconds seconds;
  BodyMesh mesh;
  Discretization discretization;
};

/// A body on the rigid plane through a load program, step after step. Owns every module by value; the member
/// list is the wiring diagram of the program.
class QuasiStaticProblem
{
public:
  /// What came of a run; `message` tells the user what failed.
  struct Outcome
  {
    bool is_complete;
    std::string message;
  };

  /// Builds, factorizes and condenses the body. Throws InputError or FileError. `folder` must outlive the
  /// problem.
  QuasiStaticProblem(const Parameters &parameters, const ModelChoice &model, const RunFolder &folder,
                     Log &log);

  /// Solves all steps and writes the run folder. The files of solved steps stay if one fails.
  Outcome run();

private:
  StiffnessFactor factorize();
  void write_step(const LoadStep &step, const SolverReport &report, double seconds);
  void write_fields(const LoadStep &step);
  void finish(const Outcome &outcome);
  Outcome failure(const LoadStep &step, const SolverReport &report) const;

  const Parameters parameters_;
  const ModelChoice model_;
  const RunFolder &folder_;
  Log &log_;
  const std::vector<LoadStep> steps_;
  Stopwatch total_;
  Body body_;
  StiffnessFactor factor_;
  SurfaceAxes axes_;
  CondensedBody condensed_;
  ContactProblem problem_;
  StepSolver solver_;
  ContactState state_;
  ContactFieldEvaluator evaluator_;
  History history_;
  ProbeHistories probes_;
  std::vector<std::pair<double, std::string>> contact_files_; ///< step number and file of the PVD record
  std::vector<std::pair<double, std::string>> volume_files_;
  Summary summary_;
};
} // namespace orthocone
