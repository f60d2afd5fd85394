// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "file_checks.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/parameters/gmsh_file.h>

namespace orthocone
{
namespace
{
/// Checks the physical surfaces that entries name; no surface may be named twice.
class SurfaceCheck
{
public:
  explicit SurfaceCheck(const GmshFile &file)
      : file_(file)
  {
  }

  void require(const std::string &entry, const std::string &name)
  {
    const std::string given = entry + (name.empty() ? " is empty" : " = " + shown(name));
    const PhysicalGroup *const group = file_.find(2, name);
    if (group == nullptr)
      throw InputError(given + (name.empty() ? "" : " is no physical surface") + ": allowed in " +
                       file_.path + " are " + file_.list(2));
    if (group->n_elements == 0)
      throw InputError(given + " has no faces in " + file_.path +
                       ": allowed is a physical surface with quadrilaterals");
    for (const auto &[other, entry_of_other] : seen_)
      if (other == group)
        throw InputError(given + " is that of " + entry_of_other + ", too: allowed in " + file_.path +
                         " are " + file_.list(2) + ", each once");
    seen_.emplace_back(group, entry);
  }

private:
  const GmshFile &file_;
  std::vector<std::pair<const PhysicalGroup *, std::string>> seen_;
};
} // namespace

void check_mesh_file(const GeometryOptions &geometry)
{
  if (geometry.mesh_file.empty())
    throw InputError("Geometry/Mesh file is empty with Geometry/Shape = file: allowed is the path of a mesh "
                     "by Gmsh");
  const GmshFile file = read_gmsh_file(geometry.mesh_file);
  SurfaceCheck check(file);
  check.require("Geometry/Contact surface", geometry.contact_surface);
  check.require("Geometry/Held surface", geometry.held_surface);
  for (const std::string &surface : geometry.symmetry_surfaces)
    check.require("Geometry/Symmetry surfaces", surface);
}
} // namespace orthocone
