// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/obstacle.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
namespace
{
/// The surface of Gap and Gap file itself.
class RigidKind : public ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override { return std::make_unique<RigidKind>(); }
  bool keeps_surface() const override { return true; }
  std::unique_ptr<const Obstacle> make(const ObstacleOptions &,
                                       std::unique_ptr<const Obstacle> surface) const override
  {
    return surface;
  }
};
} // namespace

Kind<ObstacleKindOptions> rigid_obstacle()
{
  return {std::string(ObstacleKind::rigid.word), "a rigid surface",
          [] { return std::make_unique<RigidKind>(); }};
}
} // namespace orthocone
