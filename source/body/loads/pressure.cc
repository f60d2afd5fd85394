// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "kinds_of_loads.h"

namespace orthocone
{
namespace
{
/// t = -p n.
class Pressure : public LoadKind
{
public:
  std::string_view word() const override { return "pressure"; }
  std::string_view help() const override { return "presses into the body, MPa"; }
  const char *unit() const override { return "MPa"; }
  Conjugate conjugate() const override
  {
    return {"u", "mm", "mean displacement of its surface into the body"};
  }
  bool has_direction() const override { return false; }
  Eigen::Vector3d traction(const Eigen::Vector3d &normal, const Eigen::Vector3d &) const override
  {
    return -normal;
  }
};
} // namespace

const LoadKind &pressure_load()
{
  static const Pressure kind;
  return kind;
}
} // namespace orthocone
