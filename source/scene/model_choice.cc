// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/model_choice.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/body.h>
#include <orthocone/body/driven_field.h>
#include <orthocone/body/free_motion.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/asymmetry.h>
#include <orthocone/scene/load_path.h>
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

/// Only two planes of symmetry, or its axis, hold a body whose top is free sideways; in plane strain x = 0
/// does.
void check_guided_top(const Parameters &parameters, const Asymmetry &asymmetry, const ModelSymmetry &symmetry)
{
  const bool is_plane = symmetry.is_plane_strain();
  if (!parameters.geometry.supports.empty())
    return; // what they leave free is known when the body is meshed
  if (parameters.geometry.top_face != TopFace::guided || symmetry.is_axisymmetric() ||
      symmetry.n_copies() == (is_plane ? 2 : 4))
  {
    if (parameters.geometry.top_face == TopFace::guided && symmetry.has_third())
      throw InputError("Geometry/Top face = guided is not possible, because it does not hold the third "
                       "component of displacement, which is needed because " +
                       asymmetry.about_section + "; allowed is clamped");
    return;
  }
  if (is_plane)
    throw InputError("Geometry/Top face = guided needs the half model, which " +
                     (asymmetry.has_plane(0) ? std::string("Mesh/Model = half and auto choose")
                                             : "is not possible: " + asymmetry.about_planes[0]));
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
  if (parameters.mesh.degree > most_of_solids && !symmetry.is_section() &&
      kind_of(parameters.geometry).is_meshed())
    throw InputError("Mesh/Degree = " + std::to_string(parameters.mesh.degree) + " with the " +
                     symmetry.name() + " model: allowed is a whole number from 1 to 3" +
                     (asymmetry.can_be_revolved() ? ", or Mesh/Model = axisymmetric" : ""));
}

/// Refuses multigrid for sections: they are small, so that a factorization serves them better.
void check_backend(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.mesh.backend != BodyBackend::multigrid || !symmetry.is_section())
    return;
  if (symmetry.is_plane_strain())
    throw InputError("Mesh/Backend = multigrid with Geometry/Kind = plane strain, but multigrid solves "
                     "solids only: allowed is auto or condensed");
  throw InputError("Mesh/Backend = multigrid with the axisymmetric model: allowed is auto or condensed, or "
                   "Mesh/Model = quarter");
}

/// Whether entries ask for what only a solid has: a backend, processes, numbers of its cells, or problem
/// files.
bool asks_for_solid(const Parameters &parameters)
{
  return parameters.mesh.backend == BodyBackend::multigrid || n_ranks() > 1 ||
         !parameters.mesh.refined_cells.empty() || parameters.output.problem_interval != 0;
}

ModelChoice smallest_choice(const Parameters &parameters, const Asymmetry &asymmetry)
{
  const bool varies = varies_over_surface(parameters);
  const std::string compared = varies ? "; gap and friction were compared at all contact nodes" : "";
  if (asymmetry.can_be_revolved() && asymmetry.needs_third() && !asks_for_solid(parameters))
    return {ModelSymmetry::of_revolution(true), "scene and loads are the same all around" + compared +
                                                    "; with the twist, because " + asymmetry.about_section};
  if (asymmetry.can_be_revolved() && !asymmetry.needs_third())
    return {ModelSymmetry::of_revolution(),
            (varies ? "friction and gap are the same all around" : "friction is isotropic") +
                (" and the held face moves along the axis" + compared)};
  const SymmetryPlanes planes = asymmetry.planes();
  return {planes, planes.n_copies() == 4 ? std::string("friction, ") + (varies ? "gap, " : "") +
                                               "load and mesh are symmetric about x = 0 and y = 0" + compared
                                         : asymmetry.of_planes()};
}

/// The displacement of a half-plane has no datum: what moves the body against it must be a force.
void check_datum(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (!symmetry.is_plane_strain() || parameters.obstacle.kind != ObstacleKind::half_space)
    return;
  constexpr unsigned int n_translations = 3;
  for (const PathLeg &leg : load_path(parameters.load))
    for (unsigned int i = 0; i < n_translations; ++i)
      if (symmetry.leaves(i) && !leg.after[i].by_force)
        throw InputError(leg.entry + ": u" + "xyz"[i] + " is a motion, or not named, in " + leg.place +
                         ": allowed with Obstacle/Kind = half-space in plane strain is a force F" + "xyz"[i] +
                         ", such as 0, because the displacement of a half-plane has no datum");
}

