// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The friction laws that users choose by Friction/Law.
#include "semi_axes.h"

#include <orthocone/base/errors.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/surface_sample.h>

#include <cmath>

namespace orthocone
{
namespace
{
/// Throws InputError unless both numbers at a place are positive, or, if `may_be_none`, both 0.
void check_pair(const FrictionOptions &options, const std::string &entry, const std::array<double, 2> &pair,
                const bool may_be_none, const Eigen::Vector3d &place)
{
  const auto is_fine = [](const double number) { return number > 0 && std::isfinite(number); };
  if ((is_fine(pair[0]) && is_fine(pair[1])) || (may_be_none && pair[0] == 0 && pair[1] == 0))
    return;
  Parameters parameters;
  parameters.friction = options;
  throw InputError(entry_text(parameters, entry) + " is " + value_text(pair[0]) + ", " + value_text(pair[1]) +
                   " at " + place_text(place) +
                   " of the contact surface: allowed are two finite numbers > 0" +
                   (may_be_none ? ", or both 0 (no friction)" : ""));
}

} // namespace

OrthotropicFriction semi_axes_at(const FrictionOptions &friction, const Eigen::Vector3d &place)
{
  const FrictionOptions there = friction.at(place[0], place[1], place[2]);
  check_pair(friction, "Friction/Coefficients", there.mu, true, place);
  if (there.mu[0] > 0)
    check_pair(friction, "Friction/Slip potential", there.p(), false, place);
  return {there.mu[0], there.mu[1], there.p()[0], there.p()[1]};
}

namespace
{
/// The law of two ellipses. Its entries are those that section Friction has had from the start.
class Ellipses : public FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override { return std::make_unique<Ellipses>(); }
  bool varies(const FrictionOptions &friction) const override
  {
    return friction.varying_mu || friction.varying_slip_potential;
  }
  bool has_semi_axes() const override { return true; }
  FrictionLaw law(const FrictionOptions &friction, const Eigen::Vector3d &place) const override
  {
    return semi_axes_at(friction, place);
  }
};
} // namespace

// In files of their names, which may be compiled together with this one.
Kind<FrictionLawOptions> rosette_law();      // NOLINT(readability-redundant-declaration)
Kind<FrictionLawOptions> superellipse_law(); // NOLINT(readability-redundant-declaration)

template<>
std::vector<Kind<FrictionLawOptions>> &kinds_of<FrictionLawOptions>()
{
  static std::vector<Kind<FrictionLawOptions>> kinds{
      {std::string(FrictionLawKind::ellipses.word),
       "friction forces stay within an elliptic cone (Coefficients), and slip is along the normal of another "
       "ellipse (Slip potential)",
       [] { return std::make_unique<Ellipses>(); }},
      rosette_law(),
      superellipse_law()};
  return kinds;
}
} // namespace orthocone
