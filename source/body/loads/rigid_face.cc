// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A second rigid face: all of a surface has one displacement along an axis, and is free along the others
// unless supports hold it there. Either the displacement is given, or the force that causes it.
#include "kinds_of_loads.h"

namespace orthocone
{
namespace
{
class MotionOfSurface : public LoadKind
{
public:
  std::string_view word() const override { return "motion"; }
  std::string_view help() const override
  {
    return "moves the surface as a rigid face along x, y or z, mm, and leaves the other directions free";
  }
  const char *unit() const override { return "mm"; }
  Conjugate conjugate() const override { return {"F", "N", "force on its surface along its direction"}; }
  bool moves_surface() const override { return true; }
};

class ForceOnSurface : public LoadKind
{
public:
  std::string_view word() const override { return "force"; }
  std::string_view help() const override
  {
    return "does the same by a force on the surface, N, and finds the motion";
  }
  const char *unit() const override { return "N"; }
  Conjugate conjugate() const override
  {
    return {"u", "mm", "displacement of its surface along its direction"};
  }
  bool moves_surface() const override { return true; }
  bool is_force_of_surface() const override { return true; }
};
} // namespace

const LoadKind &motion_load()
{
  static const MotionOfSurface kind;
  return kind;
}

const LoadKind &force_load()
{
  static const ForceOnSurface kind;
  return kind;
}
} // namespace orthocone
