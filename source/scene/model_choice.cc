// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/model_choice.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/asymmetry.h>
#include <orthocone/scene/options.h>
#include <orthocone/scene/surface_sample.h>

namespace orthocone
{
namespace
{
std::string possible_models(const Asymmetry &asymmetry)
{
  const unsigned int n_copies = asymmetry.planes().n_copies();
  return std::string(n_copies == 1   ? "full"
                     : n_copies == 2 ? "full, half"
                                     : "full, half, quarter") +
         (asymmetry.can_be_revolved() ? ", axisymmetric" : "");
}

[[noreturn]] void reject(const Parameters &parameters, const Asymmetry &asymmetry, const std::string &why)
{
  throw InputError("Mesh/Model = " + to_word(parameters.mesh.model) + " is not possible: " + why +
                   "; possible models are " + possible_models(asymmetry));
}

/// Only two planes of symmetry, or its axis, hold a body whose top is free sideways.
void check_guided_top(const Parameters &parameters, const Asymmetry &asymmetry, const ModelSymmetry &symmetry)
{
  if (parameters.geometry.top_face != TopFace::guided || symmetry.is_axisymmetric() ||
      symmetry.n_copies() == 4)
    return;
  const bool has_quarter = asymmetry.planes().n_copies() == 4;
  if (has_quarter || asymmetry.can_be_revolved())
    throw InputError("Geometry/Top face = guided with Mesh/Model = " + to_word(parameters.mesh.model) +
                     " is not possible: the model could drift sideways; possible models are " +
                     (has_quarter ? "quarter" : "") +
                     (has_quarter && asymmetry.can_be_revolved() ? ", " : "") +
                     (asymmetry.can_be_revolved() ? "axisymmetric" : "") + " and auto");
  throw InputError("Geometry/Top face = guided needs the quarter model, which is not possible: " +
                   asymmetry.of_planes());
}

void check_degree(const Parameters &parameters, const Asymmetry &asymmetry, const ModelSymmetry &symmetry)
{
  constexpr unsigned int most_of_solids = 3;
  if (parameters.mesh.degree > most_of_solids && !symmetry.is_axisymmetric())
    throw InputError("Mesh/Degree = " + std::to_string(parameters.mesh.degree) + " with the " +
                     symmetry.name() + " model: allowed is a whole number from 1 to 3" +
                     (asymmetry.can_be_revolved() ? ", or Mesh/Model = axisymmetric" : ""));
}

/// Refuses multigrid for sections: they are small, so that a factorization serves them better.
void check_backend(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.mesh.backend == BodyBackend::multigrid && symmetry.is_axisymmetric())
    throw InputError("Mesh/Backend = multigrid with the axisymmetric model: allowed is auto or condensed, or "
                     "Mesh/Model = quarter");
}

ModelChoice smallest_choice(const Parameters &parameters, const Asymmetry &asymmetry)
{
  const bool varies = varies_over_surface(parameters);
  const std::string compared = varies ? "; gap and friction were compared at all contact nodes" : "";
  if (asymmetry.can_be_revolved())
    return {ModelSymmetry::of_revolution(),
            (varies ? "friction and gap are the same all around" : "friction is isotropic") +
                (" and the top moves along the axis" + compared)};
  const SymmetryPlanes planes = asymmetry.planes();
  return {planes, planes.n_copies() == 4 ? std::string("friction, ") + (varies ? "gap, " : "") +
                                               "load and mesh are symmetric about x = 0 and y = 0" + compared
                                         : asymmetry.of_planes()};
}

/// A file has one part of the body. The scene must have the symmetry of this part, and no other model can be
/// asked for.
ModelChoice choice_of_file(const Parameters &parameters, const Asymmetry &asymmetry)
{
  const SymmetryPlanes &planes = asymmetry.of_file;
  for (const unsigned int d : {0, 1})
    if ((d == 0 ? planes.normal_to_x : planes.normal_to_y) && !asymmetry.has_plane(d))
      throw InputError("Geometry/Symmetry surfaces: the mesh file ends at " + std::string(1, "xy"[d]) +
                       " = 0, about which the scene is not symmetric: " + asymmetry.about_planes[d] +
                       "; allowed is a mesh of both sides");
  if (parameters.mesh.model != ModelKind::automatic && to_word(parameters.mesh.model) != planes.name())
    throw InputError("Mesh/Model = " + to_word(parameters.mesh.model) +
                     " is not possible: the mesh file has " + "the " + planes.name() +
                     " body; possible models are " + planes.name() + ", auto");
  return {planes, "what the mesh file has"};
}

/// Refuses a lower body's file that ends where the model does not.
void check_lower_file(const Asymmetry &asymmetry, const ModelSymmetry &symmetry)
{
  const SymmetryPlanes &planes = asymmetry.of_lower_file;
  for (const unsigned int d : {0, 1})
    if ((d == 0 ? planes.normal_to_x : planes.normal_to_y) &&
        !(d == 0 ? symmetry.planes().normal_to_x : symmetry.planes().normal_to_y))
      throw InputError("Lower geometry/Symmetry surfaces: the mesh file ends at " + std::string(1, "xy"[d]) +
                       " = 0, but the model (" + symmetry.name() + ") does not" +
                       (asymmetry.has_plane(d) ? "" : ": " + asymmetry.about_planes[d]) +
                       "; allowed is a mesh of both sides");
}

ModelSymmetry requested_symmetry(const Parameters &parameters, const Asymmetry &asymmetry)
{
  const SymmetryPlanes smallest = asymmetry.planes();
  switch (parameters.mesh.model)
  {
  case ModelKind::automatic:
  case ModelKind::full:
    break;
  case ModelKind::half:
    if (smallest.n_copies() == 1)
      reject(parameters, asymmetry, asymmetry.of_planes());
    return SymmetryPlanes{!smallest.normal_to_y, smallest.normal_to_y};
  case ModelKind::quarter:
    if (smallest.n_copies() < 4)
      reject(parameters, asymmetry, asymmetry.of_planes());
    return SymmetryPlanes{true, true};
  case ModelKind::axisymmetric:
    if (!asymmetry.can_be_revolved())
      reject(parameters, asymmetry, asymmetry.about_axis);
    return ModelSymmetry::of_revolution();
  }
  return {};
}
} // namespace

ModelChoice choose_model(const Parameters &parameters)
{
  const Asymmetry asymmetry = asymmetry_of(parameters);
  const ModelChoice choice =
      parameters.geometry.is_from_file() ? choice_of_file(parameters, asymmetry)
      : parameters.mesh.model == ModelKind::automatic
          ? smallest_choice(parameters, asymmetry)
          : ModelChoice{requested_symmetry(parameters, asymmetry), "as Mesh/Model says"};
  check_guided_top(parameters, asymmetry, choice.symmetry);
  check_degree(parameters, asymmetry, choice.symmetry);
  check_backend(parameters, choice.symmetry);
  check_lower_file(asymmetry, choice.symmetry);
  return choice;
}
} // namespace orthocone
