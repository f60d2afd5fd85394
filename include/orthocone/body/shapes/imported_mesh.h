// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/body/shapes/gmsh_file.h>
#include <orthocone/body/shapes/surface_places.h>
#include <orthocone/surface/model_symmetry.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace orthocone
{
template<int dim>
struct CoarseCurves;

/// The file of a geometry: its hexahedra, or in plane strain its quadrangles, extruded. Throws as
/// read_gmsh_file() does.
GmshFile read_mesh_file(const GeometryOptions &geometry);

/// The checked mesh of a file (mm): one piece of hexahedra that are not inverted, on or above the plane z =
/// 0, whose edges are curved as those of its elements of second order, with surfaces for contact, hold and
/// symmetry (docs/theory.md, section 2, "Bodies from files"), which are physical groups or planes. Boundary
/// and material ids are the numbers of the first physical groups, 0 for none. Nodes that rounding has left
/// beside their plane are moved into it.
class ImportedMesh
{
public:
  /// Throws InputError, which names the path of the file or the entry and what is allowed, and FileError if
  /// the file cannot be read.
  explicit ImportedMesh(const GeometryOptions &geometry);
  ~ImportedMesh();
  ImportedMesh(const ImportedMesh &) = delete;
  ImportedMesh &operator=(const ImportedMesh &) = delete;

  const dealii::Triangulation<3> &triangulation() const { return triangulation_; }
  const SymmetryPlanes &planes() const { return planes_; }

  /// The same cells with the boundary ids of boundary.h.
  void copy_to(dealii::Triangulation<3> &triangulation) const;

  /// The quadrangles of plane strain with these boundary ids. Throws InputError where no line is held.
  void copy_to(dealii::Triangulation<2> &section) const;

  /// Describes volumes, surfaces with areas, worst cell and height of the contact surface, in a line each.
  std::string describe() const;

  /// Warnings of a suspicious mesh, in a sentence each.
  std::vector<std::string> warnings(const MeshOptions &mesh) const;

private:
  using Face = dealii::Triangulation<3>::active_face_iterator;

  void measure_box();
  void follow_curves();
  void find_planes();
  void align();
  void check_cells();
  void check_surfaces() const;
  void check_outside(const std::string &entry, const std::string &surface, FaultList &faults) const;
  void check_marked(FaultList &faults) const;
  void check_contact(FaultList &faults) const;
  enum class Among
  {
    all,
    contact
  };
  bool has_facets(Among surfaces) const;
  std::string where_volumes_count() const;
  double quality_of(const dealii::Triangulation<3>::cell_iterator &cell) const;
  std::vector<dealii::Point<3>> nodes_of(const Face &face) const; ///< corners, then the middles if any
  dealii::types::boundary_id id_of(const Face &face) const;
  std::vector<Face> faces_of(const std::string &surface) const;
  double tolerance_of(const std::string &surface) const;

  GeometryOptions geometry_;
  GmshFile file_;
  const MeshBox box_;
  dealii::Triangulation<3> triangulation_;
  std::unique_ptr<CoarseCurves<3>> curves_; ///< without middles for elements of first order
  std::map<unsigned int, std::vector<Face>> faces_of_group_;
  std::vector<Face> contact_, held_;        ///< sorted
  std::vector<std::vector<Face>> touching_; ///< the same of each contact surface
  std::vector<std::vector<Face>> marked_;   ///< the same of each of marked_surfaces()
  SymmetryPlanes planes_;
  dealii::Point<3> lowest_, highest_; ///< of the box around, mm
  double extent_ = 0;                 ///< longest side of that box, mm
  double worst_quality_ = 1;          ///< scaled Jacobian, of the worst cell
  dealii::Point<3> worst_place_;
};
} // namespace orthocone
