// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/shape_kind.h>

#include "../names_of_groups.h"
#include "shapes.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/grading.h>
#include <orthocone/base/text.h>

#include <cmath>

namespace orthocone
{
const std::vector<const ShapeKind *> &shape_kinds()
{
  static const std::vector<const ShapeKind *> kinds{&cylinder_kind(), &box_kind(), &file_kind(),
                                                    &half_space_kind()};
  return kinds;
}

const ShapeKind &kind_of(const GeometryOptions &geometry)
{
  const auto &kinds = shape_kinds();
  return **std::find_if(kinds.begin(), kinds.end(),
                        [&](const ShapeKind *kind) { return kind->shape() == geometry.shape; });
}

double GeometryOptions::held_height() const
{
  return kind_of(*this).held_height(*this);
}

double GeometryOptions::section_thickness() const
{
  const auto known = kind_of(*this).thickness(*this);
  return known ? known->value : 0;
}

namespace
{
/// The kinds that a body may have: below another one there is always a mesh.
std::vector<const ShapeKind *> possible_kinds(const GeometryOptions &geometry)
{
  std::vector<const ShapeKind *> kinds;
  for (const ShapeKind *const kind : shape_kinds())
    if (kind->is_meshed() || !geometry.is_lower)
      kinds.push_back(kind);
  return kinds;
}

Codec<BodyShape> shape_codec(const std::vector<const ShapeKind *> &kinds)
{
  std::string allowed;
  for (const ShapeKind *const kind : kinds)
    allowed += (allowed.empty() ? "" : " | ") + std::string(kind->shape().word);
  const auto parse = [kinds](const std::string &text, std::string &) -> std::optional<BodyShape>
  {
    for (const ShapeKind *const kind : kinds)
      if (kind->shape().word == text)
        return kind->shape();
    return std::nullopt;
  };
  return {allowed, parse, [](const BodyShape &shape) { return std::string(shape.word); }};
}
} // namespace

Condition where_shape(const GeometryOptions &geometry, const std::function<bool(const ShapeKind &)> &holds)
{
  return {[&geometry, holds] { return holds(kind_of(geometry)); },
          [&geometry] { return geometry.shape_entry(); }};
}

Condition where_entries_of(const GeometryOptions &geometry, const ShapeKind &kind)
{
  return where_shape(geometry, [&kind](const ShapeKind &chosen)
                     { return &chosen == &kind || &chosen.kind_of_entries() == &kind; });
}

void declare_shape(GeometryOptions &geometry, Section &section)
{
  const std::vector<const ShapeKind *> kinds = possible_kinds(geometry);
  section.add("Shape", geometry.shape, shape_codec(kinds),
              std::string("Shape of the body, whose base at z = 0 faces the counterface and whose axis is z. "
                          "cylinder: of Radius and Height; box: of Sizes; file: the body of a Mesh file by "
                          "Gmsh") +
                  (geometry.is_lower ? "."
                                     : "; half-space: all that is above z = 0, without a mesh, which may "
                                       "touch within Sizes."));
  for (const ShapeKind *const kind : kinds)
    kind->declare(geometry, where_entries_of(geometry, *kind), section);
  section
      .add("Contact surface", geometry.contact_surfaces, group_names_codec(),
           "Surfaces that may touch the counterface, one or several: base (where nothing is named) and "
           "side of a cylinder; base, x-, x+, y- and y+ of a box; of a Mesh file the names or numbers of "
           "physical groups, or places such as z min. The counterface of all but a base needs "
           "Obstacle/Distance, or Obstacle/Normal = surface.")
      .only_if({[&geometry] { return !geometry.ignores_contact_surfaces(); },
                [&geometry] { return geometry.shape_entry(); }});
  declare_supports(geometry, section);
}

// The name of a physical group means nothing for another shape.
bool GeometryOptions::ignores_contact_surfaces() const
{
  if (is_from_file() || !faces_down || contact_surfaces.empty())
    return false;
  const std::vector<std::string> own = kind_of(*this).surfaces(*this);
  return std::none_of(contact_surfaces.begin(), contact_surfaces.end(),
                      [&](const std::string &name)
                      { return std::find(own.begin(), own.end(), name) != own.end(); });
}

std::vector<std::string> GeometryOptions::touching_surfaces() const
{
  return ignores_contact_surfaces() ? std::vector<std::string>() : contact_surfaces;
}

bool GeometryOptions::touches_with_base_only() const
{
  const std::vector<std::string> names = touching_surfaces();
  return !is_from_file() && (names.empty() || names == std::vector<std::string>{"base"});
}

bool GeometryOptions::touches_with(const std::string &surface) const
{
  return touches_with_base_only()
             ? surface == "base"
             : std::find(contact_surfaces.begin(), contact_surfaces.end(), surface) != contact_surfaces.end();
}

std::string GeometryOptions::contact_names() const
{
  std::string all;
  for (const std::string &name : contact_surfaces)
    all += (all.empty() ? "" : ", ") + shown(name);
  return all;
}

void declare_top_face(GeometryOptions &geometry, Section &section)
{
  section.add_word(
      "Top face", geometry.top_face,
      "How the top is held (of a file: its Held surface; of a lower body: the face opposite to the contact). "
      "clamped: it is the held face, which moves as a rigid plate; guided: its u_z is prescribed and it is "
      "free sideways, so that symmetry or Supports have to hold the body there; free: it is not held, so "
      "that Supports, Loads and the contact alone hold the body.");
}

void declare_kind(GeometryOptions &geometry, Section &section)
{
  section.add_word("Kind", geometry.kind,
                   "Whether the body is a solid or in plane strain. solid: displacements depend on x, y and "
                   "z; plane strain: they depend on x and z only. In plane strain the mesh is that of the "
                   "section y = 0, either of a box, whose thickness is l_y of Sizes and whose cells along y "
                   "do not count, or of a file; forces are those of the whole thickness, and the "
                   "displacement u_y(x, z) out of the plane is computed where friction or loads need it.");
  section
      .add("Thickness", geometry.thickness, number_codec(positive),
           "Thickness in mm, along y, of a body in plane strain whose section is a Mesh file.")
      .unit("mm")
      .only_if({[&geometry] { return geometry.is_plane_strain() && geometry.is_from_file(); },
                [&geometry]
                {
                  return geometry.is_from_file() ? geometry.section + "/Kind = " + to_word(geometry.kind)
                                                 : geometry.shape_entry();
                }});
}

std::string coarse_rim_warning(const BodyOptions &body)
{
  constexpr double most = 0.1; // divided by degree^2: that decides how well the singular slip is resolved
  constexpr double percent = 100;
  const ShapeKind &kind = kind_of(body.geometry);
  const MeshOptions &mesh = body.mesh;
  // Every round of refinement of single cells has the rim.
  const auto n_halvings = mesh.refinements + mesh.adaptive + mesh.refined_cells.size();
  const double size = std::ldexp(kind.rim_size(body), -static_cast<int>(n_halvings));
  if (!kind.has_known_sizes() || mesh.accuracy != 0 || size <= most * mesh.degree * mesh.degree)
    return {}; // with an accuracy the mesh is yet to be chosen
  return mesh.section + ": elements of degree " + std::to_string(mesh.degree) + " and " +
         to_text(std::round(percent * size)) + " % of " + kind.rim_unit() +
         " do not resolve the rim, so that the slip there may be wrong by 20 % and more: take a higher "
         "degree, more layers and " +
         kind.finer_rim() + " and Layer grading < 1";
}

void check_grading(const std::string &entry, const double grading, const unsigned int n_graded,
                   const std::string &what)
{
  constexpr double least_thickness = 1e-6;
  if (thinnest_share(n_graded, grading) < least_thickness)
    throw InputError(entry + " = " + to_text(grading) + " with " + what);
}

void check_layers(const MeshOptions &mesh, const unsigned int n)
{
  check_grading(mesh.section + "/Layer grading", mesh.layer_grading, (n + 1) / 2,
                std::to_string(n) +
                    " layers: allowed is a value that leaves every layer at least 1e-6 of the height");
}
} // namespace orthocone
