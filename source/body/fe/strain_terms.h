// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/section_model.h>

#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>

#include <array>
#include <optional>

namespace orthocone
{
/// An entry of the displacement gradient, and the sign of what stands there.
struct GradientEntry
{
  unsigned int row;    ///< the component: x, y, z; in a revolved section r, hoop, z
  unsigned int column; ///< the direction of the derivative
  double sign = 1;
};

/// The derivatives of a shape function N in its strain, three in solids and sections alike: d_x, d_y, d_z N,
/// or d_x, d_z N and, in a revolved section, N / r. place() gives the entry of the displacement gradient that
/// one of them is if the component of DisplacementSpace moves.
template<int dim>
class StrainTerms;

template<>
class StrainTerms<3>
{
public:
  explicit StrainTerms(const SectionModel &) {}

  Eigen::Vector3d of(const dealii::FEValues<3> &values, const unsigned int node, const unsigned int q) const
  {
    const auto &gradient = values.shape_grad(node, q);
    return {gradient[0], gradient[1], gradient[2]};
  }
  static std::optional<GradientEntry> place(const unsigned int component, const unsigned int term)
  {
    return GradientEntry{component, term};
  }
  double volume(const dealii::FEValues<3> &values, const unsigned int q) const { return values.JxW(q); }
};

/// In cylindrical coordinates, of what is the same all around: u_r,r and u_r,z; u_z,r and u_z,z; u_theta,r
/// and u_theta,z; u_r / r at (hoop, hoop), and -u_theta / r at (r, hoop).
template<>
class StrainTerms<2>
{
public:
  explicit StrainTerms(const SectionModel &section)
      : section_(section)
  {
  }

  Eigen::Vector3d of(const dealii::FEValues<2> &values, const unsigned int node, const unsigned int q) const
  {
    const auto &gradient = values.shape_grad(node, q);
    if (!section_.is_revolved())
      return {gradient[0], gradient[1], 0};
    const double radius = values.quadrature_point(q)[0];
    // On the axis u_r / r and u_theta / r are the derivatives.
    return {gradient[0], gradient[1], radius > 0 ? values.shape_value(node, q) / radius : gradient[0]};
  }
  std::optional<GradientEntry> place(const unsigned int component, const unsigned int term) const
  {
    constexpr unsigned int radial = 0, along_axis = 1;
    constexpr std::array<unsigned int, 3> direction{{0, 2, 1}};
    if (term < 2)
      return GradientEntry{direction[component], 2 * term};
    if (!section_.is_revolved() || component == along_axis)
      return std::nullopt; // a motion along the axis does not change the length of the ring
    return component == radial ? GradientEntry{1, 1} : GradientEntry{0, 1, -1};
  }
  double volume(const dealii::FEValues<2> &values, const unsigned int q) const
  {
    return section_.length_at(values.quadrature_point(q)[0]) * values.JxW(q);
  }

private:
  SectionModel section_;
};
} // namespace orthocone
