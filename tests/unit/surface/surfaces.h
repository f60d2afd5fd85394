// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/model_symmetry.h>

#include <cmath>
#include <functional>

namespace orthocone::test
{
/// Places of a line of `cells` cells of this degree, 1 to 3, from `first` to `last`.
inline std::vector<double> places_of_line(const double first, const double last, const unsigned int cells,
                                          const unsigned int degree)
{
  const double node = std::sqrt(1. / 5) / 2;
  const std::vector<double> third{0, 0.5 - node, 0.5 + node, 1};
  std::vector<double> places;
  for (unsigned int i = 0; i <= cells * degree; ++i)
  {
    const unsigned int own = i % degree;
    const double share = degree == 3 ? third[own] : own / static_cast<double>(degree);
    places.push_back(first + (last - first) * (i / degree + share) / cells);
  }
  return places;
}

using PlaneMap = std::function<Eigen::Vector2d(double, double)>;

/// A square (-1, 1)^2 of cells x cells faces, or the part of it that planes of symmetry leave, mapped. Areas
/// are not filled in.
inline ContactSurface square_surface(const unsigned int cells, const unsigned int degree,
                                     const SymmetryPlanes &planes = {}, const PlaneMap &map = {})
{
  const unsigned int n_x = planes.normal_to_x ? cells / 2 : cells,
                     n_y = planes.normal_to_y ? cells / 2 : cells;
  const auto x = places_of_line(planes.normal_to_x ? 0 : -1, 1, n_x, degree);
  const auto y = places_of_line(planes.normal_to_y ? 0 : -1, 1, n_y, degree);
  ContactSurface surface;
  surface.degree = degree;
  for (const double v : y)
    for (const double u : x)
    {
      const Eigen::Vector2d at = map ? map(u, v) : Eigen::Vector2d(u, v);
      surface.nodes.push_back({{{at[0], at[1]}},
                               1,
                               {},
                               {{!(planes.normal_to_x && u == 0), !(planes.normal_to_y && v == 0), true}}});
    }
  for (unsigned int j = 0; j < n_y; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
    {
      surface.faces.emplace_back();
      for (unsigned int b = 0; b <= degree; ++b)
        for (unsigned int a = 0; a <= degree; ++a)
          surface.faces.back().push_back(degree * i + a +
                                         static_cast<unsigned int>(x.size()) * (degree * j + b));
    }
  return surface;
}

/// The unit circle as the image of the square (-1, 1)^2.
inline Eigen::Vector2d on_disc(const double u, const double v)
{
  return {u * std::sqrt(1 - v * v / 2), v * std::sqrt(1 - u * u / 2)};
}
} // namespace orthocone::test
