// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Options of an elastic body, of the sections Geometry, Mesh and Material. A second body has the same ones in
// sections of other names, so that each of the option structs knows the name of its own section.
#pragma once

#include <orthocone/body/loads/load.h>
#include <orthocone/body/materials/material_law.h>

#include <algorithm>

namespace orthocone
{
/// How the upper face is held: clamped (it moves as a rigid plate), guided (u_z is prescribed, and it is free
/// sideways) or not at all (free).
enum class TopFace
{
  clamped,
  guided,
  free,
};

template<>
struct Words<TopFace>
{
  static constexpr std::array<std::pair<TopFace, std::string_view>, 3> table{
      {{TopFace::clamped, "clamped"}, {TopFace::guided, "guided"}, {TopFace::free, "free"}}};
};

/// Whether everything depends on x, y and z, or on x and z only (plane strain).
enum class GeometryKind
{
  solid,
  plane_strain,
};

template<>
struct Words<GeometryKind>
{
  static constexpr std::array<std::pair<GeometryKind, std::string_view>, 2> table{
      {{GeometryKind::solid, "solid"}, {GeometryKind::plane_strain, "plane strain"}}};
};

/// The word of a shape of the body, and those that the program itself names. shape_kinds() has all of them.
struct BodyShape
{
  std::string_view word;

  static const BodyShape cylinder, box, file, half_space;

  bool operator==(const BodyShape other) const { return word == other.word; }
  bool operator!=(const BodyShape other) const { return word != other.word; }
};

inline constexpr BodyShape BodyShape::cylinder{"cylinder"};
inline constexpr BodyShape BodyShape::box{"box"};
inline constexpr BodyShape BodyShape::file{"file"};
inline constexpr BodyShape BodyShape::half_space{"half-space"};

/// Part of the body that is modelled; axisymmetric is its section (r, z).
enum class ModelKind
{
  automatic,
  full,
  half,
  quarter,
  axisymmetric,
};

template<>
struct Words<ModelKind>
{
  static constexpr std::array<std::pair<ModelKind, std::string_view>, 5> table{
      {{ModelKind::automatic, "auto"},
       {ModelKind::full, "full"},
       {ModelKind::half, "half"},
       {ModelKind::quarter, "quarter"},
       {ModelKind::axisymmetric, "axisymmetric"}}};
};

/// What chooses the cells of the mesh: the single entries (custom), or one word for all of them.
enum class MeshResolution
{
  custom,
  paper,
  coarse,
  medium,
  fine,
};

template<>
struct Words<MeshResolution>
{
  static constexpr std::array<std::pair<MeshResolution, std::string_view>, 5> table{
      {{MeshResolution::custom, "custom"},
       {MeshResolution::paper, "paper"},
       {MeshResolution::coarse, "coarse"},
       {MeshResolution::medium, "medium"},
       {MeshResolution::fine, "fine"}}};
};

/// How the part of the stiffness that resists changes of volume is integrated: like the rest (full), or with
/// the divergence projected to one degree less (projected). docs/theory.md, section 2, "Projected
/// divergence".
enum class VolumetricQuadrature
{
  automatic, ///< projected for degree 2 and more, where it is stable; full for degree 1
  full,
  projected,
};

template<>
struct Words<VolumetricQuadrature>
{
  /// The last word is an older one for projected.
  static constexpr std::array<std::pair<VolumetricQuadrature, std::string_view>, 4> table{
      {{VolumetricQuadrature::automatic, "auto"},
       {VolumetricQuadrature::full, "full"},
       {VolumetricQuadrature::projected, "projected"},
       {VolumetricQuadrature::projected, "reduced"}}};
};

/// How the elastic body is solved: factorized and condensed to its contact nodes, or by multigrid.
enum class BodyBackend
{
  automatic,
  condensed,
  multigrid,
};

template<>
struct Words<BodyBackend>
{
  static constexpr std::array<std::pair<BodyBackend, std::string_view>, 3> table{
      {{BodyBackend::automatic, "auto"},
       {BodyBackend::condensed, "condensed"},
       {BodyBackend::multigrid, "multigrid"}}};
};

/// A surface that is held at zero in some directions, and does not follow the held face.
struct Support
{
  std::string surface;            ///< its name
  std::array<bool, 3> directions; ///< x, y, z
};

/// What a surface of a mesh file is exactly.
enum class SurfaceKind
{
  plane,
  cylinder,
  sphere,
};

template<>
struct Words<SurfaceKind>
{
  static constexpr std::array<std::pair<SurfaceKind, std::string_view>, 3> table{
      {{SurfaceKind::plane, "plane"}, {SurfaceKind::cylinder, "cylinder"}, {SurfaceKind::sphere, "sphere"}}};
};

/// A surface of a mesh file that is a plane, a cylinder or a sphere.
struct CurvedSurface
{
  std::string surface; ///< its name
  SurfaceKind kind = SurfaceKind::plane;
  std::array<double, 3> centre{};    ///< of a sphere, or a point of the axis of a cylinder, mm
  std::array<double, 3> direction{}; ///< of that axis, of any length

