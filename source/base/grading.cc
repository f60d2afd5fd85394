// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/grading.h>

#include <cmath>

namespace orthocone
{
std::vector<double> graded_positions(const unsigned int n, const double grading)
{
  std::vector<double> positions{0};
  double width = 1;
  for (unsigned int i = 0; i < n; ++i, width *= grading)
    positions.push_back(positions.back() + width);
  for (double &position : positions)
    position /= positions[n];
  return positions;
}

std::vector<double> positions_graded_to_both_ends(const double length, const unsigned int n,
                                                  const double grading)
{
  std::vector<double> positions{0};
  for (unsigned int i = 0; i < n; ++i)
    positions.push_back(positions.back() + std::pow(grading, std::abs(i - 0.5 * (n - 1))));
  for (double &position : positions)
    position *= length / positions[n];
  positions.back() = length;
  return positions;
}

double last_share(const unsigned int n, const double grading)
{
  double sum = 0;
  for (unsigned int i = 0; i < n; ++i)
    sum += std::pow(grading, i);
  return std::pow(grading, n - 1) / sum;
}

double thinnest_share(const unsigned int n, const double grading)
{
  // Read backwards, intervals that grow shrink.
  return last_share(n, grading < 1 ? grading : 1 / grading);
}

double end_share(const unsigned int n, const double grading)
{
  return positions_graded_to_both_ends(1, n, grading)[1];
}
} // namespace orthocone
