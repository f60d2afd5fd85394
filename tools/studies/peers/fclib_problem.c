/* SPDX-License-Identifier: LGPL-2.1-or-later
 * Copyright (C) 2026 the orthocone authors
 *
 * See fclib_problem.h. */
#include "fclib_problem.h"

#include <hdf5.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *or_stop(void *pointer, const char *what)
{
  if (pointer == NULL)
  {
    fprintf(stderr, "%s\n", what);
    exit(4);
  }
  return pointer;
}

double *vector(const int n)
{
  return or_stop(calloc((size_t)n, sizeof(double)), "memory ran out");
}

/* Scales the problem as the header says; returns the force that is 1 then. */
static double scale(struct fclib_local *problem)
{
  const int n = problem->W->n;
  double diagonal = 0, largest = 0;
  for (int j = 0; j < n; ++j)
    for (int k = problem->W->p[j]; k < problem->W->p[j + 1]; ++k)
      if (problem->W->i[k] == j)
        diagonal += problem->W->x[k] / n;
  for (int i = 0; i < n; ++i)
    largest = fmax(largest, fabs(problem->q[i]));
  for (int k = 0; k < problem->W->p[n]; ++k)
    problem->W->x[k] /= diagonal;
  for (int i = 0; i < n; ++i)
    problem->q[i] /= largest;
  return largest / diagonal;
}

/* FCLIB ends the program where there is none. */
static int has_solution(const char *name)
{
  const hid_t file = H5Fopen(name, H5F_ACC_RDONLY, H5P_DEFAULT);
  const int is_there = file >= 0 && H5Lexists(file, "/solution", H5P_DEFAULT) > 0;
  if (file >= 0)
    H5Fclose(file);
  return is_there;
}

double *forces(const Problem *problem, const char *file)
{
  struct fclib_solution *solution =
      or_stop(has_solution(file) ? fclib_read_solution(file) : NULL, "no solution in the file");
  for (int i = 0; i < problem->local->W->n; ++i)
    solution->r[i] /= problem->unit;
  return solution->r;
}

Problem read_problem(const char *file)
{
  Problem problem = {or_stop(fclib_read_local(file), "no problem in the file"), 0, NULL};
  if (problem.local->V != NULL)
    or_stop(NULL, "equality constraints, which Siconos' local solvers do not know");
  problem.unit = scale(problem.local);
  if (has_solution(file))
    problem.stored = forces(&problem, file);
  return problem;
}

/* The force within the circular cone that is nearest to p. */
static void project(const double mu, double *p)
{
  const double t = hypot(p[1], p[2]), normal = (p[0] + mu * t) / (1 + mu * mu);
  if (t <= mu * p[0])
    return;
  if (mu * t <= -p[0])
    p[0] = p[1] = p[2] = 0;
  else
  {
    p[0] = normal;
    p[1] *= mu * normal / t;
    p[2] *= mu * normal / t;
  }
}

/* The square of what a node adds to the natural map. */
static double square_of_map(const double mu, const double rho, const double *r, const double *u)
{
  double p[3] = {r[0] - rho * (u[0] + mu * hypot(u[1], u[2])), r[1] - rho * u[1], r[2] - rho * u[2]}, sum = 0;
  project(mu, p);
  for (int i = 0; i < 3; ++i)
    sum += (r[i] - p[i]) * (r[i] - p[i]);
  return sum;
}

/* What is wrong with forces. `error`: the natural map, with 1 / rho of a node the largest diagonal entry of W
 * there, relative to the forces. `merit`: FCLIB's own. */
void judge(const Problem *problem, double *force, Judgement *judgement)
{
  const struct fclib_matrix *w = problem->local->W;
  double *velocity = vector(w->n), *largest = vector(w->n), map = 0, all = 0, other = 0, apart = 0;
  memcpy(velocity, problem->local->q, sizeof(double) * (size_t)w->n);
  for (int j = 0; j < w->n; ++j)
    for (int k = w->p[j]; k < w->p[j + 1]; ++k)
    {
      velocity[w->i[k]] += w->x[k] * force[j];
      if (w->i[k] == j)
        largest[j / 3] = fmax(largest[j / 3], w->x[k]);
    }
  for (int node = 0; 3 * node < w->n; ++node)
    map += square_of_map(problem->local->mu[node], 1 / largest[node], force + 3 * node, velocity + 3 * node);
  for (int i = 0; i < w->n; ++i)
  {
    const double stored = problem->stored == NULL ? NAN : problem->stored[i];
    all += force[i] * force[i];
    other += stored * stored;
    apart += (force[i] - stored) * (force[i] - stored);
  }
  struct fclib_solution solution = {NULL, velocity, force, NULL};
  judgement->error = sqrt(map / all);
  judgement->merit = fclib_merit_local(problem->local, MERIT_1, &solution);
  judgement->difference = sqrt(apart / other);
  free(velocity);
  free(largest);
}

void print_judgement(const Judgement *judgement)
{
  printf("%.4g,%.4g,%.4g\n", judgement->error, judgement->merit, judgement->difference);
}
