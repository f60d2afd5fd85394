// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// An elastic half-space below the surface of Gap and Gap file (docs/theory.md, section 2).
class HalfSpaceKind : public ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override
  {
    return std::make_unique<HalfSpaceKind>(*this);
  }
  void declare(Section &section, const Condition &is_chosen) override;
  std::optional<MaterialOptions> material() const override { return half_space; }
  bool keeps_surface() const override { return true; }
  std::unique_ptr<const Obstacle> make(const ObstacleOptions &options,
                                       std::unique_ptr<const Obstacle> surface) const override;

  MaterialOptions half_space{};
};
} // namespace orthocone
