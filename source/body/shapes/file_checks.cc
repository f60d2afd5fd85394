// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "file_checks.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/curved_surfaces.h>
#include <orthocone/body/shapes/gmsh_file.h>
#include <orthocone/body/shapes/surface_places.h>

namespace orthocone
{
namespace
{
/// Checks the surfaces that entries name, by a physical group or by their place; none may be named twice.
class SurfaceCheck
{
public:
  explicit SurfaceCheck(const GmshFile &file)
      : file_(file),
        box_(file)
  {
  }

  void require(const std::string &entry, const std::string &name)
  {
    const PhysicalGroup *const group = file_.find(2, name);
    const std::optional<PlaneOfAxis> plane = group == nullptr ? box_.find(name) : std::nullopt;
    const std::string given = entry + (name.empty() ? " is empty" : " = " + shown(name));
    if (group == nullptr && !plane)
      faults_.add(given + (name.empty() ? "" : " is no physical surface"));
    else if (group != nullptr ? group->n_elements == 0 : has_cells() && n_faces_in(file_, box_, *plane) == 0)
      faults_.add(given + " has no faces");
    else if (const std::string other = entry_of(group, plane); !other.empty())
      faults_.add(given + " is the surface of " + other + ", too");
    else
      seen_.push_back({entry, group, plane});
  }

  /// Checks a surface that other entries may name, too.
  void require_faces(const std::string &entry, const std::string &name)
  {
    std::vector<Surface> others;
    others.swap(seen_);
    require(entry, name);
    seen_.swap(others);
  }

  void throw_if_any() const
  {
    const std::string of_file = file_.faults.is_empty() ? "" : file_.path + ": " + file_.faults.text();
    if (!faults_.is_empty())
      faults_.throw_if_any(of_file + (of_file.empty() ? "" : "; "), allowed());
    file_.faults.throw_if_any(file_.path + ": ");
  }

private:
  struct Surface
  {
    std::string entry;
    const PhysicalGroup *group;
    std::optional<PlaneOfAxis> plane;
  };

  /// Whether all cells are there. Else no place can be looked for.
  bool has_cells() const { return file_.faults.is_empty(); }

  /// The entry that has named this surface before, or "".
  std::string entry_of(const PhysicalGroup *group, const std::optional<PlaneOfAxis> &plane) const
  {
    for (const Surface &other : seen_)
      if (plane ? other.plane && box_.are_same(*plane, *other.plane) : other.group == group)
        return other.entry;
    return "";
  }

  std::string allowed() const
  {
    const std::string groups = file_.list(2), in = ": allowed in " + file_.path;
    const bool has_groups = groups != "none";
    if (!has_cells())
      return in + " are " + groups;
    const std::string places = list_places(file_, box_), such = "planes on its outside such as x = 0";
    return in +
           (has_groups ? " are " + groups + ", each once, and "
                       : ", which has no physical surfaces (gmsh: Physical Surface(\"base\") = {1}), are ") +
           (places.empty() ? "" : places + " and other ") + such;
  }

  const GmshFile &file_;
  const MeshBox box_;
  std::vector<Surface> seen_;
  FaultList faults_;
};
} // namespace

void check_mesh_file(const GeometryOptions &geometry)
{
  if (geometry.mesh_file.empty())
    throw InputError(geometry.section + "/Mesh file is empty with " + geometry.shape_entry() +
                     ": allowed is the path of a mesh by Gmsh");
  const GmshFile file = collect_gmsh_file(
      geometry.mesh_file,
      geometry.is_plane_strain() ? std::optional(geometry.section_thickness()) : std::nullopt);
  check_curved_surfaces(geometry);
  SurfaceCheck check(file);
  if (geometry.contact_surfaces.empty())
    check.require(geometry.section + "/Contact surface", "");
  for (const std::string &surface : geometry.contact_surfaces)
    check.require(geometry.section + "/Contact surface", surface);
  const bool holds_itself = geometry.section + "" != "Geometry" && !geometry.supports.empty();
  if (!geometry.held_surface.empty() || !holds_itself) // no load drives the lower body
    check.require(geometry.section + "/Held surface", geometry.held_surface);
  for (const std::string &surface : geometry.symmetry_surfaces)
    check.require(geometry.section + "/Symmetry surfaces", surface);
  for (const CurvedSurface &curved : geometry.curved_surfaces)
    check.require_faces(geometry.section + "/Curved surfaces", curved.surface);
  for (const Support &support : geometry.supports)
    check.require(geometry.section + "/Supports", support.surface);
  for (const Load &load : geometry.loads)
    if (geometry.has(load))
      for (const std::string &surface : load.surfaces)
        check.require("Load program/Loads: " + load.name, surface);
  check.throw_if_any();
}
} // namespace orthocone
