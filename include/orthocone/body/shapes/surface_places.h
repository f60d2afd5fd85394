// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Surfaces of a mesh by their place: the words "x min", "z max" and "x = 0".
#pragma once

#include <orthocone/body/shapes/gmsh_file.h>

#include <array>
#include <optional>
#include <string>

namespace orthocone
{
/// A plane normal to an axis (0: x, 1: y, 2: z), and where it is, mm.
struct PlaneOfAxis
{
  unsigned int axis;
  double at;
};

/// The box around the cells of a mesh, mm.
class MeshBox
{
public:
  explicit MeshBox(const GmshFile &file);

  /// The plane that "x min", "z max" or "y = 1.5" names; nothing for any other text.
  std::optional<PlaneOfAxis> find(const std::string &place) const;

  /// How far nodes may be off a plane in which they lie: a millionth of the longest side, which is more than
  /// single precision loses.
  double tolerance() const { return share * extent_; }

  bool are_same(const PlaneOfAxis &a, const PlaneOfAxis &b) const;

private:
  static constexpr double share = 1e-6;

  std::array<double, 3> lowest_{}, highest_{};
  double extent_ = 0;
};

/// Number of the faces on the outside of the cells that lie in a plane with all of their nodes.
std::size_t n_faces_in(const GmshFile &file, const MeshBox &box, const PlaneOfAxis &plane);

/// "x min (0), x max (4), z min (-1)": the sides of the box in which faces lie, and where; may be empty.
std::string list_places(const GmshFile &file, const MeshBox &box);
} // namespace orthocone
