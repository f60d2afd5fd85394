// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A program with an obstacle of its own: a cone whose tip is below the centre of the body, as Obstacle/Gap =
// slope*sqrt(x^2+y^2) would have it.
#include <orthocone/app/program.h>
#include <orthocone/scene/obstacle.h>
#include <orthocone/scene/options.h>

#include <cmath>

namespace
{
class Cone : public orthocone::Obstacle
{
public:
  explicit Cone(const double slope)
      : slope_(slope)
  {
  }

  double gap(const orthocone::SurfacePoint &point) const override
  {
    return slope_ * std::hypot(point.place[0], point.place[1]) + point.place[2];
  }
  void check(const std::vector<orthocone::SurfacePoint> &) const override {} // there is a gap everywhere

private:
  double slope_;
};

class ConeOptions : public orthocone::ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override { return std::make_unique<ConeOptions>(*this); }

  void declare(orthocone::Section &section, const orthocone::Condition &is_chosen) override
  {
    section.add("Slope", slope_, orthocone::number_codec(orthocone::positive), "Depth per mm from the tip.")
        .only_if(is_chosen);
  }

  std::unique_ptr<const orthocone::Obstacle> make(const orthocone::ObstacleOptions &,
                                                  std::unique_ptr<const orthocone::Obstacle>) const override
  {
    return std::make_unique<Cone>(slope_);
  }

private:
  double slope_ = 0.01;
};
} // namespace

int main(const int argc, const char *const *const argv)
{
  orthocone::kinds_of<orthocone::ObstacleKindOptions>().push_back(
      {"cone", "a cone with its tip at x = y = 0", [] { return std::make_unique<ConeOptions>(); }});
  orthocone::run_program(argc, argv);
}
