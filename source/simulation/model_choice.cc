// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/model_choice.h>

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>
#include <orthocone/simulation/load_program.h>

#include <cmath>

namespace orthocone
{
namespace
{
bool is_isotropic(const FrictionOptions &friction)
{
  return friction.mu[0] == friction.mu[1] && friction.p[0] == friction.p[1];
}

bool has_aligned_axes(const FrictionOptions &friction)
{
  constexpr double right_angle = 90;
  return std::remainder(friction.angle, right_angle) == 0;
}

/// Why the plane normal to `direction` (0: x, 1: y) is no plane of symmetry of the scene; empty if it is one.
std::string obstacle(const Parameters &parameters, const unsigned int direction)
{
  const char axis = direction == 0 ? 'x' : 'y';
  if (parameters.mesh.core_cells % 2 != 0)
    return "Mesh/Core cells = " + std::to_string(parameters.mesh.core_cells) + " is odd";
  if (!is_isotropic(parameters.friction) && !has_aligned_axes(parameters.friction))
    return "Friction/Orthotropy angle = " + to_text(parameters.friction.angle) +
           " turns the axes of friction";
  if (largest_motion(parameters.load, direction) > 0)
    return std::string("the load program moves the top along ") + axis;
  return {};
}

SymmetryPlanes smallest_model(const Parameters &parameters)
{
  return {obstacle(parameters, 0).empty(), obstacle(parameters, 1).empty()};
}

std::string possible_models(const SymmetryPlanes &planes)
{
  const unsigned int n_copies = planes.n_copies();
  return n_copies == 1 ? "full" : n_copies == 2 ? "full, half" : "full, half, quarter";
}

std::string all_obstacles(const Parameters &parameters)
{
  const std::string x = obstacle(parameters, 0);
  const std::string y = obstacle(parameters, 1);
  return x.empty() || x == y ? y : y.empty() ? x : x + " and " + y;
}

[[noreturn]] void reject(const Parameters &parameters, const std::string &request)
{
  throw InputError(request + " is not possible: " + all_obstacles(parameters) + "; possible models are " +
                   possible_models(smallest_model(parameters)));
}

/// A body that is free sideways at its top is held by nothing but two planes of symmetry.
void check_guided_top(const Parameters &parameters, const SymmetryPlanes &planes)
{
  if (parameters.geometry.top_face != TopFace::guided || planes.n_copies() == 4)
    return;
  if (smallest_model(parameters).n_copies() == 4)
    throw InputError(
        "Geometry/Top face = guided with Mesh/Model = " + to_word(parameters.mesh.model) +
        " is not possible: the model could drift sideways; possible models are quarter and auto");
  throw InputError("Geometry/Top face = guided needs the quarter model, which is not possible: " +
                   all_obstacles(parameters));
}
} // namespace

ModelChoice choose_model(const Parameters &parameters)
{
  const SymmetryPlanes smallest = smallest_model(parameters);
  ModelChoice choice{{}, "as Mesh/Model says"};
  switch (parameters.mesh.model)
  {
  case ModelKind::automatic:
    choice = {smallest, smallest.n_copies() == 4
                            ? "friction, load and mesh are symmetric about x = 0 and y = 0"
                            : all_obstacles(parameters)};
    break;
  case ModelKind::full:
    break;
  case ModelKind::half:
    if (smallest.n_copies() == 1)
      reject(parameters, "Mesh/Model = half");
    choice.planes = {!smallest.normal_to_y, smallest.normal_to_y};
    break;
  case ModelKind::quarter:
    if (smallest.n_copies() < 4)
      reject(parameters, "Mesh/Model = quarter");
    choice.planes = {true, true};
    break;
  }
  check_guided_top(parameters, choice.planes);
  return choice;
}
} // namespace orthocone
