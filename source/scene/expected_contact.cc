// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/expected_contact.h>

#include <orthocone/base/numbers.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/contact_material.h>
#include <orthocone/scene/load_path.h>
#include <orthocone/scene/obstacle.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/// What presses the body down, the largest of the load program.
struct Pressing
{
  double force = 0;  ///< N
  double motion = 0; ///< mm
};

Pressing pressing_of(const LoadOptions &load)
{
  constexpr unsigned int along_z = 2;
  Pressing pressing;
  for (const PathLeg &leg : load_path(load))
  {
    const Drive &drive = leg.after[along_z];
    double &largest = drive.by_force ? pressing.force : pressing.motion;
    largest = std::max(largest, -drive.value);
  }
  return pressing;
}

/// The body above the contact, as far as an estimate needs it.
struct Block
{
  double stiffness_modulus; ///< E* = E/(1 - nu^2) of both bodies, MPa
  double column;            ///< height / (E times base area), mm/N
  double height;            ///< mm
  double length;            ///< of a line of contact, mm
};

/// `length` (mm) is that of a line of contact.
Block block_of(const Parameters &parameters, const double length)
{
  const MaterialOptions material = contact_material(parameters).isotropic();
  const GeometryOptions &geometry = parameters.geometry;
  const auto widths = kind_of(geometry).half_widths(geometry);
  const double nu = material.poisson_ratio;
  const double depth = geometry.is_plane_strain() ? geometry.section_thickness() : 2 * widths[1];
  if (!kind_of(geometry).is_meshed()) // a line of contact sees no deeper than it is long
    return {material.young_modulus / (1 - nu * nu), 0, length, length};
  const double height = geometry.held_height();
  return {material.young_modulus / (1 - nu * nu), height / (material.young_modulus * 2 * widths[0] * depth),
          height, length};
}

/// Hertz' contact under a force, and the approach (mm) that it takes. A gap with the radii R_1 <= R_2 has the
/// equivalent radius R = sqrt(R_1 R_2); the ellipse has the area pi c^2 with c^3 = 3 F R / (4 E*), and its
/// axes are as R_2 to R_1 to the power 2/3 (K. L. Johnson, Contact Mechanics, 1985, section 4.2, within some
/// percent). The approach is c^2 / R. A line of the length L has the half width b with b^2 = 4 F R_1 / (pi E*
/// L), and approaches a body of the height H by F / (pi E* L) (2 ln(2 H / b) - 1) (his section 5.6, with nu =
/// 1/3 or so).
double set_hertz(const Block &block, const double force, const bool is_line, ExpectedContact &contact)
{
  const double modulus = block.stiffness_modulus;
  contact.force = force;
  if (is_line)
  {
    const double per_length = force / block.length;
    const double b = std::sqrt(4 * per_length * contact.radii[0] / (pi * modulus));
    contact.radii[1] = infinite;
    contact.half_widths = {{b, block.length / 2}};
    contact.pressure = 2 * per_length / (pi * b);
    return per_length / (pi * modulus) * std::max(1., 2 * std::log(2 * block.height / b) - 1);
  }
  const double radius = std::sqrt(contact.radii[0] * contact.radii[1]);
  const double c = std::cbrt(3 * force * radius / (4 * modulus));
  const double ratio = std::cbrt(contact.radii[1] / contact.radii[0]); // root of that of the axes
  contact.half_widths = {{c / ratio, c * ratio}};
  contact.pressure = 3 * force / (2 * pi * c * c);
  return c * c / radius;
}

/// The force under which contact and body together approach by `motion` (mm).
double force_of(const Block &block, const double motion, const bool is_line, ExpectedContact contact)
{
  constexpr unsigned int n_halvings = 60;
  double low = 0, high = block.column > 0 ? motion / block.column : 1;
  for (; !(block.column > 0) && set_hertz(block, high, is_line, contact) < motion && high < 1e100; high *= 2)
    continue;
  for (unsigned int i = 0; i < n_halvings; ++i)
  {
    const double force = (low + high) / 2;
    (set_hertz(block, force, is_line, contact) + force * block.column < motion ? low : high) = force;
  }
  return low;
}