  std::string text() const; ///< as the entry has it
};

/// The entries of section Geometry; lengths in mm.
struct GeometryOptions
{
  double radius = 10;
  double height = 10;
  TopFace top_face = TopFace::clamped;
  BodyShape shape = BodyShape::cylinder;
  std::array<double, 3> sizes{{20, 20, 10}};   ///< of a box, along x, y, z; of a half-space the last is 0
  bool is_periodic = false;                    ///< whether a half-space repeats for ever along x and y
  std::string mesh_file{};                     ///< path, or empty
  std::vector<std::string> contact_surfaces{}; ///< by name; none: the base, of a shape that has one
  // Physical groups of that file, by name or number:
  std::string held_surface{};
  std::vector<std::string> symmetry_surfaces{};
  std::vector<CurvedSurface> curved_surfaces{};
  std::vector<Support> supports{};         ///< of any shape
  std::vector<Load> loads{};               ///< of the load program, on both bodies; no entry of this section
  GeometryKind kind = GeometryKind::solid; ///< of the scene: the lower body has the upper one's
  double thickness = 1;                    ///< of a file in plane strain, mm
  SectionName section = "Geometry";
  bool is_lower = false;  ///< whether this is the second body
  bool faces_down = true; ///< whether the counterface has the normal z; an entry of section Obstacle

  /// Whether the body is computed as its mirror image about z = 0.
  bool is_mirrored() const { return is_lower && faces_down; }

  /// Whether a load acts on this body.
  bool has(const Load &load) const { return load.is_on_lower == is_lower; }

  /// "Geometry/Shape = box".
  std::string shape_entry() const { return section + "/Shape = " + std::string(shape.word); }

  bool is_plane_strain() const { return kind == GeometryKind::plane_strain; }

  /// Whether Contact surface names nothing that this shape has, above a plane: its base touches then.
  bool ignores_contact_surfaces() const;

  /// The names that count; none: the base.
  std::vector<std::string> touching_surfaces() const;

  /// Whether the base alone may touch the counterface; false for a file, whose surfaces may be anywhere.
  bool touches_with_base_only() const;

  /// Whether the surface with this name may touch it. It means nothing for a file.
  bool touches_with(const std::string &surface) const;

  /// The number of a surface that touches it, in the order of their names.
  unsigned int number_of_contact(const std::string &surface) const
  {
    const auto found = std::find(contact_surfaces.begin(), contact_surfaces.end(), surface);
    return found == contact_surfaces.end() ? 0 : static_cast<unsigned int>(found - contact_surfaces.begin());
  }

  std::string contact_names() const; ///< as the entry has them
  std::string contact_entry() const { return section + "/Contact surface = " + contact_names(); }

  bool is_from_file() const { return shape == BodyShape::file; } ///< whether Mesh file and the surfaces count

  /// Thickness (mm) of the body in plane strain, if its shape has one.
  double section_thickness() const;

  /// Distance of the held face from the base, mm; it means nothing for a body from a file.
  double held_height() const;
};

/// Cells of a mesh from `first` to `last`, both included; their numbers are those of the mesh's order.
struct CellRange
{
  unsigned int first, last;
};

/// The words of Mesh/Accuracy of, in the order of Quantities (accuracy/accuracy.h).
constexpr std::array<const char *, 5> accuracy_words{
    {"largest slip", "peak force", "dissipation", "stick area", "loop area"}};
using CountedQuantities = std::array<bool, accuracy_words.size()>;
constexpr CountedQuantities all_quantities{{true, true, true, true, true}};

/// The words of these quantities, "largest slip, dissipation", or "all".
std::string counted_text(const CountedQuantities &counted);

/// The entries of section Mesh: an o-grid disc extruded into layers, or the rows of cells of a box.
struct MeshOptions
{
  ModelKind model = ModelKind::automatic;
  unsigned int core_cells = 8;        ///< cells along a side of the core block
  unsigned int rings = 0;             ///< cells from core to rim; 0: as many as core cells
  unsigned int layers = 4;            ///< cells over the height
  unsigned int degree = 2;            ///< polynomial degree of FE_Q
  unsigned int quadrature_points = 0; ///< Gauss points per direction; 0: degree + 1
  VolumetricQuadrature volumetric_quadrature = VolumetricQuadrature::automatic;
  double core_ratio = 0.5;  ///< core corner radius / R
  double rim_grading = 1;   ///< thickness of a ring / thickness of the next inner ring
  double layer_grading = 1; ///< thickness of a layer / thickness of its neighbour towards mid-height
  MeshResolution resolution = MeshResolution::custom;
  double accuracy = 0; ///< wanted of the counted quantities, percent; 0: the mesh is given
  CountedQuantities accuracy_of = all_quantities;
  std::array<unsigned int, 3> cells{{8, 8, 4}}; ///< of a box, along x, y, z; of a half-space the last is 0
  double edge_grading = 1; ///< of a box: thickness of a cell / thickness of its neighbour towards the middle
  unsigned int refinements = 0; ///< how often every cell is divided into eight, a section's into four
  BodyBackend backend = BodyBackend::automatic;
  unsigned int adaptive = 0; ///< rounds of refinement where the first cycle asks for it
  std::vector<std::vector<CellRange>> refined_cells{}; ///< halved after all refinements, round by round
  unsigned int coarsenings = 0; ///< how often cells that were halved are made larger again; no entry
  SectionName section = "Mesh";

