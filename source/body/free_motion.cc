// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/free_motion.h>

#include <orthocone/base/ranks.h>
#include <orthocone/surface/rigid_motion.h>

#include <algorithm>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
/// Length to which rotations are scaled (mm): the farthest place from the centre.
double reach_of_body(const BodyUnknowns &unknowns)
{
  double reach = 0;
  for (unsigned int dof = 0; dof < unknowns.n_dofs(); ++dof)
    reach = std::max(reach, (unknowns.position(dof) - unknowns.held_centre()).norm());
  return largest_of_ranks(reach);
}

std::string motion_in_words(const unsigned int component)
{
  return (component < 3 ? "along " : "about ") + std::string(1, "xyz"[component % 3]);
}
} // namespace

// A motion m is free where R m vanishes on all held degrees of freedom: where the sum of squares m^T H m, H =
// sum of R_i^T R_i over these, is zero.
std::string free_motion(const BodyUnknowns &unknowns, const ModelSymmetry &symmetry)
{
  constexpr double rounding = 1e-10; // of the motion that is held best
  std::vector<unsigned int> components;
  for (unsigned int j = 0; j < n_rigid_components; ++j)
    if (symmetry.leaves(j))
      components.push_back(j);
  const double reach = reach_of_body(unknowns);
  const auto n = static_cast<Index>(components.size());
  MatrixXd hold = MatrixXd::Zero(n, n);
  for (unsigned int dof = unknowns.n_free(); dof < unknowns.n_owned(); ++dof)
  {
    if (unknowns.hanging().contains(dof))
      continue;
    VectorXd moved(n);
    for (Index j = 0; j < n; ++j)
    {
      RigidMotion unit;
      unit[components[j]] = components[j] < 3 ? 1 : 1 / reach;
      moved[j] = unit.at(unknowns.position(dof) - unknowns.held_centre())[unknowns.direction(dof)];
    }
    hold += moved * moved.transpose();
  }
  sum_over_ranks(hold.data(), static_cast<std::size_t>(hold.size()));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(hold);
  if (modes.eigenvalues()[0] > rounding * modes.eigenvalues()[n - 1])
    return {};
  Index largest = 0;
  modes.eigenvectors().col(0).cwiseAbs().maxCoeff(&largest);
  return motion_in_words(components[largest]);
}
} // namespace orthocone
