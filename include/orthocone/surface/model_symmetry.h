// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>

#include <Eigen/Dense>

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
  std::vector<Node> nodes;             ///< no two at one place
  std::vector<std::vector<unsigned int>>
      faces; ///< (degree + 1)^2 `nodes` a face, lexicographic, anticlockwise
};

/// How the model makes the whole body: by copies mirrored about planes of symmetry, or by revolution.
class ModelSymmetry
{
public:
  // Not explicit: planes are a symmetry.
  ModelSymmetry(const SymmetryPlanes &planes = {})
      : planes_(planes)
  {
  }

  /// The symmetry of a section (r, z) that is revolved about the axis.
  static ModelSymmetry of_revolution();

  bool is_axisymmetric() const { return is_axisymmetric_; }
  const SymmetryPlanes &planes() const { return planes_; }

  /// "full", "half", "quarter" or "axisymmetric".
  std::string name() const { return is_axisymmetric_ ? "axisymmetric" : planes_.name(); }

  /// Number of copies of the model that make the whole body; 1 for a section, whose forces are those of whole
  /// rings.
  unsigned int n_copies() const { return planes_.n_copies(); }

  /// Whether a symmetric body can have this component (0 to 5) of a rigid motion, or of its wrench.
  bool leaves(unsigned int component) const;

  /// Number of nodes of the whole surface that a node of the model stands for.
  unsigned int n_images(const ContactSurface &surface, const ContactNode &node) const;

  /// Forces of the model's nodes relative to the forces of single nodes of the whole surface, one number a
  /// contact node: a node on a plane of symmetry carries only its part of the force in the model, a ring
  /// carries the forces of all its images.
  Eigen::VectorXd force_shares(const ContactSurface &surface) const;

  /// How many contact nodes this one is in counts that users see: nodes of the whole body, or one ring.
  unsigned int n_counted(const ContactSurface &surface, const ContactNode &node) const
  {
    return is_axisymmetric_ ? 1 : n_images(surface, node);
  }

  /// The map (2 x 2) from the model to a place (x, y) of the whole surface, mm.
  Eigen::Matrix2d map_to(const Eigen::Vector2d &position) const;

  /// The contact surface of the whole body; a section is drawn with 32 sectors.
  WholeSurface whole(const ContactSurface &surface) const;

private:
  WholeSurface mirrored(const ContactSurface &surface) const;

  SymmetryPlanes planes_;
  bool is_axisymmetric_ = false;
};
} // namespace orthocone
