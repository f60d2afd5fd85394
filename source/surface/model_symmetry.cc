// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/model_symmetry.h>

#include <orthocone/base/numbers.h>

#include <array>
#include <cmath>

namespace orthocone
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr unsigned int n_sectors = 32; // of a revolved surface, as many as the paper's mesh has

Matrix2d turn(const double cosine, const double sine)
{
  Matrix2d map;
  map << cosine, -sine, sine, cosine;
  return map;
}

/// A turn by i of n parts of the circle; quarter turns without rounding.
Matrix2d turn_by_part(const unsigned int i, const unsigned int n)
{
  const double angle = 2 * pi * i / n;
  const bool is_quarter = 4 * i % n == 0;
  return is_quarter ? turn(std::round(std::cos(angle)), std::round(std::sin(angle)))
                    : turn(std::cos(angle), std::sin(angle));
}

/// Numbers the nodes of a whole surface in the order in which its faces name them.
class NodeNumbers
{
public:
  NodeNumbers(WholeSurface &whole, const std::size_t n_model_places)
      : whole_(whole),
        numbers_(n_model_places * whole.images.size(), none)
  {
  }

  /// The same for every call with this node and image.
  unsigned int of(const unsigned int node, const unsigned int image)
  {
    unsigned int &number = numbers_[node * whole_.images.size() + image];
    if (number == none)
    {
      number = whole_.nodes.size();
      whole_.nodes.push_back({node, image});
    }
    return number;
  }

private:
  static constexpr unsigned int none = -1;

  WholeSurface &whole_;
  std::vector<unsigned int> numbers_;
};

/// The disc that a line of contact nodes along the x axis sweeps. Its cells at the axis are degenerate: one
/// of their edges is the node there, and this node is one point, all of whose images coincide.
WholeSurface revolved(const ContactSurface &surface)
{
  const unsigned int n_places = n_sectors * surface.degree;
  WholeSurface whole;
  for (unsigned int i = 0; i < n_places; ++i)
    whole.images.push_back(turn_by_part(i, n_places));
  NodeNumbers numbers(whole, surface.n_places());
  for (unsigned int sector = 0; sector < n_sectors; ++sector)
    for (const auto &line : surface.faces)
    {
      whole.faces.emplace_back();
      for (unsigned int j = 0; j <= surface.degree; ++j)
        for (const unsigned int node : line)
        {
          const bool is_on_axis = surface.place(node).position[0] == 0;
          const unsigned int image = is_on_axis ? 0 : (sector * surface.degree + j) % n_places;
          whole.faces.back().push_back(numbers.of(node, image));
        }
    }
  return whole;
}
} // namespace

std::string SymmetryPlanes::name() const
{
  const unsigned int n = n_copies();
  return n == 1 ? "full" : n == 2 ? "half" : "quarter";
}

ModelSymmetry ModelSymmetry::of_revolution(const bool with_twist)
{
  ModelSymmetry symmetry;
  symmetry.section_ = SectionModel{SectionModel::Kind::revolved, with_twist};
  return symmetry;
}

ModelSymmetry ModelSymmetry::of_plane_strain(const double thickness, const bool has_third,
                                             const bool is_mirrored_about_x)
{
  ModelSymmetry symmetry(SymmetryPlanes{is_mirrored_about_x, false});
  symmetry.section_ = SectionModel{SectionModel::Kind::plane, has_third, thickness};
  return symmetry;
}

std::string ModelSymmetry::full_name() const
{
  if (!section_)
    return name();
  if (section_->is_revolved())
    return name() + (has_third() ? " with twist" : "");
  return "plane strain, " + name() + (has_third() ? ", with u_y" : "");
}

// A mirror turns a motion along its normal, or a rotation about an axis in its plane, into the opposite
// motion.
bool ModelSymmetry::leaves(const unsigned int component) const
{
  constexpr unsigned int ux = 0, uy = 1, uz = 2, rx = 3, ry = 4, rz = 5;
  if (is_axisymmetric())
    return component == uz || (has_third() && component == rz);
  // What turns a plane section about x or z moves it by a distance that grows with y.
  if (is_plane_strain() && (component == rx || component == rz || (component == uy && !has_third())))
    return false;
  const bool of_x = component == uy || component == uz || component == rx;
  const bool of_y = component == ux || component == uz || component == ry;
  return (!planes_.normal_to_x || of_x) && (!planes_.normal_to_y || of_y);
}