/// Gap over the base of a body.
class GapOverBase
{
public:
  GapOverBase(const Parameters &parameters, const Obstacle &obstacle)
      : geometry_(parameters.geometry),
        kind_(kind_of(geometry_)),
        obstacle_(obstacle)
  {
  }

  double width() const { return kind_.half_widths(geometry_)[0]; }

  double at(const Vector2d &place) const { return obstacle_.gap({{place[0], place[1], 0}}); }

  /// The place of the smallest gap: the best of a grid, and then of ever smaller steps from there.
  Vector2d place_of_smallest() const
  {
    constexpr int n_half = 30;
    constexpr double finest = 1e-9;
    const double width = this->width();
    Vector2d best = Vector2d::Zero();
    for (int i = -n_half; i <= n_half; ++i)
      for (int j = -n_half; j <= n_half; ++j)
        take_if_smaller(Vector2d(i, j) * width / n_half, best);
    for (double step = width / n_half; step > finest * width; step /= 2)
      for (const Vector2d &way : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)})
        take_if_smaller(best + step * way, best);
    return best;
  }

  /// Second derivatives over a distance `h` (mm) to both sides.
  Eigen::Matrix2d curvature(const Vector2d &place, const double h) const
  {
    const auto gap = [&](const double x, const double y) { return at(place + h * Vector2d(x, y)); };
    const double middle = gap(0, 0);
    Eigen::Matrix2d hessian;
    hessian(0, 0) = gap(1, 0) - 2 * middle + gap(-1, 0);
    hessian(1, 1) = gap(0, 1) - 2 * middle + gap(0, -1);
    hessian(0, 1) = hessian(1, 0) = (gap(1, 1) - gap(1, -1) - gap(-1, 1) + gap(-1, -1)) / 4;
    return hessian / (h * h);
  }

  /// Length of the base along a direction, through a place, mm.
  double length(const Vector2d &place, const Vector2d &direction) const
  {
    double total = 0;
    for (const double sign : {1., -1.})
    {
      double on = 0, off = 4 * width();
      while (off - on > 1e-6 * width())
      {
        const double middle = (on + off) / 2;
        (is_on_base(place + sign * middle * direction) ? on : off) = middle;
      }
      total += on;
    }
    return total;
  }

private:
  bool is_on_base(const Vector2d &place) const { return kind_.is_on_base(geometry_, {{place[0], place[1]}}); }

  bool take_if_smaller(const Vector2d &place, Vector2d &best) const
  {
    const bool is_smaller = is_on_base(place) && at(place) < at(best);
    if (is_smaller)
      best = place;
    return is_smaller;
  }

  const GeometryOptions &geometry_;
  const ShapeKind &kind_;
  const Obstacle &obstacle_;
};

/// Sets the radii of the gap, measured over `distance` (mm). Returns whether it opens to both sides.
bool set_radii(const GapOverBase &gap, const double distance, const bool is_section, ExpectedContact &contact)
{
  Eigen::Matrix2d curvature = gap.curvature(contact.centre, distance);
  if (is_section)
    curvature(0, 1) = curvature(1, 0) = curvature(1, 1) = 0;
  if (!curvature.allFinite())
    return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(curvature);
  const Vector2d &values = axes.eigenvalues(); // the larger one comes last
  if (!(values[1] > 0) || 1 / values[1] > 1e12)
    return false;
  contact.first_axis = axes.eigenvectors().col(1);
  contact.radii = {{1 / values[1], values[0] > 0 ? 1 / values[0] : infinite}};
  return true;
}

/// Sets forces, widths and pressure for the radii. Returns whether the contact stays off the rim.
bool set_contact(const Block &block, const Pressing &pressing, const double width, ExpectedContact &contact)
{
  const double motion = pressing.motion;
  const auto set = [&](const bool is_line)
  {
    const double force = std::max(pressing.force, motion > 0 ? force_of(block, motion, is_line, contact) : 0);
    if (force > 0)
      set_hertz(block, force, is_line, contact);
    return force > 0;
  };
  if (contact.radii[1] < infinite && !set(false))
    return false;
  if (!(contact.radii[1] < infinite) || contact.half_widths[1] > width)
    if (!set(true))
      return false;
  return contact.half_widths[0] < width;
}
} // namespace

