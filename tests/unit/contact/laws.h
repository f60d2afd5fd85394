// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Laws and points on which the contact column is tested.
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <array>
#include <cmath>
#include <vector>

namespace orthocone::test
{
/// The paper's cases A, B, C.
const OrthotropicFriction case_a{0.2, 0.2, 0.2, 0.2};
const OrthotropicFriction case_b{0.3, 0.15, 0.3, 0.15};
const OrthotropicFriction case_c{0.3, 0.15, 0.05, 0.2};

/// They, and strong friction whose slip rule is isotropic.
const std::array<OrthotropicFriction, 4> case_laws{{case_a, case_b, case_c, {1, 0.4, 1, 1}}};

/// Friction ellipses from extremely flat to extremely long, circular ones among them.
inline std::vector<OrthotropicFriction> wide_laws()
{
  std::vector<OrthotropicFriction> laws;
  for (const double mu_x : {1e-3, 0.1, 0.3, 1., 30., 1e3})
    for (const double ratio : {1e-3, 0.5, 1 - 1e-9, 1., 1 + 1e-13, 2., 1e3})
      laws.push_back({mu_x, mu_x * ratio, mu_x, mu_x * ratio});
  return laws;
}

/// Directions all over the sphere: axes, planes between them, and a spiral of points off all symmetries.
inline std::vector<Eigen::Vector3d> directions()
{
  std::vector<Eigen::Vector3d> all;
  for (int n = -1; n <= 1; ++n)
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        if (n != 0 || x != 0 || y != 0)
          all.push_back(Eigen::Vector3d(n, x, y).normalized());
  constexpr int n_spiral = 60;
  constexpr double golden_angle = 2.399963229728653;
  for (int i = 0; i < n_spiral; ++i)
  {
    const double height = 1 - 2 * (i + 0.5) / n_spiral;
    const double radius = std::sqrt(1 - height * height);
    all.emplace_back(height, radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i));
  }
  return all;
}
} // namespace orthocone::test
