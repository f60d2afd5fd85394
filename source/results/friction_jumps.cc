// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/friction_jumps.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

FrictionJumps::FrictionJumps(const Scene &scene)
    : areas_(scene.symmetry().n_copies() * scene.pressed_areas()),
      largest_change_(scene.parameters().load.jump_change_of_friction),
      most_cycles_(scene.parameters().load.jump_cycles)
{
  if (largest_change_ > 0)
    friction_ = std::make_shared<const FrictionMemory>(scene);
}

/// The factors behind `n` cycles that follow `end` with this rate; any numbers.
VectorXd FrictionJumps::behind(const ContactState &end, const Rate &rate, const unsigned int n,
                               const unsigned int cycle) const
{
  ContactState later = end;
  later.accumulated_slip += n * rate.slip;
  later.dissipated_energy += n * rate.energy;
  return friction_->values(later, cycle + n + 1);
}

bool FrictionJumps::may_follow(const ContactState &end, const Rate &rate, const unsigned int n,
                               const unsigned int cycle) const
{
  const VectorXd now = behind(end, rate, 0, cycle), then = behind(end, rate, n, cycle);
  for (Index node = 0; node < now.size(); ++node)
    if (!(std::abs(then[node] / now[node] - 1) <= largest_change_)) // not for NaN
      return false;
  return true;
}

/// The largest number of cycles that may_follow(), doubled until they may not, and then bisected.
unsigned int FrictionJumps::most_alike(const ContactState &end, const Rate &rate, const unsigned int cycle,
                                       const unsigned int most) const
{
  unsigned int fine = 0, too_many = 1;
  while (too_many <= most && may_follow(end, rate, too_many, cycle))
  {
    fine = too_many;
    too_many = 2 * too_many;
  }
  too_many = std::min(too_many, most + 1);
  while (too_many - fine > 1)
  {
    const unsigned int middle = fine + (too_many - fine) / 2;
    (may_follow(end, rate, middle, cycle) ? fine : too_many) = middle;
  }
  return fine;
}

/// The factor by which the next jump may be longer than the last one: what a cycle changes in the factor at
/// both its ends should differ by a tenth. Adds the error of the last jump, too.
double FrictionJumps::growth(const ContactState &end, const Rate &rate, const unsigned int cycle)
{
  constexpr double wanted = 0.1, least = 0.25, most = 2; // docs/theory.md, section 3, "Jumps"
  const VectorXd now = behind(end, rate, 0, cycle),
                 first = behind(end, {memory_.slip, memory_.energy}, 1, cycle) - now,
                 last = behind(end, rate, 1, cycle) - now;
  const VectorXd slipped = (end.accumulated_slip.array() > 0).cast<double>() * areas_.array();
  const double area = slipped.sum();
  if (area > 0)
    memory_.error += 0.5 * memory_.n_jumped * slipped.dot(last - first) / area;
  const double moved = slipped.dot(last.cwiseAbs().cwiseMax(first.cwiseAbs()));
  const double changed = slipped.dot((last - first).cwiseAbs());
  return changed > 0 ? std::clamp(wanted * moved / changed, least, most) : most;
}

unsigned int FrictionJumps::after_cycle(const ContactState &start, const ContactState &end,
                                        const unsigned int cycle, const unsigned int most)
{
  constexpr double first_share = 0.125; // of the largest change: that of the rate is not known yet
  if (!are_wanted() || ++memory_.n_settled < 2)
    return 0;
  const Rate rate{end.accumulated_slip - start.accumulated_slip,
                  end.dissipated_energy - start.dissipated_energy};
  double n = most_alike(end, rate, cycle, std::min(most, most_cycles_));
  if (memory_.slip.size() == 0)
    n = std::max(std::min(n, 1.), first_share * n);
  else if (memory_.n_settled == 2) // the error is that of one jump
    n = std::min(n, std::max(1., growth(end, rate, cycle) * memory_.n_jumped));
  return static_cast<unsigned int>(n);
}

void FrictionJumps::begin_jump(const ContactState &start, const ContactState &end, const unsigned int n)
{
  if (are_wanted())
    memory_ = {end.accumulated_slip - start.accumulated_slip, end.dissipated_energy - start.dissipated_energy,
               n, 0, memory_.error};
}
} // namespace orthocone
