// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/motion_checks.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/surface/strip.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
using Eigen::Index;

namespace
{
bool touches(const ContactState &state, const std::size_t node)
{
  return state.status[node] != NodeStatus::open;
}

/// The shortest side of the box around a body, mm. A section has two.
double shortest_side(const BodyUnknowns &unknowns)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (unsigned int d = 0; d < 3; ++d)
  {
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (unsigned int dof = 0; dof < unknowns.n_owned(); ++dof)
    {
      least = std::min(least, unknowns.position(dof)[d]);
      largest = std::max(largest, unknowns.position(dof)[d]);
    }
    if (const double side = largest_of_ranks(largest) + largest_of_ranks(-least); side > 0)
      shortest = std::min(shortest, side);
  }
  return shortest;
}

/// Height of a body (mm), above a counterface with the normal z, or its size. The centre of a held face that
/// is very wide has lost its digits.
double height(const GeometryOptions &geometry, const ElasticBody &body)
{
  if (!geometry.is_from_file())
    return geometry.held_height();
  if (!geometry.faces_down)
    return shortest_side(body.unknowns());
  if (!geometry.held_surface.empty())
    return body.unknowns().held_centre()[2];
  double highest = 0; // of a lower body that supports hold; one process has all of it
  for (unsigned int dof = 0; dof < body.unknowns().n_dofs(); ++dof)
    highest = std::max(highest, body.unknowns().position(dof)[2]);
  return highest;
}

/// Takes displacements (3 n, mm) of a body of this height (mm) into account.
void check_strain(const ContactState &state, const NodeVector &displacement, const double height,
                  MotionChecks &checks)
{
  for (Index node = 0; node < state.n_nodes(); ++node)
    if (touches(state, static_cast<std::size_t>(node)))
    {
      checks.flattening = std::max(checks.flattening, displacement.segment<3>(3 * node).norm() / height);
      checks.crushing = std::max(checks.crushing, std::abs(displacement[3 * node]) / height);
    }
}

double largest_slip_in_contact(const ContactState &state)
{
  double largest = 0;
  for (Index node = 0; node < state.n_nodes(); ++node)
    if (touches(state, static_cast<std::size_t>(node)))
      largest = std::max(largest, state.displacement.segment<2>(3 * node + 1).norm());
  return largest;
}

double mean_pressure(const ContactSurface &surface, const ContactState &state)
{
  double force = 0, area = 0;
  for (std::size_t node = 0; node < surface.nodes.size(); ++node)
    if (touches(state, node))
    {
      force += state.force[3 * static_cast<Index>(node)];
      area += surface.nodes[node].area;
    }
  return relative(force, area);
}

/// Mean size of the faces of a contact surface, mm; of lines, their length.
double mean_size(const ContactSurface &surface, const ModelSymmetry &symmetry)
{
  double area = 0;
  for (const ContactNode &node : surface.nodes)
    area += node.area;
  const double of_face = area / static_cast<double>(surface.faces.size());
  return symmetry.is_plane_strain() ? of_face / symmetry.section()->thickness : std::sqrt(of_face);
}

/// The faces of the surface that touch, where the slip of their nodes has brought them.
ContactSurface touching_part(const Scene &scene, const ContactState &state)
{
  ContactSurface part = scene.surface();
  for (std::size_t node = 0; node < part.nodes.size(); ++node)
  {
    const Eigen::Vector3d slip =
        scene.axes().to_global(node, state.displacement.segment<2>(3 * static_cast<Index>(node) + 1));
    for (const unsigned int d : {0, 1})
      part.nodes[node].position[d] += slip[d];
    part.nodes[node].height += slip[2];
  }
  const auto is_open = [&](const std::vector<unsigned int> &face)
  {
    return std::none_of(face.begin(), face.end(),
                        [&](const unsigned int node) { return touches(state, node); });
  };
  part.faces.erase(std::remove_if(part.faces.begin(), part.faces.end(), is_open), part.faces.end());
  return part;
}

/// The lower body is met where it lay at the start (docs/theory.md, section 2, "A second elastic body
/// below"): that place is known to the size of a face.
void check_slide(const Scene &scene, const ContactState &state, MotionChecks &checks)
{
  const ContactSurface &own = scene.lower()->body().surface();
  checks.slide_of_face = largest_slip_in_contact(state) / mean_size(own, scene.symmetry());
  if (checks.slide_of_face > 1)
    checks.cover = covered_share(as_faces(touching_part(scene, state), scene.symmetry()),
                                 as_faces(own, scene.symmetry()), scene.lower()->facing());
}

/// Beyond its patches a half-space cannot touch.
double share_at_border(const BodyOptions &body, const ContactState &state)
{
  const SurfaceGrid grid = surface_grid(body.geometry, body.mesh);
  if (grid.is_periodic)
    return 0;
  double all = 0, at_border = 0;
  for (Index node = 0; node < state.n_nodes(); ++node)
  {
    const Index i = node % grid.n_x, j = node / grid.n_x;
    const double force = state.force[3 * node];
    all += force;
    at_border += i == 0 || j == 0 || i + 1 == grid.n_x || j + 1 == grid.n_y ? force : 0;
  }
  return relative(at_border, all);
}
} // namespace

MotionChecks motion_checks(const Scene &scene, const ContactState &state, const NodeVector &elastic,
                           const NodeVector &given_way)
{
  MotionChecks checks;
  if (scene.body().mesh().has_mesh())
    check_strain(state, elastic, height(scene.parameters().geometry, scene.body()), checks);
  else
    checks.border = share_at_border(scene.parameters(), state);
  checks.pressure_of_modulus =
      mean_pressure(scene.surface(), state) / scene.contact_material().isotropic().young_modulus;
  if (const LowerBody *const lower = scene.lower())
  {
    check_strain(state, given_way, height(scene.parameters().lower.geometry, lower->body()), checks);
    check_slide(scene, state, checks);
  }
  return checks;
}

std::optional<std::string> violation(const MotionChecks &checks)
{
  constexpr double flat = 1, least_cover = 0.9, percent = 100; // SurfaceCover::is_enough()
  if (checks.crushing >= flat)
    return "the contact is pressed by " + to_text(std::round(percent * checks.crushing)) +
           " % of the body's height towards its held face, which is more than a body can bear; are gaps and "
           "motions in mm, forces in N, moduli in MPa?";
  if (checks.cover < least_cover)
    return "the body has slid so far that only " + to_text(std::round(percent * checks.cover)) +
           " % of the contact lie on the lower body, but 90 % have to: shorten the slide, or take a larger "
           "lower body";
  return std::nullopt;
}
} // namespace orthocone
