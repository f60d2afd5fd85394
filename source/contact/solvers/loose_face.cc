// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "loose_face.h"

#include <algorithm>
#include <vector>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// A node that approaches the obstacle on the way of the face.
struct Approach
{
  double touches; ///< share of the way at which it begins to carry
  double grows;   ///< how fast it carries the load from there on, per share, N^2
};
} // namespace

bool is_loose(const ContactConditions &conditions)
{
  return conditions.face.cols() > 0 &&
         std::all_of(conditions.nodes.begin(), conditions.nodes.end(),
                     [](const NodeCondition &node) { return node.n_unknowns == 0; });
}

/// The way is along the balance: a load that is carried as evenly as it can be.
VectorXd way_to_touch(const ContactStep &step, const VectorXd &unknowns, const NodeVector &displacement,
                      const double rho_factor)
{
  const VectorXd even = step.face().columns() * step.face().balance(); // N, and the way of the nodes, negative
  std::vector<Approach> approaches;
  double load = 0;
  for (Index i = 0; i < even.size(); i += 3)
  {
    load += even[i] * even[i];
    const double rho = rho_factor * step.system().rho(i / 3);
    if (even[i] > 0)
      approaches.push_back({(displacement[i] - unknowns[i] / rho) / even[i], rho * even[i] * even[i]});
  }
  std::sort(approaches.begin(), approaches.end(),
            [](const Approach &a, const Approach &b) { return a.touches < b.touches; });
  double share = 0, grows = 0, missed = 0;
  for (const Approach &node : approaches)
  {
    if (grows > 0 && share <= node.touches)
      break;
    grows += node.grows;
    missed += node.grows * node.touches;
    share = (load + missed) / grows;
  }
  return -share * step.face().balance();
}
} // namespace orthocone
