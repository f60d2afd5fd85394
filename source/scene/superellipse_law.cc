// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Friction by a formula: superellipses, which measured reservoirs of forces between a rhombus and a rectangle
// resemble. Any other formula becomes a law in the same way, by the rows of a table.
#include "semi_axes.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/contact/law/rosette.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/surface_sample.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
namespace
{
constexpr NumberRange exponents{1.05, 20, true, true};

/// The cone |r_x/mu_x|^q + |r_y/mu_y|^q <= r_n^q, and slip along the normal of the superellipse with the
/// semi-axes p and the exponent s. At the angle b of the force the angle a of the slip has
///   tan a = (tan b)^(s - 1) (p_x/p_y)^s,
/// and the force is as long as q and mu say.
class SuperellipseRows
{
public:
  SuperellipseRows(const OrthotropicFriction &axes, const double exponent, const double slip_exponent)
      : axes_(axes),
        exponent_(exponent),
        slip_exponent_(slip_exponent)
  {
  }

  /// Rows of four quadrants, at even steps of a + b, since one of both turns where the other one rests.
  std::vector<Rosette::Row> rows() const
  {
    constexpr unsigned int n = 90; // in a quadrant
    std::vector<Rosette::Row> rows;
    for (unsigned int quadrant = 0; quadrant < 4; ++quadrant)
      for (unsigned int i = 0; i < n; ++i)
      {
        // A mirror image leads from one quadrant to the next.
        const bool is_mirrored = quadrant % 2 == 1;
        const Rosette::Row row = row_of(static_cast<double>(is_mirrored ? n - i : i) / n);
        const double turn = (quadrant + (is_mirrored ? 1 : 0)) * pi / 2;
        rows.push_back(is_mirrored ? Rosette::Row{turn - row.angle, row.along, -row.across}
                                   : Rosette::Row{turn + row.angle, row.along, row.across});
      }
    return rows;
  }

private:
  /// Beside an axis the force rests while slip turns (s < 2), or slip while the force turns (s > 2), which no
  /// well-posed law does (Rosette). So each takes this share of the other's angle, by which it departs from
  /// the formula by less than 0.1 degrees.
  double share() const
  {
    constexpr double most = 1e-3;
    return most * std::min(1., std::abs(slip_exponent_ - 2));
  }

  /// Row of the first quadrant with a + b = part of half a turn.
  Rosette::Row row_of(const double part) const
  {
    constexpr unsigned int halvings = 80;
    const double wanted = part * pi;
    double low = -2000,
           high = 2000; // of the logarithm of tan b, beyond which its angle is 0 in any precision
    for (unsigned int i = 0; i < halvings; ++i)
    {
      const double middle = (low + high) / 2;
      (slip_angle(middle) + std::atan(std::exp(middle)) < wanted ? low : high) = middle;
    }
    const double of_force = part == 0   ? 0
                            : part == 1 ? pi / 2
                                        : std::atan(std::exp(low)),
                 of_slip = wanted - of_force;
    const double b = of_force + share() * (of_slip - of_force), a = wanted - b;
    const double size = std::pow(std::pow(std::cos(b) / axes_.mu_x, exponent_) +
                                     std::pow(std::sin(b) / axes_.mu_y, exponent_),
                                 -1 / exponent_);
    return {a, size * std::cos(b - a), size * std::sin(b - a)};
  }

  double slip_angle(const double log_of_tangent) const
  {
    return std::atan(
        std::exp((slip_exponent_ - 1) * log_of_tangent + slip_exponent_ * std::log(axes_.p_x / axes_.p_y)));
  }

  OrthotropicFriction axes_;
  double exponent_, slip_exponent_;
};

class SuperellipseOptions : public FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override
  {
    return std::make_unique<SuperellipseOptions>(*this);
  }
  bool has_semi_axes() const override { return true; }
  bool varies(const FrictionOptions &friction) const override
  {
    return friction.varying_mu || friction.varying_slip_potential;
  }

  void declare(Section &section, const Condition &is_chosen) override
  {
    section
        .add("Exponent", exponent_, number_codec(exponents),
             "q of the cone |r_x/mu_x|^q + |r_y/mu_y|^q <= r_n^q, whose semi-axes are Coefficients: 2 is an "
             "ellipse, less goes to a rhombus, and more to a rectangle.")
        .only_if(is_chosen);
    section
        .add("Slip exponent", slip_exponent_, number_codec(NumberRange{0, exponents.upper, true, true}),
             "Exponent of the superellipse whose normal is the direction of slip, and whose semi-axes are "
             "Slip "
             "potential. 0: that of Exponent, so that associated semi-axes make slip associated. Collinear "
             "slip "
             "has 2.")
        .only_if(is_chosen);
  }

  FrictionLaw law(const FrictionOptions &friction, const Eigen::Vector3d &place) const override
  {
    if (slip_exponent_ > 0 && slip_exponent_ < exponents.lower)
      throw InputError("Friction/Slip exponent = " + to_text(slip_exponent_) + ": allowed are numbers from " +
                       to_text(exponents.lower) + " to " + to_text(exponents.upper) +
                       ", or 0 for that of Exponent");
    const OrthotropicFriction axes = semi_axes_at(friction, place);
    if (is_frictionless(axes))
      return axes;
    try
    {
      return FrictionLaw(
          std::make_shared<const Rosette>(SuperellipseRows(axes, exponent_, slip_exponent(friction)).rows()));
    }
    catch (const std::invalid_argument &error)
    {
      throw InputError("Friction/Law = superellipse with Exponent = " + to_text(exponent_) +
                       " and Slip exponent = " + to_text(slip_exponent_) + " at " + place_text(place) +
                       " of the contact surface " + error.what());
    }
  }

private:
  double slip_exponent(const FrictionOptions &friction) const
  {
    if (friction.is_collinear_by_word)
      return 2;
    return slip_exponent_ == 0 ? exponent_ : slip_exponent_;
  }

  double exponent_ = 4;
  double slip_exponent_ = 0;
};
} // namespace

Kind<FrictionLawOptions> superellipse_law()
{
  return {"superellipse",
          "forces stay within a cone between a rhombus and a rectangle (Exponent, Coefficients), and slip is "
          "along "
          "the normal of another one (Slip exponent, Slip potential)",
          [] { return std::make_unique<SuperellipseOptions>(); }};
}
} // namespace orthocone
