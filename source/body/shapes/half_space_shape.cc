// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shapes.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/body/grid_surface.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace orthocone
{
namespace
{
class HalfSpaceShape : public Shape
{
public:
  HalfSpaceShape(const GeometryOptions &geometry, const MeshOptions &mesh)
      : entry_(geometry.shape_entry()),
        grid_(surface_grid(geometry, mesh))
  {
  }

  void make_solid(const SymmetryPlanes &, dealii::Triangulation<3> &) const override
  {
    throw std::logic_error("a half-space has no mesh");
  }

  std::string asymmetry(const ModelSymmetry &) const override
  {
    return entry_ + " is computed as a whole, because the products of its grid need no symmetry to be fast";
  }

  ModelSize size(const ModelSymmetry &) const override
  {
    const auto n = static_cast<double>(grid_.n_nodes());
    return {n, n, 3 * n, 0};
  }

private:
  std::string entry_;
  SurfaceGrid grid_;
};

class HalfSpaceShapeKind : public ShapeKind
{
public:
  BodyShape shape() const override { return BodyShape::half_space; }
  bool is_meshed() const override { return false; }
  const ShapeKind &kind_of_entries() const override { return box_kind(); }

  /// Beside the entries of a box.
  void declare(GeometryOptions &geometry, const Condition &is_chosen, Section &section) const override
  {
    section
        .add("Periodic", geometry.is_periodic, yes_no_codec(),
             "Whether a half-space and its counterface repeat for ever along x and y, with Sizes as the "
             "periods. Motions then count from a rigid plane at the depth of the longer period, because mean "
             "tractions would move a half-space without end.")
        .only_if(is_chosen);
  }
  bool has_layers() const override { return false; }

  void check(const BodyOptions &body) const override
  {
    check_grid(body);
    check_hold(body.geometry);
    if (!body.material.is_uniform_and_isotropic())
      throw InputError(
          (body.material.is_isotropic() ? body.material.section + "/Regions" : body.material.law_entry()) +
          allowed_with(body.geometry) + "one isotropic material, of which its closed forms are");
  }

  std::string chooser_of_mesh() const override { return "Mesh/Cells are the patches of a half-space"; }

  /// The far field has no distance.
  double held_height(const GeometryOptions &) const override
  {
    return std::numeric_limits<double>::infinity();
  }

  bool is_on_base(const GeometryOptions &geometry, const std::array<double, 2> &place) const override
  {
    return box_kind().is_on_base(geometry, place);
  }
  std::string base_in_words(const GeometryOptions &geometry) const override
  {
    return box_kind().base_in_words(geometry);
  }
  std::array<double, 2> half_widths(const GeometryOptions &geometry) const override
  {
    const auto [least, most] = std::minmax(geometry.sizes[0], geometry.sizes[1]);
    return {{most / 2, least / 2}};
  }

  std::string finer_cells(const BodyOptions &body) const override
  {
    return "more " + body.mesh.section + "/Cells, or smaller " + body.geometry.section + "/Sizes";
  }

  std::string describe(const GeometryOptions &geometry) const override
  {
    return (geometry.is_periodic ? "half-space with the periods " : "half-space, which may touch on ") +
           to_text(geometry.sizes[0]) + " x " + to_text(geometry.sizes[1]) + " mm";
  }

  std::unique_ptr<Shape> make(const GeometryOptions &geometry, const MeshOptions &mesh) const override
  {
    return std::make_unique<HalfSpaceShape>(geometry, mesh);
  }

private:
  static std::string allowed_with(const GeometryOptions &geometry)
  {
    return " with " + geometry.shape_entry() + ": allowed is ";
  }

  static void check_grid(const BodyOptions &body)
  {
    const auto &[geometry, mesh, material] = body;
    const std::string with = allowed_with(geometry);
    if (geometry.sizes[2] != 0)
      throw InputError(geometry.section + "/Sizes = " + two_or_three_numbers_codec().print(geometry.sizes) +
                       with + "l_x, l_y, the part of its surface that may touch");
    if (mesh.cells[2] != 0)
      throw InputError(mesh.section + "/Cells = " + two_or_three_counts_codec(1).print(mesh.cells) + with +
                       "n_x, n_y, the patches of that part");
    const SurfaceGrid grid = surface_grid(geometry, mesh);
    if (constexpr Eigen::Index most = 4096; std::max(grid.n_x, grid.n_y) > most)
      throw InputError(mesh.section + "/Refinements = " + std::to_string(mesh.refinements) + with +
                       "a number that leaves at most " + std::to_string(most) + " patches along x and y");
    if (std::min(grid.n_x, grid.n_y) < 2)
      throw InputError(mesh.section + "/Cells = " + two_or_three_counts_codec(1).print(mesh.cells) + with +
                       "at least 2 patches along x and y");
    if (mesh.edge_grading != 1)
      throw InputError(mesh.section + "/Edge grading = " + to_text(mesh.edge_grading) + with +
                       "1, because its grid is regular");
    if (mesh.backend == BodyBackend::multigrid)
      throw InputError(mesh.section + "/Backend = multigrid" + with + "auto, because it has no mesh");
    if (mesh.adaptive != 0)
      throw InputError(mesh.section + "/Adaptive = " + std::to_string(mesh.adaptive) + with +
                       "0, because it has no mesh");
    if (!mesh.refined_cells.empty())
      throw InputError(mesh.section + "/Refined cells is set" + with + "nothing, because it has no mesh");
  }

  static void check_hold(const GeometryOptions &geometry)
  {
    if (geometry.top_face != TopFace::clamped)
      throw InputError(geometry.section + "/Top face = " + to_word(geometry.top_face) +
                       allowed_with(geometry) + "clamped: its far field moves as a rigid body");
    for (const Load &load : geometry.loads)
      if (geometry.has(load) && !load.kind->drives_overlap())
        throw InputError("Load program/Loads: '" + load.text() + "'" + allowed_with(geometry) +
                         "an interference; motions and forces of the far field stand in the legs");
  }
};
} // namespace

const ShapeKind &half_space_kind()
{
  static const HalfSpaceShapeKind kind;
  return kind;
}
} // namespace orthocone
