/* SPDX-License-Identifier: LGPL-2.1-or-later
 * Copyright (C) 2026 the orthocone authors
 *
 *   siconos_solve FILE solve SOLVER BOUND TOLERANCE SECONDS   solves a local problem of FCLIB by Siconos
 *   siconos_solve FILE time [SOLVER TOLERANCE]...             solves again: a line with seconds for each
 *
 * The first prints info, iterations, tolerance, seconds, error, merit and the difference to the solution in
 * FILE. TOLERANCE, the solver's own, is tightened until the error is within BOUND. Each solution may take
 * SECONDS of CPU time. Exit code 3: no tolerance does; killed by SIGPROF: it takes too long.
 */
#include "fclib_problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <fc3d_Solvers.h>

#define F3D(name) SICONOS_FRICTION_3D_##name

/* A solver, its solver of one node, and options with their values; -1 ends them. */
typedef struct
{
  const char *name;
  int id, local;
  int options[5];
} Preset;

/* What Siconos' manual names first, and of its options those that served best on a sample of the problems. */
static const Preset presets[] = {
    {"nsgs", F3D(NSGS), 0, {-1}},
    {"nsgs-ac", F3D(NSGS), F3D(ONECONTACT_NSN), {-1}},
    {"nsgs-pli", F3D(NSGS), F3D(ONECONTACT_ProjectionOnConeWithLocalIteration), {-1}},
    {"nsn-ac", F3D(NSN_AC), 0, {F3D(NSN_LINEAR_SOLVER), F3D(NSN_USE_CSLUSOL), -1}},
    {"nsn-ac-new", F3D(NSN_AC_TEST), 0, {-1}},
    {"nsn-hybrid", F3D(NSN_AC_TEST), 0, {F3D(NSN_HYBRID_STRATEGY), F3D(NSN_HYBRID_STRATEGY_VI_EG_NSN), -1}},
    {"admm", F3D(ADMM), 0, {-1}},
    {"admm-balanced",
     F3D(ADMM),
     0,
     {F3D(ADMM_IPARAM_RHO_STRATEGY), F3D(ADMM_RHO_STRATEGY_RESIDUAL_BALANCING), -1}},
};

static double seconds(void)
{
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time); /* CPU time, if the library of cpu_clock.c is loaded before */
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static int compare(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static NumericsMatrix *dense(const struct fclib_matrix *matrix)
{
  const int n = matrix->n;
  NumericsMatrix *full = NM_create(NM_DENSE, n, n);
  memset(full->matrix0, 0, sizeof(double) * (size_t)n * (size_t)n);
  for (int j = 0; j < n; ++j)
    for (int k = matrix->p[j]; k < matrix->p[j + 1]; ++k)
      full->matrix0[(size_t)j * (size_t)n + (size_t)matrix->i[k]] = matrix->x[k];
  return full;
}

static SolverOptions *options_of(const Preset *preset, const double tolerance)
{
  const int many = 1000000; /* the clock stops it before */
  SolverOptions *options = solver_options_create(preset->id);
  if (preset->local != 0)
    solver_options_update_internal(options, 0, preset->local);
  for (const int *option = preset->options; *option >= 0; option += 2)
    options->iparam[option[0]] = option[1];
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = many;
  return options;
}

typedef struct
{
  int info, iterations;
  double tolerance, seconds;
  Judgement judgement;
} Answer;

/* CPU time after which SIGPROF ends the program; 0: never. */
static void set_alarm(const double limit)
{
  const struct itimerval timer = {{0, 0}, {(time_t)limit, (suseconds_t)(1e6 * (limit - floor(limit)))}};
  setitimer(ITIMER_PROF, &timer, NULL);
}

/* Solves from no force. */
static void solve(const Problem *problem, const Preset *preset, const double limit, Answer *answer)
{
  const int n = problem->local->W->n;
  FrictionContactProblem *siconos = frictionContactProblem_new();
  SolverOptions *options = options_of(preset, answer->tolerance);
  double *force = vector(n), *velocity = vector(n);
  siconos->dimension = 3;
  siconos->numberOfContacts = n / 3;
  siconos->M = dense(problem->local->W);
  siconos->q = problem->local->q;
  siconos->mu = problem->local->mu;
  memcpy(velocity, problem->local->q, sizeof(double) * (size_t)n);
  set_alarm(limit);
  const double begin = seconds();
  answer->info = fc3d_driver(siconos, force, velocity, options);
  answer->seconds = seconds() - begin;
  set_alarm(0);
  answer->iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  judge(problem, force, &answer->judgement);
  solver_options_delete(options);
  NM_clear(siconos->M);
  free(siconos->M);
  free(siconos);
  free(force);
  free(velocity);
}

/* Whether a tolerance was found that does. */
static int tighten(const Problem *problem, const Preset *preset, const double bound, const double limit,
                   Answer *answer)
{
  enum
  {
    careful = 4,
    attempts = 10
  };
  for (int i = 0; i < attempts; ++i)
  {
    solve(problem, preset, limit, answer);
    if (answer->judgement.error <= bound)
      return 1;
    const double wanted = 0.7 * bound / answer->judgement.error;
    answer->tolerance *= i < careful && isfinite(wanted) ? fmin(0.5, wanted) : 0.1;
  }
  return 0;
}

/* The median of seconds; the longer it takes, the fewer solutions. */
static double again(const Problem *problem, const Preset *preset, const double tolerance)
{
  enum
  {
    most = 9
  };
  const double enough = 0.05;
  double times[most] = {0}, sum = 0;
  int done = 0;
  while (done < most && sum < enough)
  {
    Answer answer = {0, 0, tolerance, 0, {0, 0, 0}};
    solve(problem, preset, 0, &answer);
    times[done++] = answer.seconds;
    sum += answer.seconds;
  }
  qsort(times, (size_t)done, sizeof *times, compare);
  return times[done / 2];
}

static int finish(const Answer *answer, const int is_solved)
{
  printf("%d,%d,%.3g,%.4g,", answer->info, answer->iterations, answer->tolerance, answer->seconds);
  print_judgement(&answer->judgement);
  return is_solved ? 0 : 3;
}

static const Preset *find_preset(const char *name)
{
  for (size_t i = 0; i < sizeof presets / sizeof *presets; ++i)
    if (strcmp(presets[i].name, name) == 0)
      return presets + i;
  return or_stop(NULL, "no such solver");
}

int main(const int n_arguments, char **arguments)
{
  const char *usage = "FILE solve SOLVER BOUND TOLERANCE SECONDS | FILE time [SOLVER TOLERANCE]...";
  if (n_arguments < 4)
    or_stop(NULL, usage);
  const Problem problem = read_problem(arguments[1]);
  Answer answer = {0, 0, 0, 0, {0, 0, 0}};
  if (strcmp(arguments[2], "time") == 0)
  {
    for (int i = 3; i + 1 < n_arguments; i += 2)
      printf("%.4g\n", again(&problem, find_preset(arguments[i]), atof(arguments[i + 1])));
    return 0;
  }
  if (n_arguments != 7)
    or_stop(NULL, usage);
  answer.tolerance = atof(arguments[5]);
  return finish(
      &answer, tighten(&problem, find_preset(arguments[3]), atof(arguments[4]), atof(arguments[6]), &answer));
}
