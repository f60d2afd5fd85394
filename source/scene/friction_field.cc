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
#include <stdexcept>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
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
      : ForcesAgainstSlip(law, Matrix2d(map.transpose() * turned_by(angle)))
  {
  }

  /// The same where `to_map` (2 x 2, orthogonal) leads from the axes of the law to those of the directions.
  ForcesAgainstSlip(const FrictionLaw &law, const Matrix2d &to_map)
  {
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

bool is_isotropic(const FrictionLaw &law)
{
  const OrthotropicFriction *const ellipse = law.ellipse();
  return law.is_frictionless() ||
         (ellipse != nullptr && ellipse->mu_x == ellipse->mu_y && ellipse->p_x == ellipse->p_y);
}

/// Whether the axes of friction are those of a section without a third component: radius and hoop, or x and
/// y.
bool lies_in_section(const ModelSymmetry &symmetry)
{
  return symmetry.is_section() && !symmetry.has_third();
}

/// Friction along the axes of such a section, which are those of its ellipses; `is_across` says whether the
/// first of these is out of the section.
FrictionLaw law_in_section(const FrictionLaw &law, const bool is_across)
{
  const OrthotropicFriction *const ellipse = law.ellipse();
  if (ellipse == nullptr || !is_across)
    return law;
  return OrthotropicFriction{ellipse->mu_y, ellipse->mu_x, ellipse->p_y, ellipse->p_x};
}
} // namespace

FrictionLaw FrictionField::law(const Vector3d &place) const
{
  return options_.law.chosen().law(options_, place);
}

double FrictionField::angle(const Vector3d &place) const
{
  return options_.varying_angle ? options_.varying_angle->value(place[0], place[1], place[2])
                                : options_.angle;
}

Vector3d FrictionField::first_axis(const Vector3d &place) const
{
  if (!options_.first_axis)
    return axes_about_z(angle(place)).col(1);
  Vector3d axis;
  for (unsigned int d = 0; d < 3; ++d)
    axis[d] = (*options_.first_axis)[d].value(place[0], place[1], place[2]);
  return axis;
}

void FrictionField::check(const std::vector<SurfacePoint> &points) const
{
  for (const SurfacePoint &point : points)
  {
    const Vector3d &place = point.place;
    law(place);
    if (!first_axis(place).allFinite() && std::isfinite(angle(place)))
      throw InputError("Friction/First axis is not a number at " + place_text(place) +
                       " of the contact surface: allowed are three finite numbers");
    if (std::isfinite(angle(place)))
      continue;
    Parameters parameters;
    parameters.friction = options_;
    throw InputError(entry_text(parameters, "Friction/Orthotropy angle") + " is " + value_text(angle(place)) +
                     " at " + place_text(place) +
                     " of the contact surface: allowed is a finite number (degrees)");
  }
}

std::vector<FrictionLaw> FrictionField::laws(const ContactSurface &surface, const Obstacle &obstacle,
                                             const ModelSymmetry &symmetry) const
{
  const std::vector<SurfacePoint> points = points_of(surface);
  if (lies_in_section(symmetry) && !has_angle(obstacle))
    return laws_in_section(points, obstacle);
  if (!varies())
    return std::vector<FrictionLaw>(surface.nodes.size(), law(Vector3d::Zero()));
  std::vector<FrictionLaw> laws;
  for (const SurfacePoint &point : points)
  {
    const double turned = std::abs(std::remainder(angle(point.place), 2 * right_angle));
    laws.push_back(lies_in_section(symmetry) ? law_in_section(law(point.place), turned > right_angle / 2)
                                             : law(point.place));
  }
  return laws;
}

std::vector<FrictionLaw> FrictionField::laws_in_section(const std::vector<SurfacePoint> &points,
                                                        const Obstacle &obstacle) const
{
  const std::vector<Matrix3d> axes = frames(points, obstacle.normals(points));
  std::vector<FrictionLaw> laws;
  for (std::size_t i = 0; i < points.size(); ++i)
    laws.push_back(law_in_section(law(points[i].place), std::abs(axes[i](1, 1)) > std::sqrt(0.5)));
  return laws;
}

/// The axes in which a section sees its own forces: the tangent in the section, and the direction out of it.
static Matrix3d axes_of_section(const Vector3d &normal)
{
  return axes_along(normal, {normal[2], 0, -normal[0]});
}

/// Where any two tangents would do, others are taken if the first axis has no projection.
std::vector<Matrix3d> FrictionField::frames(const std::vector<SurfacePoint> &points,
                                            const std::vector<Vector3d> &normals) const
{
  std::vector<Matrix3d> frames;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3d &place = points[i].place;
    try
    {
      frames.push_back(axes_along(normals[i], first_axis(place)));
    }
    catch (const std::domain_error &)
    {
      if (!is_isotropic(law(place)))
        throw InputError(
            "Friction/First axis: the first axis of orthotropic friction is along the normal at " +
            place_text(place) +
            " of the contact surface: allowed is a direction that is along the surface, such "
            "as First axis = 0, 0, 1 where the normal is horizontal");
      const Vector3d other = normals[i].unitOrthogonal();
      frames.push_back(axes_along(normals[i], other));
    }
  }
  return frames;
}

