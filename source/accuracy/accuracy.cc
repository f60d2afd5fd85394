// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/accuracy.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr double best_ratio = 0.5; // of first order: docs/accuracy.md, "A number: `Load program/Accuracy`"
constexpr double worst_ratio = 0.6;
constexpr double least_share = 1. / 3; // of the difference before: docs/accuracy.md, "Load steps"

/// Extrapolation without a known order: levels halve the cells, so that differences d_k of a quantity fall in
/// proportion, d_(k+1) = q d_k, and all behind the last one make d q/(1 - q). q is measured by the last two
/// differences, and bounded: singular edges let no quantity fall faster than to a half in the long run, and a
/// difference that is small by chance must not promise digits. The likely sum of all differences behind the
/// last one. `before` is the difference before it, or 0.
double remaining_change(const double last, const double before)
{
  const double difference = std::max(last, least_share * before);
  const double ratio = before > 0 ? std::clamp(difference / before, best_ratio, worst_ratio) : best_ratio;
  return difference * ratio / (1 - ratio);
}

/// Absolute error of the last of the values.
double remaining_change(const std::vector<double> &values)
{
  const std::size_t last = values.size() - 1;
  return remaining_change(std::abs(values[last] - values[last - 1]),
                          last >= 2 ? std::abs(values[last - 1] - values[last - 2]) : 0);
}
} // namespace

bool AccuracyEstimate::is_reached() const
{
  for (unsigned int i = 0; i < n_quantities; ++i)
    if (counted[i] && !(errors[i] + steps_share[i] <= wanted))
      return false;
  return true;
}

Quantities relative_errors(const Quantities &absolute, const Quantities &values, const double contact_area,
                           const double motion)
{
  constexpr double percent = 100;
  constexpr double least_share_of_area = 0.1, negligible = 1e-3; // digits of less are not worth any effort
  Quantities least{};
  least[0] = negligible * motion;
  least[2] = least[loop_area_index] = negligible * values[1] * motion / 2;
  least[stick_area_index] = least_share_of_area * contact_area;
  Quantities errors{};
  for (unsigned int i = 0; i < n_quantities; ++i)
    errors[i] = percent * relative(absolute[i], std::max(std::abs(values[i]), least[i]));
  return errors;
}

Quantities estimated_errors(const std::vector<Quantities> &levels, const double contact_area,
                            const double motion)
{
  Quantities changes{};
  for (unsigned int i = 0; i < n_quantities; ++i)
  {
    std::vector<double> values;
    for (const Quantities &level : levels)
      values.push_back(level[i]);
    changes[i] = values.size() < 2 ? std::abs(values[0]) : remaining_change(values);
  }
  return relative_errors(changes, levels.back(), contact_area, motion);
}

double first_order_error(const double change, const double change_before)
{
  return std::max(change, least_share * change_before) + remaining_change(change, change_before);
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
  const bool is_shared = std::any_of(accuracy.steps_share.begin(), accuracy.steps_share.end(),
                                     [](const double steps_share) { return steps_share > 0; });
  return to_text(accuracy.wanted) + " % wanted" +
         (accuracy.counted == all_quantities ? "" : " of " + counted_text(accuracy.counted)) +
         (is_shared ? ", the error of the load steps included, " : ", ") +
         (accuracy.is_reached() ? "reached" : "NOT reached") +
         "; value (estimated error): " + describe_quantities(accuracy);
}
} // namespace orthocone
