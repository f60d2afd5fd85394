// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "experiments.h"

#include "surface/half_space_patches.h"
#include "surface/surfaces.h"

#include <orthocone/base/numbers.h>
#include <orthocone/surface/half_space.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace orthocone::studies
{
namespace
{
constexpr double modulus = 210000, nu = 0.3; // the errors do not depend on them

struct Errors
{
  double work, centre; ///< relative
};

/// Of a uniform pressure on a square of side 2: its work, exact is 4/3 (1 - sqrt 2) + 4 log(1 + sqrt 2) for a
/// unit square, by the potential of the square at itself; and the displacement of the node at the centre
/// (Johnson, 3.3), NaN where there is no such node.
Errors errors_of(const unsigned int cells, const unsigned int degree, const unsigned int n_points)
{
  const double softness = (1 - nu * nu) / (pi * modulus), root = std::sqrt(2.);
  const ContactSurface surface = test::square_surface(cells, degree);
  const WholeSurface whole = ModelSymmetry().whole(surface);
  const auto patches = surface_patches(surface, whole, n_points);
  NodeVector force = NodeVector::Zero(3 * static_cast<Eigen::Index>(patches.size()));
  for (std::size_t i = 0; i < patches.size(); ++i)
    force[3 * static_cast<Eigen::Index>(whole.nodes[i].node)] = patches[i].area;
  const NodeVector moved =
      half_space_compliance({modulus, nu, n_points}, surface, ModelSymmetry(), LocalAxes(0)) * force;
  Errors errors{force.dot(moved) / (8 * softness * (4. / 3 * (1 - root) + 4 * std::log(1 + root))) - 1,
                std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    if (std::hypot(surface.nodes[i].position[0], surface.nodes[i].position[1]) < 1e-9)
      errors.centre = moved[3 * static_cast<Eigen::Index>(i)] / (8 * softness * std::log(1 + root)) - 1;
  return errors;
}

/// The power of two by which errors fall; each line has twice as many points or cells as the one before.
void print_order(const double before, const double error)
{
  std::cout << "," << error << "," << std::log2(std::abs(before / error));
}
} // namespace

void half_space(const Words &words)
{
  if (!words.empty())
    throw std::runtime_error("no further word is wanted");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::cout << "degree,cells,points,work,order,centre,order\n";
  // All patches of one face of degree 1 are near each other.
  for (const auto &[degree, n_points, cells] :
       {std::tuple<unsigned int, std::vector<unsigned int>, std::vector<unsigned int>>{
            1, {1, 2, 4, 8, 16}, {1}},
        {2, {2}, {2, 4, 8, 16, 32}},
        {2, {4}, {2, 4, 8, 16}}})
  {
    Errors before{none, none};
    for (const unsigned int n : n_points)
      for (const unsigned int m : cells)
      {
        const Errors errors = errors_of(m, degree, n);
        std::cout << degree << "," << m << "," << n;
        print_order(before.work, errors.work);
        print_order(before.centre, errors.centre);
        std::cout << std::endl;
        before = errors;
      }
  }
}
} // namespace orthocone::studies