bool ExpectedContact::contains(const Vector2d &place) const
{
  const Vector2d second(-first_axis[1], first_axis[0]), from_centre = place - centre;
  const double x = from_centre.dot(first_axis) / half_widths[0];
  const double y = is_line() ? 0 : from_centre.dot(second) / half_widths[1];
  return x * x + y * y <= 1;
}

std::optional<ExpectedContact> expected_contact(const Parameters &parameters)
{
  constexpr unsigned int n_rounds = 4; // of curvature over the width that the one before has
  constexpr double first_share = 0.05; // of the base, over which the curvature is measured first
  if (parameters.obstacle.is_plane() || !kind_of(parameters.geometry).has_known_sizes() ||
      !parameters.geometry.touches_with_base_only())
    return std::nullopt;
  const auto obstacle = make_obstacle(parameters.obstacle);
  const GapOverBase gap(parameters, *obstacle);
  const bool is_section = parameters.geometry.is_plane_strain();
  ExpectedContact contact;
  contact.centre = gap.place_of_smallest();
  Pressing pressing = pressing_of(parameters.load);
  pressing.motion -= gap.at(contact.centre);
  double distance = first_share * gap.width();
  for (unsigned int i = 0; i < n_rounds; ++i, distance = contact.half_widths[0])
  {
    if (!set_radii(gap, distance, is_section, contact))
      return std::nullopt;
    const Vector2d second(-contact.first_axis[1], contact.first_axis[0]);
    const double length =
        is_section ? parameters.geometry.section_thickness() : gap.length(contact.centre, second);
    if (!set_contact(block_of(parameters, length), pressing, gap.width(), contact))
      return std::nullopt;
  }
  return contact;
}

std::string describe(const ExpectedContact &contact)
{
  const auto [a, b] = contact.half_widths;
  std::ostringstream text;
  text.precision(3);
  if (contact.is_line())
    text << "half width " << a << " mm";
  else if (std::abs(a - b) < 1e-3 * b)
    text << "radius " << a << " mm";
  else
    text << "ellipse with half axes " << a << " and " << b << " mm";
  text << ", pressure " << contact.pressure << " MPa (Hertz, " << contact.force << " N on radius "
       << contact.radii[0];
  if (!contact.is_line() && std::abs(a - b) >= 1e-3 * b)
    text << " and " << contact.radii[1];
  text << " mm)";
  return text.str();
}

double nodes_across(const ExpectedContact &contact, const ContactSurface &surface,
                    const ModelSymmetry &symmetry)
{
  const double rounding = 1e-6 * contact.half_widths[0];
  const SymmetryPlanes planes = symmetry.planes();
  const bool is_mirrored_x = planes.normal_to_x || symmetry.is_axisymmetric();
  std::set<std::pair<long, long>> inside; // places along and across the first axis
  for (const ContactNode &node : surface.nodes)
    for (const double x : {1., is_mirrored_x ? -1. : 1.})
      for (const double y : {1., planes.normal_to_y ? -1. : 1.})
        if (const Vector2d place(x * node.position[0], y * node.position[1]); contact.contains(place))
        {
          const double across = contact.first_axis[0] * place[1] - contact.first_axis[1] * place[0];
          inside.emplace(std::lround(contact.first_axis.dot(place) / rounding),
                         contact.is_line() ? 0 : std::lround(across / rounding));
        }
  const auto n = static_cast<double>(inside.size());
  if (contact.is_line() || symmetry.is_axisymmetric())
    return n;
  // Nodes that lie alike in an ellipse of the area pi a b have the distance sqrt(pi a b / n).
  return 2 * std::sqrt(n / pi * contact.half_widths[0] / contact.half_widths[1]);
}
} // namespace orthocone
