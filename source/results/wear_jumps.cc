// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/wear_jumps.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

WearJumps::WearJumps(const WearOptions &options, VectorXd areas)
    : options_(options),
      areas_(std::move(areas))
{
}

/// The factor by which the next jump may be longer than the last one: the rates at both its ends should
/// differ by a tenth.
double WearJumps::growth(const VectorXd &rate) const
{
  constexpr double wanted = 0.1, least = 0.25, most = 2; // docs/theory.md, section 3, "Jumps"
  const double worn = areas_.dot(rate.cwiseMax(memory_.rate));
  const double changed = areas_.dot((rate - memory_.rate).cwiseAbs());
  return changed > 0 ? std::clamp(wanted * worn / changed, least, most) : most;
}

unsigned int WearJumps::after_cycle(const ContactState &start, const ContactState &end,
                                    const unsigned int most)
{
  constexpr double first_share = 0.125; // of the largest depth: the change of the rate is not known yet
  if (!are_wanted() || ++memory_.n_settled < 2)
    return 0;
  const VectorXd rate = end.wear_depth - start.wear_depth;
  double n = options_.largest_jump / rate.maxCoeff(); // infinite where nothing wears
  if (memory_.rate.size() == 0)
    n *= first_share;
  else
  {
    memory_.error += 0.5 * memory_.n_jumped * areas_.dot(rate - memory_.rate);
    n = std::min(n, std::max(1., growth(rate) * memory_.n_jumped));
  }
  n = std::min(n, static_cast<double>(most));
  if (n < 1)
    return 0;
  memory_ = {rate, static_cast<unsigned int>(n), 0, memory_.error};
  return memory_.n_jumped;
}
} // namespace orthocone
