// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/model_choice.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/parameters/values.h>
#include <orthocone/scene/load_program.h>

#include <cmath>

namespace orthocone
{
namespace
{
bool is_isotropic(const FrictionOptions &friction)
{
  return friction.mu[0] == friction.mu[1] && friction.p()[0] == friction.p()[1];
}

bool has_aligned_axes(const FrictionOptions &friction)
{
  constexpr double right_angle = 90;
  return std::remainder(friction.angle, right_angle) == 0;
}

/// Why the cells do not end at the plane normal to `direction`; empty if they do.
std::string obstacle_of_mesh(const Parameters &parameters, const unsigned int direction)
{
  if (parameters.geometry.shape == BodyShape::box)
  {
    const unsigned int n = parameters.mesh.cells[direction];
    return n % 2 == 0 ? ""
                      : "Mesh/Cells has an odd number along " + std::string(direction == 0 ? "x" : "y") +
                            ", " + std::to_string(n);
  }
  const unsigned int n = parameters.mesh.core_cells;
  return n % 2 == 0 ? "" : "Mesh/Core cells = " + std::to_string(n) + " is odd";
}

/// Why a load program is not as symmetric as a model; empty if it is.
std::string obstacle_of_load(const LoadOptions &load, const ModelSymmetry &symmetry)
{
  constexpr unsigned int first_rotation = 3;
  for (unsigned int component = 0; component < n_rigid_components; ++component)
    if (drives(load, component) && !symmetry.leaves(component))
      return std::string("the load program ") +
             (component < first_rotation ? "moves the top along " : "turns the top about ") +
             "xyz"[component % first_rotation];
  return {};
}

/// Why the plane normal to `direction` (0: x, 1: y) is no plane of symmetry of the scene; empty if it is one.
std::string obstacle(const Parameters &parameters, const unsigned int direction)
{
  if (std::string odd = obstacle_of_mesh(parameters, direction); !odd.empty())
    return odd;
  if (!is_isotropic(parameters.friction) && !has_aligned_axes(parameters.friction))
    return "Friction/Orthotropy angle = " + to_text(parameters.friction.angle) +
           " turns the axes of friction";
  return obstacle_of_load(parameters.load, SymmetryPlanes{direction == 0, direction == 1});
}

SymmetryPlanes smallest_model(const Parameters &parameters)
{
  return {obstacle(parameters, 0).empty(), obstacle(parameters, 1).empty()};
}

/// Why a revolved section is not the whole scene; empty if it is.
std::string obstacle_to_revolution(const Parameters &parameters)
{
  if (parameters.geometry.shape != BodyShape::cylinder)
    return "Geometry/Shape = " + to_word(parameters.geometry.shape) + " is no body of revolution";
  const FrictionOptions &friction = parameters.friction;
  if (friction.mu[0] != friction.mu[1])
    return "Friction/Coefficients = " + to_text(friction.mu[0]) + ", " + to_text(friction.mu[1]) +
           " differ, which makes friction orthotropic";
  if (friction.p()[0] != friction.p()[1])
    return "Friction/Slip potential = " + to_text(friction.p()[0]) + ", " + to_text(friction.p()[1]) +
           " differ, which makes slip orthotropic";
  return obstacle_of_load(parameters.load, ModelSymmetry::of_revolution());
}

bool can_be_revolved(const Parameters &parameters)
{
  return obstacle_to_revolution(parameters).empty();
}

std::string possible_models(const Parameters &parameters)
{
  const unsigned int n_copies = smallest_model(parameters).n_copies();
  return std::string(n_copies == 1   ? "full"
                     : n_copies == 2 ? "full, half"
                                     : "full, half, quarter") +
         (can_be_revolved(parameters) ? ", axisymmetric" : "");
}

std::string all_obstacles(const Parameters &parameters)
{
  const std::string x = obstacle(parameters, 0);
  const std::string y = obstacle(parameters, 1);
  return x.empty() || x == y ? y : y.empty() ? x : x + " and " + y;
}

[[noreturn]] void reject(const Parameters &parameters, const std::string &why)
{
  throw InputError("Mesh/Model = " + to_word(parameters.mesh.model) + " is not possible: " + why +
                   "; possible models are " + possible_models(parameters));
}

/// A body that is free sideways at its top is held by nothing but two planes of symmetry, or its axis.
void check_guided_top(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.geometry.top_face != TopFace::guided || symmetry.is_axisymmetric() ||
      symmetry.n_copies() == 4)
    return;
  const bool has_quarter = smallest_model(parameters).n_copies() == 4;
  if (has_quarter || can_be_revolved(parameters))
    throw InputError("Geometry/Top face = guided with Mesh/Model = " + to_word(parameters.mesh.model) +
                     " is not possible: the model could drift sideways; possible models are " +
                     (has_quarter ? "quarter" : "") +
                     (has_quarter && can_be_revolved(parameters) ? ", " : "") +
                     (can_be_revolved(parameters) ? "axisymmetric" : "") + " and auto");
  throw InputError("Geometry/Top face = guided needs the quarter model, which is not possible: " +
                   all_obstacles(parameters));
}

void check_degree(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  constexpr unsigned int most_of_solids = 3;
  if (parameters.mesh.degree > most_of_solids && !symmetry.is_axisymmetric())
    throw InputError("Mesh/Degree = " + std::to_string(parameters.mesh.degree) + " with the " +
                     symmetry.name() + " model: allowed is a whole number from 1 to 3" +
                     (can_be_revolved(parameters) ? ", or Mesh/Model = axisymmetric" : ""));
}

ModelChoice smallest_choice(const Parameters &parameters)
{
  if (can_be_revolved(parameters))
    return {ModelSymmetry::of_revolution(), "friction is isotropic and the top moves along the axis"};
  const SymmetryPlanes planes = smallest_model(parameters);
  return {planes, planes.n_copies() == 4 ? "friction, load and mesh are symmetric about x = 0 and y = 0"
                                         : all_obstacles(parameters)};
}

ModelSymmetry requested_symmetry(const Parameters &parameters)
{
  const SymmetryPlanes smallest = smallest_model(parameters);
  switch (parameters.mesh.model)
  {
  case ModelKind::automatic:
  case ModelKind::full:
    break;
  case ModelKind::half:
    if (smallest.n_copies() == 1)
      reject(parameters, all_obstacles(parameters));
    return SymmetryPlanes{!smallest.normal_to_y, smallest.normal_to_y};
  case ModelKind::quarter:
    if (smallest.n_copies() < 4)
      reject(parameters, all_obstacles(parameters));
    return SymmetryPlanes{true, true};
  case ModelKind::axisymmetric:
    if (!can_be_revolved(parameters))
      reject(parameters, obstacle_to_revolution(parameters));
    return ModelSymmetry::of_revolution();
  }
  return {};
}
} // namespace

ModelChoice choose_model(const Parameters &parameters)
{
  const ModelChoice choice = parameters.mesh.model == ModelKind::automatic
                                 ? smallest_choice(parameters)
                                 : ModelChoice{requested_symmetry(parameters), "as Mesh/Model says"};
  check_guided_top(parameters, choice.symmetry);
  check_degree(parameters, choice.symmetry);
  return choice;
}
} // namespace orthocone
