/* SPDX-License-Identifier: LGPL-2.1-or-later
 * Copyright (C) 2026 the orthocone authors
 *
 * One local problem of FCLIB, solved by Siconos, or the solution in its file: prints info, iterations, the median of the
 * seconds of its solver, and FCLIB's measure of error (MERIT_1).
 *
 * The problem is scaled so that the largest entry of q and the mean of W's diagonal are 1, since neither Siconos' steps
 * nor FCLIB's measure do it: in N and mm both would depend on the units. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <fc3d_Solvers.h>
#include <fclib.h>

#define F3D(name) SICONOS_FRICTION_3D_##name

/* A solver with the options that its manual names; what stands here as 0 keeps its default. */
typedef struct
{
  const char *name;
  int id, local;
  int option, value;
} Preset;

static const Preset presets[] = {
    {"nsgs", F3D(NSGS), 0, 0, 0},
    {"nsgs-pli", F3D(NSGS), F3D(ONECONTACT_ProjectionOnConeWithLocalIteration), 0, 0},
    {"nsn-ac", F3D(NSN_AC), 0, F3D(NSN_LINEAR_SOLVER), F3D(NSN_USE_CSLUSOL)},
    {"nsn-ac-new", F3D(NSN_AC_TEST), 0, 0, 0},
    {"nsn-fb", F3D(NSN_FB), 0, F3D(NSN_LINEAR_SOLVER), F3D(NSN_USE_CSLUSOL)},
    {"admm", F3D(ADMM), 0, F3D(ADMM_IPARAM_RHO_STRATEGY), F3D(ADMM_RHO_STRATEGY_RESIDUAL_BALANCING)},
    {"admm-constant", F3D(ADMM), 0, F3D(ADMM_IPARAM_RHO_STRATEGY), F3D(ADMM_RHO_STRATEGY_CONSTANT)},
};

static double seconds(void)
{
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static int compare(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void *or_stop(void *pointer, const char *what)
{
  if (pointer == NULL)
  {
    fprintf(stderr, "siconos_solve: %s\n", what);
    exit(4);
  }
  return pointer;
}

/* Scales the problem as above; `unit` receives the displacement and the force that are 1 then. */
static void scale(struct fclib_local *problem, double unit[2])
{
  const int n = problem->W->n;
  double diagonal = 0, largest = 0;
  for (int j = 0; j < n; ++j)
    for (int k = problem->W->p[j]; k < problem->W->p[j + 1]; ++k)
      if (problem->W->i[k] == j)
        diagonal += problem->W->x[k] / n;
  for (int i = 0; i < n; ++i)
    largest = fmax(largest, fabs(problem->q[i]));
  unit[0] = largest > 0 ? largest : 1;
  unit[1] = unit[0] / diagonal;
  for (int k = 0; k < problem->W->p[n]; ++k)
    problem->W->x[k] /= diagonal;
  for (int i = 0; i < n; ++i)
    problem->q[i] /= unit[0];
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

static SolverOptions *options_of(const Preset *preset, const double tolerance, const int iterations)
{
  SolverOptions *options = solver_options_create(preset->id);
  if (preset->local != 0)
    solver_options_update_internal(options, 0, preset->local);
  if (preset->option != 0)
    options->iparam[preset->option] = preset->value;
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = iterations;
  if (preset->id == F3D(NSGS))
    options->internalSolvers[0]->dparam[SICONOS_DPARAM_TOL] = 1e-14;
  return options;
}

/* Solves from no force; returns the solver's info. */
static int solve(const struct fclib_local *problem, SolverOptions *options, double *force, double *velocity, double *time)
{
  const int n = problem->W->n;
  FrictionContactProblem *siconos = frictionContactProblem_new();
  siconos->dimension = 3;
  siconos->numberOfContacts = n / 3;
  siconos->M = dense(problem->W);
  siconos->q = problem->q;
  siconos->mu = problem->mu;
  memset(force, 0, sizeof(double) * (size_t)n);
  memcpy(velocity, problem->q, sizeof(double) * (size_t)n);
  const double begin = seconds();
  const int info = fc3d_driver(siconos, force, velocity, options);
  *time = seconds() - begin;
  NM_clear(siconos->M);
  free(siconos->M);
  free(siconos);
  return info;
}

static double error_of(struct fclib_local *problem, double *force)
{
  const int n = problem->W->n;
  double *velocity = malloc(sizeof(double) * (size_t)n);
  memcpy(velocity, problem->q, sizeof(double) * (size_t)n);
  for (int j = 0; j < n; ++j)
    for (int k = problem->W->p[j]; k < problem->W->p[j + 1]; ++k)
      velocity[problem->W->i[k]] += problem->W->x[k] * force[j];
  struct fclib_solution solution = {NULL, velocity, force, NULL};
  const double error = fclib_merit_local(problem, MERIT_1, &solution);
  free(velocity);
  return error;
}

static int judge_stored(const char *file, struct fclib_local *problem, const double unit[2])
{
  struct fclib_solution *stored = or_stop(fclib_read_solution(file), "no solution in the file");
  for (int i = 0; i < problem->W->n; ++i)
    stored->r[i] /= unit[1];
  printf("0,0,0,%.6g\n", error_of(problem, stored->r));
  return 0;
}

int main(const int n_arguments, char **arguments)
{
  enum
  {
    most_repeats = 9
  };
  if (n_arguments != 3 && n_arguments != 7)
    or_stop(NULL, "FILE stored | FILE SOLVER TOLERANCE ITERATIONS SECONDS REPEATS");
  struct fclib_local *problem = or_stop(fclib_read_local(arguments[1]), "no problem in the file");
  double unit[2], times[most_repeats] = {0};
  scale(problem, unit);
  if (n_arguments == 3)
    return judge_stored(arguments[1], problem, unit);
  const Preset *preset = NULL;
  for (size_t i = 0; i < sizeof presets / sizeof *presets; ++i)
    if (strcmp(presets[i].name, arguments[2]) == 0)
      preset = presets + i;
  or_stop((void *)preset, "no such solver");
  const int repeats = (int)fmin(most_repeats, fmax(1, atoi(arguments[6])));
  double *force = calloc((size_t)problem->W->n, sizeof(double)), *velocity = calloc((size_t)problem->W->n, sizeof(double));
  int info = 0, iterations = 0, done = 0;
  alarm((unsigned int)atoi(arguments[5]));
  while (done < repeats && (done == 0 || times[0] < 0.2)) /* what takes long is not noisy */
  {
    SolverOptions *options = options_of(preset, atof(arguments[3]), atoi(arguments[4]));
    info = solve(problem, options, force, velocity, times + done++);
    iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
    solver_options_delete(options);
  }
  qsort(times, (size_t)done, sizeof *times, compare);
  printf("%d,%d,%.6g,%.6g\n", info, iterations, times[done / 2], error_of(problem, force));
  return 0;
}
