// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/stick_area.h>

#include <orthocone/base/numbers.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
using Polynomials = std::vector<dealii::Polynomials::Polynomial<double>>;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// As std::hypot(): to the last bit that of two components where the third one is 0.
double length_of(const Vector3d &vector)
{
  return std::hypot(std::hypot(vector[0], vector[1]), vector[2]);
}

/// A curved face of the contact surface: the isoparametric image of the unit square.
class Face
{
public:
  Face(const ContactSurface &surface, const std::vector<unsigned int> &nodes)
      : support_(dealii::QGaussLobatto<1>(surface.degree + 1)),
        polynomials_(dealii::Polynomials::generate_complete_Lagrange_basis(support_.get_points())),
        surface_(surface),
        nodes_(nodes)
  {
  }

  /// Area of the image of the cell between the support points (i, j) and (i + 1, j + 1), mm^2.
  double area(const unsigned int i, const unsigned int j) const
  {
    const dealii::QGauss<1> gauss(surface_.degree + 1);
    const double left = support_.point(i)[0], width = support_.point(i + 1)[0] - left;
    const double lower = support_.point(j)[0], height = support_.point(j + 1)[0] - lower;
    double sum = 0;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      for (unsigned int r = 0; r < gauss.size(); ++r)
        sum += gauss.weight(q) * gauss.weight(r) *
               stretch(left + width * gauss.point(q)[0], lower + height * gauss.point(r)[0]);
    return width * height * sum;
  }

private:
  /// Area of the image relative to the area at a place of the unit square.
  double stretch(const double x, const double y) const
  {
    const unsigned int n = polynomials_.size();
    std::vector<std::vector<double>> in_x(n, std::vector<double>(2)), in_y = in_x; // value and derivative
    for (unsigned int i = 0; i < n; ++i)
    {
      polynomials_[i].value(x, in_x[i]);
      polynomials_[i].value(y, in_y[i]);
    }
    Vector3d along_x = Vector3d::Zero(), along_y = Vector3d::Zero();
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        const Vector3d place = surface_.place(nodes_[j * n + i]).place();
        along_x += place * in_x[i][1] * in_y[j][0];
        along_y += place * in_x[i][0] * in_y[j][1];
      }
    return length_of(along_x.cross(along_y));
  }

  dealii::Quadrature<1> support_;
  Polynomials polynomials_;
  const ContactSurface &surface_;
  const std::vector<unsigned int> &nodes_;
};

template<typename Place>
Place between(const Place &from, const Place &to, const double along)
{
  return from + along * (to - from);
}

/// Area of a polygon whose corners are in order.
double polygon_area(const std::vector<Vector2d> &corners)
{
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector2d &a = corners[i];
    const Vector2d &b = corners[(i + 1) % corners.size()];
    sum += a[0] * b[1] - b[0] * a[1];
  }
  return std::abs(sum) / 2;
}
} // namespace

double stick_share(const double reserve, const double slip, const double edge_compliance, const double length)
{
  constexpr unsigned int most_iterations = 50;
  constexpr double settled = 1e-12;
  // With y = K^(2/3): squared reserve / y^3 + a / y = length. The cubic has one positive root, and Newton's
  // method falls to it from any point above.
  const double squared = reserve * reserve;
  const double a = std::pow(slip / edge_compliance, 2. / 3);
  double y = a / length + std::cbrt(squared / length);
  if (y <= 0)
    return 0.5;
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    const double change = ((length * y - a) * y * y - squared) / ((3 * length * y - 2 * a) * y);
    y -= change;
    if (change < settled * y)
      break;
  }
  return std::min(1., std::max(0., 1 - a / (y * length)));
}

