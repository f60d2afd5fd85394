/* SPDX-License-Identifier: LGPL-2.1-or-later
 * Copyright (C) 2026 the orthocone authors
 *
 * A local problem of FCLIB, and one measure for the forces of all solvers.
 *
 * The problem is scaled so that the largest entry of q and the mean of W's diagonal are 1, since neither
 * Siconos' steps nor FCLIB's measure do it: in N and mm both would depend on the units. */
#pragma once

#include <fclib.h>

typedef struct
{
  struct fclib_local *local;
  double unit;    /* the force that is 1 */
  double *stored; /* forces of the solution in the file; NULL: it has none */
} Problem;

/* `error`: the natural map, with 1 / rho of a node the largest diagonal entry of W there, relative to the
 * forces. `merit`: FCLIB's own measure. `difference` to the stored solution, relative to it; NAN
 * where there is none. */
typedef struct
{
  double error, merit, difference;
} Judgement;

void *or_stop(void *pointer, const char *what);
double *vector(int n);
Problem read_problem(const char *file);
double *forces(const Problem *problem, const char *file);
void judge(const Problem *problem, double *force, Judgement *judgement);
void print_judgement(const Judgement *judgement);
