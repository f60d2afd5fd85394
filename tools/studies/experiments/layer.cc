// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "experiments.h"
#include "layer_schemes.h"

#include <orthocone/march/contact_state.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::Vector2d;

/// Steps of a leg in the reference; all numbers of steps have to divide it.
constexpr unsigned int n_reference = 5 * (1 << 14);

OrthotropicFriction law_of(const std::string &name)
{
  static const std::map<std::string, OrthotropicFriction> laws{
      {"isotropic", {0.3, 0.3, 1, 1}}, {"B", {0.3, 0.15, 0.3, 0.15}}, {"C", {0.3, 0.15, 0.05, 0.2}}};
  if (laws.count(name) == 0)
    throw std::runtime_error("there is no friction '" + name + "'");
  return laws.at(name);
}

/// Positions of the top at the ends of legs. At the first one the node has not slipped.
std::vector<Vector2d> corners_of(const std::string &program, const OrthotropicFriction &law)
{
  const Vector2d slipping(law.mu_x, 0); // about to
  if (program == "turn")
    return {slipping, slipping + Vector2d(0, 0.2)};
  if (program == "far")
    return {slipping, slipping + Vector2d(0, 3)};
  if (program == "reversals")
    return {{0, 0}, {0.6, 0.1}, {0.1, 0.5}, {-0.5, -0.3}};
  throw std::runtime_error("there is no program '" + program + "'");
}

struct History
{
  std::vector<Vector2d> traction;  ///< after every step, the start first
  std::vector<double> dissipation; ///< until then
  double driven = 0;               ///< work that friction does instead of taking it
};

History march(Layer &layer, const std::string &scheme, const std::vector<Vector2d> &corners,
              const unsigned int n)
{
  History history{{corners[0]}, {0.}};
  LayerStep step{corners[0], corners[0], {0, 0}, {0, 0}};
  for (std::size_t leg = 1; leg < corners.size(); ++leg)
    for (unsigned int i = 1; i <= n; ++i)
    {
      step.top = corners[leg - 1] + double(i) / n * (corners[leg] - corners[leg - 1]);
      step.is_first_of_leg = i == 1;
      const Vector2d slip = layer.advance(scheme, step);
      const Vector2d change = slip - step.slip, traction = step.top - slip;
      // The plane's forces are opposite to the traction of the layer.
      history.dissipation.push_back(history.dissipation.back() +
                                    dissipation(-history.traction.back(), -traction, change));
      history.driven += std::max(0., -traction.dot(change));
      history.traction.push_back(traction);
      step.previous_slip = step.slip;
      step.slip = slip;
      step.old_top = step.top;
    }
  return history;
}

/// Backward Euler with n steps and twice as many, extrapolated at the ends of the n steps.
History extrapolated(Layer &layer, const std::vector<Vector2d> &corners, const unsigned int n)
{
  History history = march(layer, "backward-euler", corners, n);
  const History twice = march(layer, "backward-euler", corners, 2 * n);
  for (std::size_t i = 0; i < history.traction.size(); ++i)
  {
    history.traction[i] = 2 * twice.traction[2 * i] - history.traction[i];
    history.dissipation[i] = 2 * twice.dissipation[2 * i] - history.dissipation[i];
  }
  return history;
}

/// Prints a line: errors relative to mu_x and to all dissipated work, at the worst step.
void compare(const std::string &scheme, const OrthotropicFriction &law, const std::vector<Vector2d> &corners,
             const unsigned int n, const History &truth)
{
  if (n == 0 || n_reference % n != 0)
    throw std::runtime_error("the number of steps has to divide " + std::to_string(n_reference));
  Layer node(law);
  const History history =
      scheme == "richardson" ? extrapolated(node, corners, n) : march(node, scheme, corners, n);
  double error = 0, outside = 0;
  for (std::size_t i = 0; i < history.traction.size(); ++i)
  {
    error = std::max(error, (history.traction[i] - truth.traction[i * (n_reference / n)]).norm() / law.mu_x);
    outside = std::max(outside, node.norm(history.traction[i]) - 1);
  }
  const double total = truth.dissipation.back();
  std::cout << n << "," << error << "," << history.dissipation.back() / total - 1 << "," << node.n_solves()
            << "," << history.driven / total << "," << outside << "," << node.n_failures() << "\n";
}
} // namespace

void layer(const Words &words)
{
  if (words.size() < 4)
    throw std::runtime_error("the words are: scheme, program, friction, numbers of steps of a leg");
  const OrthotropicFriction law = law_of(words[2]);
  const auto corners = corners_of(words[1], law);
  Layer exact(law);
  const History truth = extrapolated(exact, corners, n_reference);
  std::cout << "steps,error,dissipation_error,solves,driven,outside,failures\n";
  for (std::size_t i = 3; i < words.size(); ++i)
    compare(words[0], law, corners, static_cast<unsigned int>(std::stoul(words[i])), truth);
}
} // namespace orthocone::studies