  unsigned int n_rings() const { return rings == 0 ? core_cells : rings; } ///< the default resolved
  /// Full or projected: the default resolved.
  VolumetricQuadrature resolved_volumetric_quadrature() const
  {
    if (volumetric_quadrature != VolumetricQuadrature::automatic)
      return volumetric_quadrature;
    return degree >= 2 ? VolumetricQuadrature::projected : VolumetricQuadrature::full;
  }
  unsigned int n_quadrature_points() const { return quadrature_points == 0 ? degree + 1 : quadrature_points; }
};

/// The isotropic constants of a volume of an imported mesh.
struct MaterialRegion
{
  std::string volume;   ///< name or number of the physical group
  double young_modulus; ///< MPa
  double poisson_ratio;
};

/// A constant of fatigue, for programs that judge the stresses of a run (docs/fatigue.md).
struct FatigueConstant
{
  std::string name;
  double value; ///< MPa, or without a unit
};

/// The entries of section Material: linear elasticity, and what the run keeps for those who judge its
/// stresses.
struct MaterialOptions
{
  double young_modulus = 210000; ///< MPa
  double poisson_ratio = 0.3;
  Choice<MaterialLaw> law{};
  std::vector<MaterialRegion> regions{};
  double thermal_expansion = 0; ///< strain in all directions per kelvin, 1/K
  std::vector<FatigueConstant> fatigue{};
  SectionName section = "Material";

  bool is_isotropic() const { return !law.chosen().tangent(); }
  bool is_uniform_and_isotropic() const { return is_isotropic() && regions.empty(); }

  /// "Material/Law = orthotropic".
  std::string law_entry() const { return section + "/Law = " + law.word(); }

  /// The constants themselves, or, for any other law, those of its average over all directions, which are the
  /// same where its constants are isotropic.
  MaterialOptions isotropic() const;

  std::string regions_text() const; ///< of the entry Regions
};

/// An elastic body.
struct BodyOptions
{
  GeometryOptions geometry{};
  MeshOptions mesh{};
  MaterialOptions material{};

  /// A body in the sections "Lower geometry", "Lower mesh" and "Lower material".
  static BodyOptions lower();
};

/// Adds the entries of Geometry, but Top face and Kind, which is that of the scene.
void declare_shape(GeometryOptions &geometry, Section &section);
void declare_top_face(GeometryOptions &geometry, Section &section);
void declare_kind(GeometryOptions &geometry, Section &section);
void declare_supports(GeometryOptions &geometry, Section &section);

/// Adds the entries that choose a mesh as a whole.
void declare_mesh_choice(MeshOptions &mesh, Section &section);

/// Adds the entries of the cells. `geometry` has the shape whose cells they are; it must outlive the section.
void declare_cells(MeshOptions &mesh, const GeometryOptions &geometry, Section &section);

/// Adds the entries of single cells that are halved, and of how the body is solved. `geometry` as above.
void declare_backend(MeshOptions &mesh, const GeometryOptions &geometry, Section &section);

void declare_material(MaterialOptions &material, Section &section);

/// Throws InputError where the entries of a body contradict each other, and FileError for a mesh file that
/// cannot be read.
void check_body(const BodyOptions &body);

/// Throws InputError where the mesh is chosen by several entries, or by one that the shape does not know.
void check_mesh_choice(const BodyOptions &body);

/// Throws InputError unless the constants store energy under every strain, and the regions exist.
void check_material(const BodyOptions &body);

/// Adds a warning where full volumetric quadrature locks.
void warn_of_locking(const BodyOptions &body, std::vector<std::string> &warnings);
} // namespace orthocone
