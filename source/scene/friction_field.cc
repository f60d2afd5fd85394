// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/friction_field.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace
{
constexpr double right_angle = 90; // degrees

Matrix2d turned_by(const double degrees)
{
  return Eigen::Rotation2Dd(degrees * pi / (2 * right_angle)).toRotationMatrix();
}

/// An ellipse as the tensor with the squares of its semi-axes as eigenvalues: entries xx, xy, yy.
Eigen::Vector3d tensor(const Vector2d &axes, const Matrix2d &turn)
{
  const Matrix2d whole = turn * axes.cwiseAbs2().asDiagonal() * turn.transpose();
  return {whole(0, 0), whole(0, 1), whole(1, 1)};
}

/// A law as forces per unit normal force in global axes, against slip along `map` times each of so many
/// directions, with `map` undone: two laws are images of each other where these numbers are equal.
class ForcesAgainstSlip
{
public:
  static constexpr unsigned int n_directions = 72;

  ForcesAgainstSlip(const FrictionLaw &law, const double angle, const Matrix2d &map = Matrix2d::Identity())
  {
    const Matrix2d to_map = map.transpose() * turned_by(angle);
    for (unsigned int i = 0; i < n_directions; ++i)
    {
      const double direction = 2 * pi * (i + 0.5) / n_directions;
      const Vector2d slip = to_map.transpose() * Vector2d(std::cos(direction), std::sin(direction));
      forces_.segment<2>(2 * i) = to_map * law.force_against(slip);
    }
  }

  const VectorXd &forces() const { return forces_; }

  bool is_like(const ForcesAgainstSlip &other) const
  {
    constexpr double rounding = 1e-9;
    return (forces_ - other.forces_).norm() <= rounding * std::max(forces_.norm(), other.forces_.norm());
  }

private:
  VectorXd forces_{2 * n_directions};
};

/// Whether the axes of friction are those of a section without a third component: radius and hoop, or x and
/// y.
bool lies_in_section(const ModelSymmetry &symmetry)
{
  return symmetry.is_section() && !symmetry.has_third();
}

/// Friction along the axes of such a section, which are those of its ellipses.
FrictionLaw law_in_section(const FrictionLaw &law, const double angle)
{
  const OrthotropicFriction *const ellipse = law.ellipse();
  if (ellipse == nullptr || std::abs(std::remainder(angle, 2 * right_angle)) <= right_angle / 2)
    return law;
  return OrthotropicFriction{ellipse->mu_y, ellipse->mu_x, ellipse->p_y, ellipse->p_x};
}
} // namespace

FrictionLaw FrictionField::law(const Vector2d &place) const
{
  return options_.law.chosen().law(options_, place);
}

double FrictionField::angle(const Vector2d &place) const
{
  return options_.varying_angle ? options_.varying_angle->value(place[0], place[1]) : options_.angle;
}

void FrictionField::check(const std::vector<Vector2d> &places) const
{
  for (const Vector2d &place : places)
  {
    law(place);
    if (std::isfinite(angle(place)))
      continue;
    Parameters parameters;
    parameters.friction = options_;
    throw InputError(entry_text(parameters, "Friction/Orthotropy angle") + " is " + value_text(angle(place)) +
                     " at " + place_text(place) +
                     " of the contact surface: allowed is a finite number (degrees)");
  }
}

std::vector<FrictionLaw> FrictionField::laws(const ContactSurface &surface,
                                             const ModelSymmetry &symmetry) const
{
  if (!varies())
    return std::vector<FrictionLaw>(surface.nodes.size(), law(Vector2d::Zero()));
  std::vector<FrictionLaw> laws;
  for (const Vector2d &place : places_of(surface))
    laws.push_back(lies_in_section(symmetry) ? law_in_section(law(place), angle(place)) : law(place));
  return laws;
}

LocalAxes FrictionField::axes(const ContactSurface &surface, const ModelSymmetry &symmetry) const
{
  // Friction that is the same all around is isotropic where it does not vary.
  if ((symmetry.is_axisymmetric() && !varies()) || (lies_in_section(symmetry) && varies()))
    return LocalAxes(0);
  if (!options_.varying_angle)
    return LocalAxes(options_.angle);
  std::vector<double> angles;
  for (const Vector2d &place : places_of(surface))
    angles.push_back(angle(place));
  return LocalAxes(angles);
}

std::string FrictionField::constant_asymmetry(const ModelSymmetry &symmetry) const
{
  const bool has_equal_mu = options_.mu[0] == options_.mu[1],
             has_equal_p = options_.p()[0] == options_.p()[1];
  const auto pair = [](const std::array<double, 2> &p) { return to_text(p[0]) + ", " + to_text(p[1]); };
  if (symmetry.is_axisymmetric())
    return !has_equal_mu
               ? "Friction/Coefficients = " + pair(options_.mu) + " differ, which makes friction orthotropic"
           : !has_equal_p
               ? "Friction/Slip potential = " + pair(options_.p()) + " differ, which makes slip orthotropic"
               : "";
  const bool is_mirrored = !symmetry.is_section() || !symmetry.has_third() || symmetry.planes().normal_to_x;
  if (!is_mirrored || (has_equal_mu && has_equal_p) || std::remainder(options_.angle, right_angle) == 0)
    return {};
  return "Friction/Orthotropy angle = " + to_text(options_.angle) + " turns the axes of friction";
}

std::string FrictionField::asymmetry_of_maps(const ModelSymmetry &symmetry,
                                             const std::vector<Vector2d> &places) const
{
  for (const Vector2d &place : places)
  {
    if (symmetry.is_axisymmetric() && place[0] == 0)
      continue; // nothing slips on the axis
    for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
    {
      const Vector2d image = map * place;
      if (!ForcesAgainstSlip(law(image), angle(image), map.linear())
               .is_like(ForcesAgainstSlip(law(place), angle(place))))
        return "friction at " + place_text(image) + " is no image of that at " + place_text(place);
    }
  }
  return {};
}

std::string FrictionField::asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const
{
  const std::string law_text = "Friction/Law = " + options_.law.word();
  if (symmetry.is_axisymmetric() && !options_.has_ellipses())
    return law_text + ", and a section knows ellipses only";
  if (varies())
    return asymmetry_of_maps(symmetry, sample.of(symmetry));
  if (options_.has_ellipses())
    return constant_asymmetry(symmetry);
  return asymmetry_of_maps(symmetry, {Vector2d::Zero()}).empty()
             ? ""
             : law_text + " with Friction/Orthotropy angle = " + to_text(options_.angle) +
                   " is no image of itself";
}

VectorXd FrictionField::numbers(const Vector2d &place) const
{
  const Matrix2d turn = turned_by(angle(place));
  if (options_.has_ellipses())
  {
    const FrictionOptions there = options_.at(place[0], place[1]);
    const Vector2d p(there.p()[0], there.p()[1]);
    VectorXd both(6);
    both << tensor({there.mu[0], there.mu[1]}, turn), tensor(p / p.maxCoeff(), turn);
    return both;
  }
  try
  {
    return ForcesAgainstSlip(law(place), angle(place)).forces();
  }
  catch (const InputError &)
  {
    return VectorXd::Constant(2 * ForcesAgainstSlip::n_directions, std::numeric_limits<double>::quiet_NaN());
  }
}
} // namespace orthocone