/// The section of a scene in plane strain, which is halved where it is symmetric.
ModelChoice choice_of_plane_strain(const Parameters &parameters, const Asymmetry &asymmetry)
{
  if (!asymmetry.along_y.empty())
    throw InputError("Geometry/Kind = plane strain is not possible: " + asymmetry.along_y +
                     "; allowed is Kind = solid");
  const ModelKind model = parameters.mesh.model;
  const bool can_be_half = asymmetry.has_plane(0), must_be_half = asymmetry.of_file.normal_to_x;
  if (must_be_half && !can_be_half)
    throw InputError("Geometry/Symmetry surfaces: the mesh file ends at x = 0, about which the scene is not "
                     "symmetric: " +
                     asymmetry.about_planes[0] + "; allowed is a mesh of both sides");
  if (must_be_half && model == ModelKind::full)
    throw InputError("Mesh/Model = full is not possible: the mesh file contains the half body; possible "
                     "models are half, auto");
  if (model == ModelKind::quarter || model == ModelKind::axisymmetric ||
      (model == ModelKind::half && !can_be_half))
    throw InputError("Mesh/Model = " + to_word(model) + " is not possible: " +
                     (model == ModelKind::half
                          ? asymmetry.about_planes[0]
                          : "Geometry/Kind = plane strain is computed in a section (x, z)") +
                     "; possible models are full" + (can_be_half ? ", half" : "") + ", auto");
  const bool is_half = model == ModelKind::half || (model == ModelKind::automatic && can_be_half);
  std::string reason = asymmetry.needs_third()
                           ? "u_y is modelled because " + asymmetry.about_section
                           : "u_y is 0: friction and load are symmetric about the section y = 0";
  if (model == ModelKind::automatic)
    reason += is_half                                                ? "; the scene is symmetric about x = 0"
              : asymmetry.about_planes[0] == asymmetry.about_section ? ""
                                                                     : "; " + asymmetry.about_planes[0];
  return {plane_strain(parameters, asymmetry.needs_third(), is_half), reason};
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
                     " is not possible: the mesh file contains " + "the " + planes.name() +
                     " body; possible models are " + planes.name() + ", auto");
  return {planes, "the part that the mesh file contains"};
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
    return ModelSymmetry::of_revolution(asymmetry.needs_third());
  }
  return {};
}
} // namespace

void require_hold(const GeometryOptions &geometry, const BodyUnknowns &unknowns,
                  const ModelSymmetry &symmetry)
{
  if (!kind_of(geometry).is_meshed())
    return; // the far field holds it
  const std::string motion = free_motion(unknowns, symmetry);
  if (!motion.empty())
    throw InputError(geometry.section + "/Supports leave the " + symmetry.full_name() +
                     " model free to move " + motion + ": allowed are supports that hold it" +
                     (geometry.is_from_file() ? ", or a Held surface" : ", or Top face = clamped"));
}

void require_hold(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  const auto require = [&](BodyOptions body)
  {
    const GeometryOptions &geometry = body.geometry;
    const bool has_face = !geometry.is_from_file() || !geometry.held_surface.empty();
    const bool moves_surfaces =
        std::any_of(geometry.loads.begin(), geometry.loads.end(),
                    [&](const Load &load) { return geometry.has(load) && load.kind->moves_surface(); });
    if (geometry.supports.empty() && geometry.top_face == TopFace::clamped && has_face && !moves_surfaces)
      return; // held in all directions
    body.mesh.refinements = body.mesh.quadrature_points = 0;
    body.mesh.refined_cells.clear();
    body.mesh.degree = 1;
    const Body coarse(body, symmetry);
    require_hold(geometry, coarse.unknowns(), symmetry);
    if (const std::string twice = moved_twice(coarse, geometry); !twice.empty())
      throw InputError("Load program/Loads: " + twice +
                       " move the same nodes: allowed are surfaces that do not meet, or one load on both");
  };
  require(parameters);
  if (parameters.obstacle.kind == ObstacleKind::body)
    require(parameters.lower);
}

ModelChoice choose_model(const Parameters &parameters)
{
  const Asymmetry asymmetry = asymmetry_of(parameters);
  const ModelChoice choice =
      parameters.geometry.is_plane_strain() ? choice_of_plane_strain(parameters, asymmetry)
      : parameters.geometry.is_from_file()  ? choice_of_file(parameters, asymmetry)
      : parameters.mesh.model == ModelKind::automatic
          ? smallest_choice(parameters, asymmetry)
          : ModelChoice{requested_symmetry(parameters, asymmetry), "as Mesh/Model says"};
  check_guided_top(parameters, asymmetry, choice.symmetry);
  check_degree(parameters, asymmetry, choice.symmetry);
  check_backend(parameters, choice.symmetry);
  check_datum(parameters, choice.symmetry);
  check_lower_file(asymmetry, choice.symmetry);
  return choice;
}
} // namespace orthocone
