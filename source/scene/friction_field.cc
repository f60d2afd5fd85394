// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/friction_field.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
constexpr double right_angle = 90; // degrees

OrthotropicFriction law_of(const FrictionOptions &there)
{
  return {there.mu[0], there.mu[1], there.p()[0], there.p()[1]};
}

/// An ellipse as the tensor with the squares of its semi-axes as eigenvalues.
Matrix2d tensor(const std::array<double, 2> &axes, const double degrees)
{
  const Matrix2d turn = Eigen::Rotation2Dd(degrees * pi / (2 * right_angle)).toRotationMatrix();
  return turn * Vector2d(axes[0] * axes[0], axes[1] * axes[1]).asDiagonal() * turn.transpose();
}

/// Both ellipses; the slip ellipse has its shape only, not its size.
std::pair<Matrix2d, Matrix2d> ellipses(const FrictionOptions &there)
{
  const std::array<double, 2> p = there.p();
  const double larger = std::max(p[0], p[1]);
  return {tensor(there.mu, there.angle), tensor({{p[0] / larger, p[1] / larger}}, there.angle)};
}

bool are_alike(const Matrix2d &one, const Matrix2d &other)
{
  constexpr double rounding = 1e-9;
  return (one - other).norm() <= rounding * std::max(one.norm(), other.norm());
}

/// "Friction/Coefficients = 0.3-x/20, 0.15".
std::string entry_text(const std::string &entry, const FrictionOptions &options)
{
  Parameters parameters;
  parameters.friction = options;
  return entry_text(parameters, entry);
}

/// Throws InputError unless both numbers at a place are positive, or, if `may_be_none`, both 0.
void check_pair(const FrictionOptions &options, const std::string &entry, const std::array<double, 2> &pair,
                const bool may_be_none, const Vector2d &place)
{
  const auto is_fine = [](const double number) { return number > 0 && std::isfinite(number); };
  if ((is_fine(pair[0]) && is_fine(pair[1])) || (may_be_none && pair[0] == 0 && pair[1] == 0))
    return;
  throw InputError(entry_text(entry, options) + " is " + value_text(pair[0]) + ", " + value_text(pair[1]) +
                   " at " + place_text(place) +
                   " of the contact surface: allowed are two finite numbers > 0" +
                   (may_be_none ? ", or both 0 (no friction)" : ""));
}

/// Whether the axes of friction are those of a section without a third component: radius and hoop, or x and
/// y.
bool lies_in_section(const ModelSymmetry &symmetry)
{
  return symmetry.is_section() && !symmetry.has_third();
}

/// Friction along the axes of such a section.
OrthotropicFriction law_in_section(FrictionOptions there)
{
  if (std::abs(std::remainder(there.angle, 2 * right_angle)) > right_angle / 2)
  {
    const std::array<double, 2> p = there.p();
    there.slip_potential = std::array<double, 2>{{p[1], p[0]}};
    std::swap(there.mu[0], there.mu[1]);
  }
  return law_of(there);
}
} // namespace

void FrictionField::check(const std::vector<Vector2d> &places) const
{
  for (const Vector2d &place : places)
  {
    const FrictionOptions there = options_.at(place[0], place[1]);
    check_pair(options_, "Friction/Coefficients", there.mu, true, place);
    if (!there.is_frictionless())
      check_pair(options_, "Friction/Slip potential", there.p(), false, place);
    if (!std::isfinite(there.angle))
      throw InputError(entry_text("Friction/Orthotropy angle", options_) + " is " + value_text(there.angle) +
                       " at " + place_text(place) +
                       " of the contact surface: allowed is a finite number (degrees)");
  }
}

std::vector<OrthotropicFriction> FrictionField::laws(const ContactSurface &surface,
                                                     const ModelSymmetry &symmetry) const
{
  if (!varies())
    return std::vector<OrthotropicFriction>(surface.nodes.size(), law_of(options_));
  std::vector<OrthotropicFriction> laws;
  for (const ContactNode &node : surface.nodes)
  {
    const FrictionOptions there = options_.at(node.position[0], node.position[1]);
    laws.push_back(lies_in_section(symmetry) ? law_in_section(there) : law_of(there));
  }
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
  for (const ContactNode &node : surface.nodes)
    angles.push_back(options_.varying_angle->value(node.position[0], node.position[1]));
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

std::string FrictionField::asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const
{
  if (!varies())
    return constant_asymmetry(symmetry);
  for (const Vector2d &place : sample.of(symmetry))
  {
    if (symmetry.is_axisymmetric() && place[0] == 0)
      continue; // nothing slips on the axis
    const auto [friction, slip] = ellipses(options_.at(place[0], place[1]));
    for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
    {
      const Vector2d image = map * place;
      const Matrix2d turn = map.linear();
      const auto [friction_there, slip_there] = ellipses(options_.at(image[0], image[1]));
      if (!are_alike(friction_there, turn * friction * turn.transpose()) ||
          !are_alike(slip_there, turn * slip * turn.transpose()))
        return "friction at " + place_text(image) + " is no image of that at " + place_text(place);
    }
  }
  return {};
}

Eigen::Matrix<double, 6, 1> FrictionField::tensors(const Vector2d &place) const
{
  const auto [friction, slip] = ellipses(options_.at(place[0], place[1]));
  Eigen::Matrix<double, 6, 1> all;
  all << friction(0, 0), friction(0, 1), friction(1, 1), slip(0, 0), slip(0, 1), slip(1, 1);
  return all;
}
} // namespace orthocone
