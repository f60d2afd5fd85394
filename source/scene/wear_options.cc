// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
void declare_wear(WearOptions &wear, Section &section)
{
  const Codec<double> size = number_codec(NumberRange{0, 1e6, true, true});
  const Condition wears = section.where<WearKind>("Law", wear.law, {WearKind::archard, WearKind::energy});
  section.add_word(
      "Law", wear.law,
      "What wears the base of the body where it slips, a depth that is added to the gap. archard: "
      "Coefficient x pressure x slip; energy: Coefficient x dissipated energy per area.");
  section
      .add("Coefficient", wear.coefficient, size,
           "Volume that is worn per work, mm^3/(N mm) = 1/MPa; above 0 where a Law wears.")
      .only_if(wears);
  section
      .add_word(
          "Deep steps", wear.deep_steps,
          "How a step is solved that wears a node more than 0.9 times as deep as pressure flattens it: "
          "implicit, with the depth as an unknown, so that a stroke may be far longer than the contact "
          "(explicit with Mesh/Backend = multigrid); explicit, the next step finds the depth, and contact "
          "flickers from node to node.")
      .only_if(wears);
  section
      .add("Largest depth of a jump", wear.largest_jump, size,
           "Cycles are jumped, each as the last one, as long as no node loses more than this depth in mm; "
           "fewer where the depth of a cycle changes by more than a tenth from jump to jump. 0 = all cycles "
           "are computed.")
      .only_if(wears);
}

void check_wear(const WearOptions &wear, const LoadOptions &load)
{
  if (wear.law == WearKind::none)
    return;
  if (wear.coefficient == 0)
    throw InputError("Wear/Coefficient = 0 with Wear/Law = " + to_word(wear.law) +
                     ": allowed is a number > 0, in mm^3/(N mm) = 1/MPa, or Law = none");
  for (const auto &[entry, value] : {std::pair("Stop when periodic", load.stop_when_periodic),
                                     std::pair("Jump when periodic", load.jump_when_periodic)})
    if (value > 0)
      throw InputError(std::string("Load program/") + entry + " = " + to_text(value) +
                       " with Wear/Law = " + to_word(wear.law) +
                       ": allowed is 0, because no cycle of a surface that wears ends as "
                       "it began (Wear/Largest depth of a jump jumps cycles)");
}
} // namespace orthocone
