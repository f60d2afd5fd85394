// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "kinds_of_loads.h"

namespace orthocone
{
namespace
{
/// t = value times the direction, on any surface; across a bar it is the bulk stress.
class Traction : public LoadKind
{
public:
  std::string_view word() const override { return "traction"; }
  std::string_view help() const override { return "pulls along its direction, MPa"; }
  const char *unit() const override { return "MPa"; }
  Conjugate conjugate() const override
  {
    return {"u", "mm", "mean displacement of its surface along its direction"};
  }
  Eigen::Vector3d traction(const Eigen::Vector3d &, const Eigen::Vector3d &direction) const override
  {
    return direction;
  }
};
} // namespace

const LoadKind &traction_load()
{
  static const Traction kind;
  return kind;
}
} // namespace orthocone
