// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/section_model.h>

#include <Eigen/Dense>

#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// Planes of symmetry through the axis of the body, of which only one side is modelled: x >= 0 and y >= 0.
struct SymmetryPlanes
{
  bool normal_to_x = false; ///< the plane x = 0
  bool normal_to_y = false; ///< the plane y = 0

  /// Number of copies of the model that make the whole body.
  unsigned int n_copies() const { return (normal_to_x ? 2 : 1) * (normal_to_y ? 2 : 1); }

  /// "full", "half" or "quarter".
  std::string name() const;
};

/// The contact surface of the whole body: faces whose nodes are images of nodes of the model.
struct WholeSurface
{
  struct Node
  {
    unsigned int node;  ///< place of the model
    unsigned int image; ///< index in `images`
  };

  std::vector<Eigen::Matrix2d> images; ///< orthogonal maps (2 x 2) of the plane, from the model to its images
  std::vector<double> shifts{};        ///< of the images along y, mm; none: all 0
  std::vector<Node> nodes;             ///< no two at one place
  std::vector<std::vector<unsigned int>>
      faces; ///< (degree + 1)^2 `nodes` a face, lexicographic, anticlockwise

  /// Where a node is whose place of the model is at `position`, mm.
  Eigen::Vector2d place(const Node &node, const std::array<double, 2> &position) const
  {
    const Eigen::Vector2d shift(0, shifts.empty() ? 0 : shifts[node.image]);
    return images[node.image] * Eigen::Vector2d(position[0], position[1]) + shift;
  }
};

/// How the model makes the whole body: by copies mirrored about planes of symmetry, by revolution, or by
/// extrusion along y. An extruded section may be mirrored about x = 0, too.
class ModelSymmetry
{
public:
  // Not explicit: planes are a symmetry.
  ModelSymmetry(const SymmetryPlanes &planes = {})
      : planes_(planes)
  {
  }

  /// The symmetry of a section (r, z) that is revolved about the axis. Without the twist it is mirrored, too:
  /// nothing moves around the axis.
  static ModelSymmetry of_revolution(bool with_twist = false);

  /// The symmetry of a section (x, z) of this thickness (mm) in plane strain. Without u_y (`has_third`) it is
  /// mirrored about y = 0, too.
  static ModelSymmetry of_plane_strain(double thickness, bool has_third, bool is_mirrored_about_x = false);

  /// The section, or nothing for a solid.
  const std::optional<SectionModel> &section() const { return section_; }
  bool is_section() const { return section_.has_value(); }
  bool is_axisymmetric() const { return section_ && section_->is_revolved(); }
  bool is_plane_strain() const { return section_ && !section_->is_revolved(); }
  bool has_third() const { return section_ && section_->has_third; }
  const SymmetryPlanes &planes() const { return planes_; }

  /// "full", "half", "quarter" or "axisymmetric"; of plane strain "full" or "half".
  std::string name() const { return is_axisymmetric() ? "axisymmetric" : planes_.name(); }

  /// The same with what the word does not say: "axisymmetric with twist", "plane strain, half, with u_y".
  std::string full_name() const;

  /// Number of copies of the model that make the whole body; 1 for a revolved section, whose forces are those
  /// of whole rings.
  unsigned int n_copies() const { return planes_.n_copies(); }

  /// Whether a symmetric body can have this component (0 to 5) of a rigid motion.
  bool leaves(unsigned int component) const;

  /// Whether the wrench on the held face of the whole body may have this component: what it works on, and in
  /// plane strain the moments of forces along y, whose motions the section does not have.
  bool carries(unsigned int component) const;

  /// Number of nodes of the whole surface that a node of the model stands for.
  unsigned int n_images(const ContactSurface &surface, const ContactNode &node) const;

  /// Forces of the model's nodes relative to the forces of single nodes of the whole surface, one number a
  /// contact node: a node on a plane of symmetry carries only its part of the force in the model, a ring
  /// carries the forces of all its images.
  Eigen::VectorXd force_shares(const ContactSurface &surface) const;

  /// How many contact nodes this one is in counts that users see: nodes of the whole body, one ring, or the
  /// lines across a strip.
  unsigned int n_counted(const ContactSurface &surface, const ContactNode &node) const
  {
    return is_axisymmetric() ? 1 : n_images(surface, node) / n_across(surface);
  }

  /// The map (2 x 2) from the model to a place (x, y) of the whole surface, mm.
  Eigen::Matrix2d map_to(const Eigen::Vector2d &position) const;

  /// The contact surface of the whole body; a revolved section is drawn with 32 sectors, a plane one as a
  /// strip with one face across it, about y = 0.
  WholeSurface whole(const ContactSurface &surface) const;

private:
  /// Nodes across the strip that a place of a plane section stands for; 1 otherwise.
  unsigned int n_across(const ContactSurface &surface) const
  {
    return is_plane_strain() ? surface.degree + 1 : 1;
  }
  WholeSurface mirrored(const ContactSurface &surface) const;
  WholeSurface extruded(const ContactSurface &surface) const;

  SymmetryPlanes planes_;
  std::optional<SectionModel> section_;
};
} // namespace orthocone
