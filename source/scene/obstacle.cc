// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/obstacle.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/expression.h>
#include <orthocone/scene/gap_file.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
class Plane : public Obstacle
{
public:
  bool is_plane() const override { return true; }
  double gap(const Vector2d &) const override { return 0; }
  void check(const std::vector<Vector2d> &) const override {}
};

/// The sum of an expression and a measured surface.
class GivenGap : public Obstacle
{
public:
  explicit GivenGap(const ObstacleOptions &options)
      : expression_(options.gap),
        file_name_(options.gap_file)
  {
    if (!file_name_.empty())
      grid_ = read_gap_file(file_name_);
  }

  double gap(const Vector2d &place) const override
  {
    return expression_.value(place[0], place[1]) + (grid_ ? grid_->value(place[0], place[1]) : 0);
  }
  void check(const std::vector<Vector2d> &places) const override;

private:
  Expression expression_;
  std::string file_name_;
  std::optional<GapGrid> grid_;
};

void GivenGap::check(const std::vector<Vector2d> &places) const
{
  for (const Vector2d &place : places)
  {
    if (const double gap = expression_.value(place[0], place[1]); !std::isfinite(gap))
      throw InputError("Obstacle/Gap = " + expression_.text() + " is " + value_text(gap) + " at " +
                       place_text(place) + " of the contact surface: allowed is a finite number (mm)");
    if (grid_ && !grid_->contains(place[0], place[1]))
      throw InputError("Obstacle/Gap file = " + shown_path(file_name_) +
                       ": allowed is a grid that covers the " + "whole contact surface, also " +
                       place_text(place) + "; this one reaches from " +
                       place_text({grid_->first_x, grid_->first_y}) + " to " +
                       place_text({grid_->first_x + grid_->spacing_x * static_cast<double>(grid_->n_x - 1),
                                   grid_->first_y + grid_->spacing_y * static_cast<double>(grid_->n_y - 1)}));
  }
}
} // namespace

Eigen::MatrixXd Obstacle::compliance(const ContactSurface &, const ModelSymmetry &, const LocalAxes &) const
{
  return {};
}

std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options)
{
  std::unique_ptr<const Obstacle> surface;
  if (options.is_plane())
    surface = std::make_unique<Plane>();
  else
    surface = std::make_unique<GivenGap>(options);
  return options.kind.chosen().make(options, std::move(surface));
}

NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface)
{
  NodeVector gaps = NodeVector::Zero(3 * static_cast<Eigen::Index>(surface.nodes.size()));
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
  {
    const ContactNode &node = surface.nodes[i];
    gaps[3 * static_cast<Eigen::Index>(i)] = obstacle.gap({node.position[0], node.position[1]}) + node.height;
  }
  return gaps;
}

namespace
{
std::string difference_text(const Obstacle &obstacle, const Vector2d &place, const Vector2d &image)
{
  std::ostringstream text;
  text << std::setprecision(4) << "Obstacle/Gap is " << obstacle.gap(place) << " mm at " << place_text(place)
       << " and " << obstacle.gap(image) << " mm at " << place_text(image);
  return text.str();
}
} // namespace

std::string Obstacle::asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const
{
  constexpr double rounding = 1e-9;
  if (symmetry.is_axisymmetric() && material())
    return "Obstacle/Kind = half-space has no section (r, z)";
  if (is_plane())
    return {};
  double largest = 0;
  for (const Vector2d &place : sample.of(symmetry))
    largest = std::max(largest, std::abs(gap(place)));
  for (const Eigen::Affine2d &map : symmetry_maps(symmetry))
    for (const Vector2d &place : sample.of(symmetry))
      if (const Vector2d image = map * place; !(std::abs(gap(image) - gap(place)) <= rounding * largest))
        return difference_text(*this, place, image);
  return {};
}
} // namespace orthocone