bool ModelSymmetry::carries(const unsigned int component) const
{
  constexpr unsigned int rx = 3, rz = 5;
  if (!is_plane_strain() || !has_third() || (component != rx && component != rz))
    return leaves(component);
  return component == rx || !planes_.normal_to_x;
}

unsigned int ModelSymmetry::n_images(const ContactSurface &surface, const ContactNode &node) const
{
  if (is_axisymmetric())
    return node.position[0] == 0 ? 1 : n_sectors * surface.degree;
  if (is_plane_strain())
    return (planes_.normal_to_x && !node.is_on_plane(0) ? 2 : 1) * n_across(surface);
  return (planes_.normal_to_x && !node.is_on_plane(0) ? 2 : 1) *
         (planes_.normal_to_y && !node.is_on_plane(1) ? 2 : 1);
}

Eigen::VectorXd ModelSymmetry::force_shares(const ContactSurface &surface) const
{
  Eigen::VectorXd shares(surface.nodes.size());
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    shares[static_cast<Eigen::Index>(i)] =
        static_cast<double>(n_images(surface, surface.nodes[i])) / n_copies();
  return shares;
}

Matrix2d ModelSymmetry::map_to(const Vector2d &position) const
{
  if (is_axisymmetric())
  {
    const double radius = std::hypot(position[0], position[1]);
    return radius == 0 ? Matrix2d::Identity() : turn(position[0] / radius, position[1] / radius);
  }
  return Vector2d(planes_.normal_to_x && position[0] < 0 ? -1 : 1,
                  planes_.normal_to_y && position[1] < 0 ? -1 : 1)
      .asDiagonal();
}

WholeSurface ModelSymmetry::mirrored(const ContactSurface &surface) const
{
  // The bits that are set in the index of an image that is mirrored along x, or along y.
  const std::array<unsigned int, 2> bit{
      {planes_.normal_to_x ? 1u : 0u, planes_.normal_to_y ? n_copies() / 2 : 0u}};
  WholeSurface whole;
  for (unsigned int image = 0; image < n_copies(); ++image)
    whole.images.emplace_back(Vector2d(image & bit[0] ? -1 : 1, image & bit[1] ? -1 : 1).asDiagonal());
  NodeNumbers numbers(whole, surface.n_places());
  const unsigned int n_side = surface.degree + 1;
  for (unsigned int image = 0; image < n_copies(); ++image)
    for (const auto &face : surface.faces)
    {
      // A reflection turns a face over; running through its first direction backwards turns it back.
      const bool is_turned = whole.images[image].determinant() < 0;
      whole.faces.emplace_back();
      for (unsigned int i = 0; i < face.size(); ++i)
      {
        const unsigned int node = face[is_turned ? i - i % n_side + (n_side - 1 - i % n_side) : i];
        // A node on a plane of symmetry coincides with its mirror image.
        unsigned int own_image = image;
        for (unsigned int direction = 0; direction < 2; ++direction)
          if (surface.place(node).is_on_plane(direction))
            own_image &= ~bit[direction];
        whole.faces.back().push_back(numbers.of(node, own_image));
      }
    }
  return whole;
}

WholeSurface ModelSymmetry::extruded(const ContactSurface &surface) const
{
  const unsigned int n_side = surface.degree + 1;
  WholeSurface whole;
  for (unsigned int copy = 0; copy < n_copies(); ++copy)
    for (unsigned int j = 0; j < n_side; ++j)
    {
      whole.images.emplace_back(Vector2d(copy == 1 ? -1 : 1, 1).asDiagonal());
      whole.shifts.push_back(section_->thickness * (static_cast<double>(j) / surface.degree - 0.5));
    }
  NodeNumbers numbers(whole, surface.n_places());
  for (unsigned int copy = 0; copy < n_copies(); ++copy)
    for (const auto &line : surface.faces)
    {
      whole.faces.emplace_back();
      for (unsigned int j = 0; j < n_side; ++j)
        for (unsigned int i = 0; i < n_side; ++i)
        {
          const unsigned int node = line[copy == 1 ? surface.degree - i : i];
          const unsigned int own_copy = surface.place(node).is_on_plane(0) ? 0 : copy;
          whole.faces.back().push_back(numbers.of(node, own_copy * n_side + j));
        }
    }
  return whole;
}

WholeSurface ModelSymmetry::whole(const ContactSurface &surface) const
{
  return is_axisymmetric() ? revolved(surface) : is_plane_strain() ? extruded(surface) : mirrored(surface);
}
} // namespace orthocone
