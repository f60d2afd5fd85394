// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A program with a rule of its own that ends a run: the first cycle that has worn a volume off.
#include <orthocone/app/program.h>
#include <orthocone/base/errors.h>
#include <orthocone/scene/options.h>

namespace
{
class WornVolume : public orthocone::StopRule
{
public:
  std::unique_ptr<StopRule> clone() const override { return std::make_unique<WornVolume>(*this); }

  void declare(orthocone::Section &section) override
  {
    section
        .add("Stop at worn volume", volume_,
             orthocone::number_codec(orthocone::NumberRange{0, 1e12, true, true}),
             "The run is complete when a cycle has worn this volume off, mm^3; 0 = never.")
        .may_change_on_resume();
  }

  void check(const orthocone::LoadOptions &, const orthocone::WearOptions &wear) const override
  {
    if (volume_ > 0 && !wear.wears())
      throw orthocone::InputError("Load program/Stop at worn volume = " + orthocone::to_text(volume_) +
                                  " with " + wear.law_entry() + ": allowed is 0, or a Law that wears");
  }

  std::string why_to_stop(const orthocone::CycleRow &row) const override
  {
    if (volume_ == 0 || row.worn_volume < volume_)
      return "";
    return "worn volume " + orthocone::to_text(row.worn_volume) + " mm^3 after cycle " +
           std::to_string(row.cycle);
  }

private:
  double volume_ = 0; ///< mm^3; 0 = never
};
} // namespace

int main(const int argc, const char *const *const argv)
{
  orthocone::kinds_of<orthocone::StopRule>().push_back(
      {"worn volume", "", [] { return std::make_unique<WornVolume>(); }});
  orthocone::run_program(argc, argv);
}
