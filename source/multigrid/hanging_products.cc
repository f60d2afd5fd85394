// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "hanging_products.h"

#include <orthocone/base/every_processor.h>

#include <algorithm>
#include <map>
#include <utility>

namespace orthocone
{
namespace
{
/// A degree of freedom, and the terms of its sum.
struct Sum
{
  unsigned int target;
  HangingDofs::Terms terms;
};

std::vector<Sum> sums_of_hanging(const HangingDofs &hanging)
{
  std::vector<Sum> sums;
  for (const unsigned int dof : hanging.numbers())
    sums.push_back({dof, hanging.terms(dof)});
  return sums;
}

/// The same weights by columns: all hanging ones that a degree of freedom moves.
std::vector<Sum> sums_of_moving(const HangingDofs &hanging)
{
  std::map<unsigned int, HangingDofs::Terms> terms;
  for (const unsigned int dof : hanging.numbers())
    for (const auto &[moving, weight] : hanging.terms(dof))
      terms[moving].push_back({dof, weight});
  std::vector<Sum> sums;
  for (auto &[moving, moved] : terms)
    sums.push_back({moving, std::move(moved)});
  return sums;
}

/// A node that hangs on an edge or a face of a larger cell moves as the nodes of that face let it:
///   u_hanging = sum of w_i u_i,   and forces on it go to them with the same weights, f_i += w_i f_hanging,
/// which does the same work. Both are sums of terms of different numbers, one a degree of freedom. A lane of
/// the processor takes one sum, and lanes of one batch go on until the longest of its sums is done, with the
/// weight 0 where one is shorter.
/// Sums of similar length share a batch.
template<typename Number>
LaneSums<Number> in_lanes(std::vector<Sum> sums)
{
  constexpr std::size_t lanes = Lanes<Number>::n;
  const auto is_longer = [](const Sum &a, const Sum &b) { return a.terms.size() > b.terms.size(); };
  std::stable_sort(sums.begin(), sums.end(), is_longer);
  LaneSums<Number> result;
  for (std::size_t first = 0; first < sums.size(); first += lanes)
  {
    const std::size_t n_terms = sums[first].terms.size(), n_before = result.weights.size();
    result.n_terms.push_back(static_cast<unsigned int>(n_terms));
    result.dofs.resize(result.dofs.size() + n_terms * lanes);
    result.weights.resize(n_before + n_terms, Lanes<Number>{});
    for (std::size_t i = first; i < std::min(first + lanes, sums.size()); ++i)
    {
      result.targets.push_back(sums[i].target);
      for (std::size_t t = 0; t < sums[i].terms.size(); ++t)
      {
        const auto &[dof, weight] = sums[i].terms[t];
        result.dofs[(n_before + t) * lanes + i - first] = dof;
        result.weights[n_before + t].values[i - first] = static_cast<Number>(weight);
      }
    }
  }
  return result;
}

/// Sets each target to its sum over `values`, or adds the sum to it.
template<typename Number>
ORTHOCONE_INLINE void put_sums(const LaneSums<Number> &sums, const Number *values, const bool adds,
                               Number *targets)
{
  constexpr std::size_t lanes = Lanes<Number>::n;
  const unsigned int *dofs = sums.dofs.data();
  const Lanes<Number> *weights = sums.weights.data();
  std::size_t first = 0;
  for (const unsigned int n_terms : sums.n_terms)
  {
    Lanes<Number> sum{};
    for (unsigned int t = 0; t < n_terms; ++t, dofs += lanes, ++weights)
    {
      Lanes<Number> of_term;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        of_term.values[lane] = values[dofs[lane]];
      sum.values += weights->values * of_term.values;
    }
    const std::size_t n = std::min(lanes, sums.targets.size() - first);
    for (std::size_t lane = 0; lane < n; ++lane)
    {
      Number &target = targets[sums.targets[first + lane]];
      target = adds ? target + sum.values[lane] : sum.values[lane];
    }
    first += lanes;
  }
}

ORTHOCONE_FOR_EVERY_PROCESSOR
void put(const LaneSums<float> &sums, const float *values, const bool adds, float *targets)
{
  put_sums(sums, values, adds, targets);
}

ORTHOCONE_FOR_EVERY_PROCESSOR
void put(const LaneSums<double> &sums, const double *values, const bool adds, double *targets)
{
  put_sums(sums, values, adds, targets);
}
} // namespace

template<typename Number>
HangingProducts<Number>::HangingProducts(const HangingDofs &hanging)
    : of_hanging_(in_lanes<Number>(sums_of_hanging(hanging))),
      of_moving_(in_lanes<Number>(sums_of_moving(hanging)))
{
}

template<typename Number>
void HangingProducts<Number>::distribute(Number *const displacement) const
{
  put(of_hanging_, displacement, false, displacement);
}

template<typename Number>
void HangingProducts<Number>::collect(Number *const forces) const
{
  put(of_moving_, forces, true, forces);
  for (const unsigned int hanging : of_hanging_.targets)
    forces[hanging] = 0;
}

template class HangingProducts<float>;
template class HangingProducts<double>;
} // namespace orthocone
