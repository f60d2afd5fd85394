// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/accuracy.h>

#include <orthocone/base/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
/// Absolute error of the last of the values.
double remaining_change(const std::vector<double> &values)
{
  constexpr double best_ratio = 0.5;
  constexpr double worst_ratio = 0.6;
  constexpr double least_share = 1. / 3; // of the difference before
  const std::size_t last = values.size() - 1;
  double difference = std::abs(values[last] - values[last - 1]);
  double ratio = best_ratio;
  if (last >= 2)
  {
    const double before = std::abs(values[last - 1] - values[last - 2]);
    difference = std::max(difference, least_share * before);
    ratio = before > 0 ? std::clamp(difference / before, best_ratio, worst_ratio) : best_ratio;
  }
  return difference * ratio / (1 - ratio);
}

} // namespace

bool AccuracyEstimate::is_reached() const
{
  return std::all_of(errors.begin(), errors.end(), [this](const double error) { return error <= wanted; });
}

Quantities estimated_errors(const std::vector<Quantities> &levels, const double contact_area)
{
  constexpr double percent = 100;
  constexpr double least_share_of_area = 0.1;
  Quantities errors{};
  for (unsigned int i = 0; i < n_quantities; ++i)
  {
    std::vector<double> values;
    for (const Quantities &level : levels)
      values.push_back(level[i]);
    double scale = std::abs(values.back());
    if (i == stick_area_index)
      scale = std::max(scale, least_share_of_area * contact_area);
    const double change = values.size() < 2 ? std::abs(values[0]) : remaining_change(values);
    errors[i] = change > 0 ? percent * change / scale : 0;
  }
  return errors;
}

std::string describe_quantities(const AccuracyEstimate &accuracy)
{
  std::ostringstream text;
  for (unsigned int i = 0; i < n_quantities; ++i)
    text << (i == 0 ? "" : ", ") << quantity_names[i] << " " << std::setprecision(6) << accuracy.values[i]
         << " (" << std::setprecision(2) << accuracy.errors[i] << " %)";
  return text.str();
}

std::string describe(const AccuracyEstimate &accuracy)
{
  return to_text(accuracy.wanted) + " % wanted, " + (accuracy.is_reached() ? "reached" : "NOT reached") +
         "; value (estimated error): " + describe_quantities(accuracy);
}
} // namespace orthocone
