/* SPDX-License-Identifier: LGPL-2.1-or-later
 * Copyright (C) 2026 the orthocone authors
 *
 *   judge_forces FILE              prints the number of nodes of a local problem of FCLIB
 *   judge_forces FILE OTHER_FILE   judges the solution in another file of the problem: error, merit, and the
 *                                  difference to the solution in FILE
 */
#include "fclib_problem.h"

#include <stdio.h>

int main(const int n_arguments, char **arguments)
{
  if (n_arguments < 2 || n_arguments > 3)
    or_stop(NULL, "FILE [OTHER_FILE]");
  const Problem problem = read_problem(arguments[1]);
  if (n_arguments == 2)
  {
    printf("%d\n", problem.local->W->n / 3);
    return 0;
  }
  Judgement judgement = {0, 0, 0};
  judge(&problem, forces(&problem, arguments[2]), &judgement);
  print_judgement(&judgement);
  return 0;
}
