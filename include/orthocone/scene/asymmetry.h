// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <array>
#include <string>

namespace orthocone
{
/// Why the scene is not symmetric: for each symmetry a sentence of the first part of the scene that breaks
/// it; empty where all parts (shape, material, friction, obstacle, load) are symmetric.
struct Asymmetry
{
  std::array<std::string, 2> about_planes; ///< x = 0, y = 0
  std::string about_axis;                  ///< why the body is not a revolved section
  std::string along_y{};                   ///< why it is none in plane strain
  /// Why the section that the scene may have, revolved or in plane strain, needs its third component.
  std::string about_section{};
  SymmetryPlanes of_file{};       ///< where a mesh file ends
  SymmetryPlanes of_lower_file{}; ///< where the lower body's file ends

  bool has_plane(const unsigned int direction) const { return about_planes[direction].empty(); }
  bool can_be_revolved() const { return about_axis.empty(); }
  bool needs_third() const { return !about_section.empty(); }

  /// The planes that the scene is symmetric about.
  SymmetryPlanes planes() const { return {has_plane(0), has_plane(1)}; }

  /// Why planes are missing.
  std::string of_planes() const;
};

/// Asks every part of the scene. Gap and friction are compared at the contact nodes and at their images.
/// Throws InputError where they are not defined, or where a force presses before there is contact, and
/// FileError for the gap file.
Asymmetry asymmetry_of(const Parameters &parameters);
} // namespace orthocone