/// Normals of the obstacle at contact nodes, which on a plane of symmetry have no component across it.
static std::vector<Vector3d> normals_at(const ContactSurface &surface, const Obstacle &obstacle)
{
  std::vector<Vector3d> normals = obstacle.normals(points_of(surface));
  for (std::size_t i = 0; i < normals.size(); ++i)
    normals[i] = surface.nodes[i].with_symmetry(normals[i]);
  return normals;
}

LocalAxes FrictionField::axes(const ContactSurface &surface, const Obstacle &obstacle,
                              const ModelSymmetry &symmetry) const
{
  if (!has_angle(obstacle))
  {
    const std::vector<Vector3d> normals = normals_at(surface, obstacle);
    if (!lies_in_section(symmetry))
      return LocalAxes(frames(points_of(surface), normals));
    std::vector<Matrix3d> of_section;
    for (const Vector3d &normal : normals)
      of_section.push_back(axes_of_section(normal));
    return LocalAxes(of_section);
  }
  // Friction that is the same all around is isotropic where it does not vary.
  if ((symmetry.is_axisymmetric() && !varies()) || (lies_in_section(symmetry) && varies()))
    return LocalAxes(0);
  if (!options_.varying_angle)
    return LocalAxes(options_.angle);
  std::vector<double> angles;
  for (const SurfacePoint &point : points_of(surface))
    angles.push_back(angle(point.place));
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
                                             const std::vector<SurfacePoint> &points) const
{
  for (const SurfacePoint &point : points)
  {
    const Vector3d &place = point.place;
    if (symmetry.is_axisymmetric() && place[0] == 0)
      continue; // nothing slips on the axis
    for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
    {
      const Vector3d image = point.mapped(map).place;
      if (!ForcesAgainstSlip(law(image), angle(image), map.linear())
               .is_like(ForcesAgainstSlip(law(place), angle(place))))
        return "friction at " + place_text(image) + " is no image of that at " + place_text(place);
    }
  }
  return {};
}

/// As asymmetry_of_maps(), with the axes of both points: the map leads from the tangents of one to those of
/// the other.
std::string FrictionField::asymmetry_of_frames(const ModelSymmetry &symmetry,
                                               const std::vector<SurfacePoint> &points,
                                               const Obstacle &obstacle) const
{
  const std::vector<Matrix3d> own = frames(points, obstacle.normals(points));
  for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
  {
    Matrix3d in_space = Matrix3d::Identity();
    in_space.topLeftCorner<2, 2>() = map.linear();
    std::vector<SurfacePoint> images;
    for (const SurfacePoint &point : points)
      images.push_back(point.mapped(map));
    const std::vector<Matrix3d> of_images = frames(images, obstacle.normals(images));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (symmetry.is_axisymmetric() && points[i].place[0] == 0)
        continue; // nothing slips on the axis
      const Matrix2d to_own =
          own[i].rightCols<2>().transpose() * in_space.transpose() * of_images[i].rightCols<2>();
      if (!ForcesAgainstSlip(law(images[i].place), to_own)
               .is_like(ForcesAgainstSlip(law(points[i].place), Matrix2d(Matrix2d::Identity()))))
        return "friction at " + place_text(images[i].place) + " is no image of that at " +
               place_text(points[i].place);
    }
  }
  return {};
}

std::string FrictionField::asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample,
                                     const Obstacle &obstacle) const
{
  const std::string law_text = "Friction/Law = " + options_.law.word();
  if (symmetry.is_axisymmetric() && !options_.has_ellipses())
    return law_text + ", and a section knows ellipses only";
  // Of its own axes such a section keeps the semi-axes of ellipses alone.
  if (lies_in_section(symmetry) && !options_.has_ellipses() && (varies() || !has_angle(obstacle)))
    return law_text + " has axes that are not those of the section";
  if (!has_angle(obstacle))
    return asymmetry_of_frames(symmetry, sample.of(symmetry), obstacle);
  if (varies())
    return asymmetry_of_maps(symmetry, sample.of(symmetry));
  if (options_.has_ellipses())
    return constant_asymmetry(symmetry);
  return asymmetry_of_maps(symmetry, {{Vector3d::Zero()}}).empty()
             ? ""
             : law_text + " with Friction/Orthotropy angle = " + to_text(options_.angle) +
                   " is no image of itself";
}

VectorXd FrictionField::numbers(const Vector3d &place) const
{
  const Matrix2d turn = turned_by(angle(place));
  if (options_.has_ellipses())
  {
    const FrictionOptions there = options_.at(place[0], place[1], place[2]);
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
