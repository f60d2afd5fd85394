// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/scene/options.h>

#include "periods.h"

namespace orthocone
{
namespace
{
class NoWear : public WearKindOptions
{
public:
  std::unique_ptr<WearKindOptions> clone() const override { return std::make_unique<NoWear>(); }
  bool wears() const override { return false; }
  double volume(double, const Rubbing &) const override { return 0; }
};
} // namespace

// Each in a file of its name, which may be compiled together with this one.
// NOLINTBEGIN(readability-redundant-declaration)
Kind<WearKindOptions> archard_wear();
Kind<WearKindOptions> energy_wear();
// NOLINTEND(readability-redundant-declaration)

template<>
std::vector<Kind<WearKindOptions>> &kinds_of<WearKindOptions>()
{
  static std::vector<Kind<WearKindOptions>> kinds{
      {"none", "no wear", [] { return std::make_unique<NoWear>(); }}, archard_wear(), energy_wear()};
  return kinds;
}

void declare_wear(WearOptions &wear, Section &section)
{
  const Codec<double> size = number_codec(NumberRange{0, 1e6, true, true});
  const Condition wears{[&wear] { return wear.wears(); }, [&wear] { return wear.law_entry(); }};
  wear.law.declare("Law",
                   "Law of wear, which gives the depth that slip removes from the body and adds to the gap.",
                   section);
  section
      .add("Coefficient", wear.coefficient, size,
           "Coefficient of wear, mm^3/(N mm) = 1/MPa: the worn volume per normal force and length of slip "
           "(archard), or per dissipated energy (energy). It has to be above 0 unless Law = none.")
      .unit("MPa\u207b\u00b9")
      .only_if(wears);
  section
      .add_word("Deep steps", wear.deep_steps,
                "How a deep step is solved, which is one that wears a node more than 0.9 times as deep as "
                "pressure flattens it. implicit: with the depth as an unknown, so that a stroke may be far "
                "longer than the contact, though with Mesh/Backend = multigrid as explicit; explicit: the "
                "depth acts from the next step on, which makes contact flicker from node to node.")
      .only_if(wears);
  section
      .add("Largest depth of a jump", wear.largest_jump, size,
           "Largest depth in mm that a node may lose in cycles that are jumped, each of which wears like the "
           "last computed one. The program jumps fewer cycles where the depth of a cycle changes by more "
           "than a tenth from jump to jump. 0 = all cycles are computed.")
      .unit("mm")
      .only_if(wears);
}

void check_wear(const WearOptions &wear, const LoadOptions &load)
{
  if (!wear.wears())
    return;
  if (wear.coefficient == 0)
    throw InputError("Wear/Coefficient = 0 with " + wear.law_entry() +
                     ": allowed is a number > 0, in mm^3/(N mm) = 1/MPa, or Law = none");
  check_no_wear("Jump when periodic", load.jump_when_periodic, wear);
}
} // namespace orthocone
