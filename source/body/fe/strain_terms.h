// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/numbers.h>

#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>

#include <array>
#include <optional>

namespace orthocone
{
/// The derivatives of a shape function N in its strain, three in solids and sections alike: d_x, d_y, d_z N,
/// or d_r, d_z N and N / r. place() gives the entry of the displacement gradient (x, y, z; in a section r,
/// hoop, z) that one of them is if the component moves.
template<int dim>
struct StrainTerms;

template<>
struct StrainTerms<3>
{
  static Eigen::Vector3d of(const dealii::FEValues<3> &values, const unsigned int node, const unsigned int q)
  {
    const auto &gradient = values.shape_grad(node, q);
    return {gradient[0], gradient[1], gradient[2]};
  }
  static std::optional<std::array<unsigned int, 2>> place(const unsigned int component,
                                                          const unsigned int term)
  {
    return {{{component, term}}};
  }
  static double volume(const dealii::FEValues<3> &values, const unsigned int q) { return values.JxW(q); }
};

template<>
struct StrainTerms<2>
{
  static Eigen::Vector3d of(const dealii::FEValues<2> &values, const unsigned int node, const unsigned int q)
  {
    const auto &gradient = values.shape_grad(node, q);
    const double radius = values.quadrature_point(q)[0];
    // On the axis u_r / r is the derivative.
    return {gradient[0], gradient[1], radius > 0 ? values.shape_value(node, q) / radius : gradient[0]};
  }
  static std::optional<std::array<unsigned int, 2>> place(const unsigned int component,
                                                          const unsigned int term)
  {
    if (term < 2)
      return {{{2 * component, 2 * term}}};
    if (component == 0)
      return {{{1, 1}}};
    return std::nullopt; // a motion along the axis does not change the length of the ring
  }
  static double volume(const dealii::FEValues<2> &values, const unsigned int q)
  {
    return 2 * pi * values.quadrature_point(q)[0] * values.JxW(q);
  }
};
} // namespace orthocone
