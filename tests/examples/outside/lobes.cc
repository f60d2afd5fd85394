// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A program with a friction law of its own, a formula that is no pair of ellipses: four lobes, with slip
// along the friction force.
#include <orthocone/app/program.h>
#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/rosette.h>
#include <orthocone/scene/options.h>

#include <cmath>

namespace
{
/// The friction m (1 + c cos 4b) at the angle b, along the slip. Any formula of the force over the direction
/// of slip is a law by its rows. For c > 1/17 it is not convex.
class LobesOptions : public orthocone::FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override { return std::make_unique<LobesOptions>(*this); }

  void declare(orthocone::Section &section, const orthocone::Condition &is_chosen) override
  {
    section
        .add("Mean friction", mean_, orthocone::number_codec(orthocone::positive),
             "Coefficient of friction in the mean over all directions.")
        .only_if(is_chosen);
    section
        .add("Depth of lobes", depth_, orthocone::number_codec(orthocone::NumberRange{0, 0.9, true}),
             "By how much friction along the axes is larger, as a share of the mean.")
        .only_if(is_chosen);
  }

  orthocone::FrictionLaw law(const orthocone::FrictionOptions &, const Eigen::Vector3d &) const override
  {
    constexpr unsigned int n = 1440;
    std::vector<orthocone::Rosette::Row> rows;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double angle = 2 * orthocone::pi * i / n;
      rows.push_back({angle, mean_ * (1 + depth_ * std::cos(4 * angle)), 0});
    }
    return orthocone::FrictionLaw(std::make_shared<const orthocone::Rosette>(std::move(rows)));
  }

private:
  double mean_ = 0.2;
  double depth_ = 0.2;
};
} // namespace

int main(const int argc, const char *const *const argv)
{
  orthocone::kinds_of<orthocone::FrictionLawOptions>().push_back(
      {"lobes", "friction has four lobes along the axes, and slip is along the force",
       [] { return std::make_unique<LobesOptions>(); }});
  orthocone::run_program(argc, argv);
}
