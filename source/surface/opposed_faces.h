// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "cut_face.h"

#include <orthocone/surface/mortar.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// A face of a contact surface and the faces of another one that may lie over it, in one plane.
struct Opposition
{
  std::shared_ptr<const CutFace> own;
  std::vector<std::shared_ptr<const CutFace>> others;
};

/// The faces of two contact surfaces that see each other (docs/theory.md, section 2, "A second elastic body
/// below" and "Curved surfaces of two bodies").
///
/// Along z all of them lie in the plane z = 0. Along the normals each face of the first surface has a plane
/// of its own, normal to it in its middle (M. A. Puso, T. A. Laursen, Comput. Methods Appl. Mech. Engrg. 193,
/// 2004, section 4), and sees faces of the other surface that look towards it: of those that lie one behind
/// the other, as on both sides of a shaft, the nearest ones.
class OpposedFaces
{
public:
  /// Keeps references to both surfaces.
  OpposedFaces(const ContactSurface &surface, const ContactSurface &other, Facing facing);

  /// The number of faces of the first surface.
  std::size_t size() const { return surface_.faces.size(); }

  Opposition at(std::size_t face) const;

private:
  /// The mean plane of a face.
  struct MeanPlane
  {
    Eigen::Vector3d centre;
    Eigen::Matrix3d axes; ///< columns: two in the plane, and the normal into the body
    double radius;        ///< of a ball around the centre that has all nodes, mm
  };
  static MeanPlane mean_plane(const ContactSurface &surface, const std::vector<unsigned int> &face);
  static std::shared_ptr<CutFace> projected(const ContactSurface &surface,
                                            const std::vector<unsigned int> &face, const MeanPlane &plane);
  std::vector<std::size_t> facing(const MeanPlane &plane) const;

  const ContactSurface &surface_, &other_;
  std::vector<MeanPlane> planes_, other_planes_; ///< along normals
  std::vector<std::shared_ptr<const CutFace>> in_plane_, others_in_plane_;
};
} // namespace orthocone
