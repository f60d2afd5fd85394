// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/numbers.h>

namespace orthocone
{
/// How a mesh of two dimensions stands for a body (docs/theory.md, section 2, "Sections"): it is revolved
/// about the axis (r, z), or extruded along y by a thickness (x, z). Displacements are the same all around,
/// or all along y. Those within the section are two. The third one, out of it, is the twist u_theta of a
/// revolved section and u_y of a plane one. It may be left out where nothing drives it.
///
/// In materials that are mirrored about the section, strains of the third component are shears for
/// themselves: the stiffness has two blocks, and only friction couples them.
struct SectionModel
{
  enum class Kind
  {
    revolved,
    plane
  };

  Kind kind = Kind::revolved;
  bool has_third = false; ///< whether the third component is modelled
  double thickness = 1;   ///< of a plane section, mm

  bool is_revolved() const { return kind == Kind::revolved; }
  unsigned int n_components() const { return has_third ? 3 : 2; }

  /// Length (mm) that a point of the section stands for: that of its ring, or the thickness. `x` is the
  /// radius in a revolved section.
  double length_at(const double x) const { return is_revolved() ? 2 * pi * x : thickness; }
};
} // namespace orthocone
