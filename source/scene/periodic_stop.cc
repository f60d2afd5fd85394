// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "periods.h"

#include <orthocone/base/errors.h>

namespace orthocone
{
namespace
{
/// Ends the run as soon as a cycle ends as it began.
class PeriodicStop : public StopRule
{
public:
  std::unique_ptr<StopRule> clone() const override { return std::make_unique<PeriodicStop>(*this); }

  void declare(Section &section) override
  {
    section
        .add("Stop when periodic", bound_, period_codec(),
             "Ends the run as soon as a cycle ends as it began: nodal forces differ by less than this share "
             "of the largest one, and displacements by less than this share of the largest motion of the "
             "held face; 0 = never.")
        .may_change_on_resume();
  }

  void check(const LoadOptions &load, const WearOptions &wear) const override
  {
    if (bound_ > 0 && load.jump_when_periodic > 0)
      throw InputError(
          "Load program/Stop when periodic = " + to_text(bound_) +
          " and Load program/Jump when periodic = " + to_text(load.jump_when_periodic) +
          ": allowed is one of them, the other 0 (a run that stops then has no cycles left to jump)");
    check_no_wear("Stop when periodic", bound_, wear);
  }

  void warn(const double tolerance, std::vector<std::string> &warnings) const override
  {
    warn_of_period("Stop when periodic", bound_, tolerance, warnings);
  }

  double periodic_within() const override { return bound_; }

  std::string why_to_stop(const CycleRow &row) const override
  {
    if (bound_ == 0 || !(row.change <= bound_))
      return "";
    return "periodic since cycle " + std::to_string(row.cycle) + ": change " + to_text(row.change) +
           " <= Load program/Stop when periodic = " + to_text(bound_) + "; stops after load step " +
           std::to_string(row.last_step);
  }

private:
  double bound_ = 0; ///< of the change of state in a cycle; 0 = never
};
} // namespace

Kind<StopRule> periodic_stop()
{
  return {"periodic", "", [] { return std::make_unique<PeriodicStop>(); }};
}

Codec<double> period_codec()
{
  return number_codec(NumberRange{0, 1, true, false});
}

void check_no_wear(const std::string &entry, const double bound, const WearOptions &wear)
{
  if (bound > 0 && wear.wears())
    throw InputError("Load program/" + entry + " = " + to_text(bound) + " with " + wear.law_entry() +
                     ": allowed is 0, because no cycle of a surface that wears ends as "
                     "it began (Wear/Largest depth of a jump jumps cycles)");
}

void warn_of_period(const std::string &entry, const double bound, const double tolerance,
                    std::vector<std::string> &warnings)
{
  // Forces may differ by a hundred times the residual that the solver leaves: W is that ill-conditioned.
  constexpr double resolved = 100, loose = 1e-3, percent = 100;
  if (bound > 0 && bound < resolved * tolerance)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       " is less than a hundred times Contact solver/Tolerance = " + to_text(tolerance) +
                       ", so that the residual may hide a change from cycle to cycle, or look like one; take "
                       "a larger bound or a smaller Tolerance");
  // Cycles that differ count as alike, so that what is jumped or left out has errors of about this size.
  if (bound > loose)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       ": cycles count as periodic although their forces differ by up to " +
                       to_text(percent * bound) +
                       " % of the largest one, so that slip and dissipation of later cycles may be wrong by "
                       "as much; take 1e-3 or less");
}
} // namespace orthocone
