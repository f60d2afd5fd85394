// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "kinds_of_loads.h"

namespace orthocone
{
namespace
{
/// The share of the overlap of body and counterface that is there: the gap is max(g, 0) + lambda min(g, 0).
/// It strains nothing by itself. Its conjugate is minus the normal forces times min(g, 0).
class Interference : public LoadKind
{
public:
  std::string_view word() const override { return "interference"; }
  std::string_view help() const override
  {
    return "is the share, from 0 to 1, of the overlap where Obstacle/Gap or Obstacle/Distance is negative, "
           "so "
           "that a press fit is assembled step by step, and has no surface";
  }
  const char *unit() const override { return ""; }
  Conjugate conjugate() const override
  {
    return {"Q", "N mm", "derivative of the elastic energy by the share"};
  }
  bool has_surface() const override { return false; }
  bool has_direction() const override { return false; }
  bool drives_overlap() const override { return true; }
};
} // namespace

const LoadKind &interference_load()
{
  static const Interference kind;
  return kind;
}
} // namespace orthocone