StickArea::StickArea(const ContactSurface &surface, const MaterialOptions &material,
                     const SectionModel &section)
    : poisson_ratio_(material.isotropic().poisson_ratio),
      edge_compliance_(4. / 3 * (1 - std::pow(poisson_ratio_, 2)) / material.isotropic().young_modulus),
      section_(section)
{
  const bool is_section = !surface.faces.empty() && surface.faces.front().size() == surface.degree + 1;
  for (const auto &face : surface.faces)
    if (!is_section)
      add_cells(surface, face);
    else
      for (unsigned int i = 0; i < surface.degree; ++i)
        rings_.push_back({{{face[i], face[i + 1]}},
                          {{surface.place(face[i]).place(), surface.place(face[i + 1]).place()}}});
}

void StickArea::add_cells(const ContactSurface &surface, const std::vector<unsigned int> &face)
{
  const Face curved(surface, face);
  const unsigned int n = surface.degree + 1;
  for (unsigned int j = 0; j + 1 < n; ++j)
    for (unsigned int i = 0; i + 1 < n; ++i)
    {
      const unsigned int first = j * n + i;
      Cell cell{
          {{face[first], face[first + 1], face[first + n + 1], face[first + n]}}, {}, {}, curved.area(i, j)};
      auto &at = cell.positions;
      for (unsigned int corner = 0; corner < 4; ++corner)
        at[corner] = surface.place(cell.nodes[corner]).place();
      cell.normal = (at[2] - at[0]).cross(at[3] - at[1]).normalized();
      cells_.push_back(cell);
    }
}

double StickArea::operator()(const std::vector<StickSample> &samples) const
{
  double sum = 0;
  for (const Cell &cell : cells_)
    sum += cell.area * share(cell, samples);
  for (const Ring &ring : rings_)
    sum += area(ring, samples);
  return sum;
}

Eigen::Matrix3d StickArea::of_unknown_direction(const Vector3d &surface_normal) const
{
  return (Eigen::Matrix3d::Identity() - surface_normal * surface_normal.transpose()) / (2 - poisson_ratio_);
}

/// In-plane shear, slip across the border, is 1/(1 - nu) times as stiff as antiplane shear along it. Slip e
/// changes the traction by both, and n of that counts against the reserve (docs/theory.md, "Stick area").
double StickArea::edge_compliance(const StickSample &slipping, const Vector3d &normal) const
{
  constexpr double least = 0.05; // where slip hardly changes the reserve, higher orders decide
  if (slipping.normal_by_slip.isZero(0))
    return edge_compliance_;
  const double stiffness = (1 - poisson_ratio_) * slipping.normal_by_slip.trace() +
                           poisson_ratio_ * normal.dot(slipping.normal_by_slip * normal);
  return edge_compliance_ / std::max(least, stiffness);
}

/// The place where stick ends between two nodes, only one of which sticks: 0 at the first, 1 at the second.
double StickArea::border(const StickSample &first, const StickSample &second, const double length,
                         const Vector3d &normal) const
{
  const bool first_sticks = first.status == NodeStatus::stick;
  const StickSample &stuck = first_sticks ? first : second;
  const StickSample &other = first_sticks ? second : first;
  const double share = stick_share(stuck.reserve, other.slip, edge_compliance(other, normal), length);
  return first_sticks ? share : 1 - share;
}

/// Share of the polygon between the corners that stick and the places on the sides where stick ends.
double StickArea::share(const Cell &cell, const std::vector<StickSample> &samples) const
{
  std::array<bool, 4> sticks{};
  std::vector<unsigned int> sides;
  for (unsigned int i = 0; i < 4; ++i)
    sticks[i] = samples[cell.nodes[i]].status == NodeStatus::stick;
  for (unsigned int i = 0; i < 4; ++i)
    if (sticks[i] != sticks[(i + 1) % 4])
      sides.push_back(i);
  if (sides.empty())
    return sticks[0] ? 1 : 0;
  if (sides.size() == 4)
    return share_across(cell, samples);
  static const std::array<Vector2d, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const Borders borders = borders_of(cell, sides, samples);
  std::vector<Vector2d> polygon;
  auto next = borders.begin();
  for (unsigned int i = 0; i < 4; ++i)
  {
    if (sticks[i])
      polygon.push_back(corners[i]);
    if (sticks[i] != sticks[(i + 1) % 4])
      polygon.push_back(between(corners[i], corners[(i + 1) % 4], (next++)->along));
  }
  return polygon_area(polygon);
}

