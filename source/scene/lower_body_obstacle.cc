// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/obstacle.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
namespace
{
/// The scene makes the second body, which is no obstacle but a body like the first one.
class LowerBodyKind : public ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override { return std::make_unique<LowerBodyKind>(); }
  bool keeps_surface() const override { return true; }
  bool is_body() const override { return true; }
  std::unique_ptr<const Obstacle> make(const ObstacleOptions &,
                                       std::unique_ptr<const Obstacle> surface) const override
  {
    return surface;
  }
};
} // namespace

Kind<ObstacleKindOptions> lower_body_obstacle()
{
  return {std::string(ObstacleKind::body.word),
          "a second elastic body, which the sections Lower geometry, Lower mesh and Lower material describe",
          [] { return std::make_unique<LowerBodyKind>(); }};
}
} // namespace orthocone