/// The same where opposite corners stick. Each corner has a triangle, and what is between the four is the
/// more on the side of a pair of corners, the larger its triangles are. Where the triangle of a corner is
/// nothing, that is the polygon of the three others.
double StickArea::share_across(const Cell &cell, const std::vector<StickSample> &samples) const
{
  std::array<double, 4> triangles{};
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Borders borders = borders_of(cell, {i, (i + 3) % 4}, samples);
    triangles[i] = 0.5 * borders[0].along * (1 - borders[1].along);
  }
  const unsigned int first = samples[cell.nodes[0]].status == NodeStatus::stick ? 0 : 1;
  const double stick = triangles[first] + triangles[first + 2];
  const double slip = triangles[1 - first] + triangles[3 - first];
  const double of_stick = triangles[first] * triangles[first + 2];
  const double of_slip = triangles[1 - first] * triangles[3 - first];
  const double between = of_stick + of_slip > 0 ? of_stick / (of_stick + of_slip) : 0.5;
  return stick + between * (1 - stick - slip);
}

/// Where stick ends on sides of a cell. Found twice: the distance of a side's ends across the border is known
/// only when the border is.
StickArea::Borders StickArea::borders_of(const Cell &cell, const std::vector<unsigned int> &sides,
                                         const std::vector<StickSample> &samples) const
{
  const Borders borders = borders_of(cell, sides, samples, std::nullopt);
  const auto normal = normal_of(cell, borders);
  return normal ? borders_of(cell, sides, samples, normal) : borders;
}

StickArea::Borders StickArea::borders_of(const Cell &cell, const std::vector<unsigned int> &sides,
                                         const std::vector<StickSample> &samples,
                                         const std::optional<Place> &normal) const
{
  constexpr double least_length = 0.1; // relative, of a side along the border
  Borders borders;
  for (const unsigned int i : sides)
  {
    const unsigned int next = (i + 1) % 4;
    const Place &from = cell.positions[i];
    const Place &to = cell.positions[next];
    const Vector3d side = to - from;
    double length = length_of(side);
    const Vector3d across = normal ? *normal : Vector3d(side / length);
    if (normal)
      length = std::max(least_length * length, std::abs(side.dot(*normal)));
    const double along = border(samples[cell.nodes[i]], samples[cell.nodes[next]], length, across);
    borders.push_back({along, between<Place>(from, to, along)});
  }
  return borders;
}

/// The normal, within the surface, of the line through two borders; nothing if both are at the same place.
std::optional<Vector3d> StickArea::normal_of(const Cell &cell, const Borders &borders)
{
  const Vector3d along = borders[1].place - borders[0].place;
  const double length = length_of(along);
  if (length == 0)
    return std::nullopt;
  return Vector3d(cell.normal.cross(along) / length);
}

double StickArea::area(const Ring &ring, const std::vector<StickSample> &samples) const
{
  const StickSample &inner = samples[ring.nodes[0]];
  const StickSample &outer = samples[ring.nodes[1]];
  const bool inner_sticks = inner.status == NodeStatus::stick;
  const bool outer_sticks = outer.status == NodeStatus::stick;
  if (!inner_sticks && !outer_sticks)
    return 0;
  std::array<Place, 2> places = ring.places;
  const Vector3d along = places[1] - places[0];
  const double length = length_of(along);
  if (inner_sticks != outer_sticks)
    places[inner_sticks ? 1 : 0] +=
        along * (border(inner, outer, length, along / length) - (inner_sticks ? 1 : 0));
  return section_.length_at((places[0][0] + places[1][0]) / 2) * length_of(places[1] - places[0]);
}
} // namespace orthocone
