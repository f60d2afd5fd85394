// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/obstacle.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/expression.h>
#include <orthocone/scene/gap_file.h>
#include <orthocone/surface/half_plane.h>

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
                       ": allowed is a grid that holds the " + "whole contact surface, also " +
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

namespace
{
/// An elastic half-space below the surface of another obstacle.
class ElasticHalfSpace : public Obstacle
{
public:
  ElasticHalfSpace(std::unique_ptr<const Obstacle> surface, const MaterialOptions &material)
      : surface_(std::move(surface)),
        material_(material)
  {
  }

  bool is_plane() const override { return surface_->is_plane(); }
  double gap(const Vector2d &place) const override { return surface_->gap(place); }
  void check(const std::vector<Vector2d> &places) const override { surface_->check(places); }
  std::optional<MaterialOptions> material() const override { return material_; }
  Eigen::MatrixXd compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                             const LocalAxes &axes) const override
  {
    const HalfSpace half_space{material_.young_modulus, material_.poisson_ratio};
    return symmetry.is_plane_strain() ? half_plane_compliance(half_space, surface, symmetry, axes)
                                      : half_space_compliance(half_space, surface, symmetry, axes);
  }

private:
  std::unique_ptr<const Obstacle> surface_;
  MaterialOptions material_;
};

/// A kind without entries of its own.
template<typename Derived>
class PlainKind : public ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override { return std::make_unique<Derived>(); }
  bool keeps_surface() const override { return true; }
  std::unique_ptr<const Obstacle> make(const ObstacleOptions &,
                                       std::unique_ptr<const Obstacle> surface) const override
  {
    return surface;
  }
};

class RigidKind : public PlainKind<RigidKind>
{
};

class HalfSpaceKind : public PlainKind<HalfSpaceKind>
{
public:
  bool gives_way() const override { return true; }
  std::unique_ptr<const Obstacle> make(const ObstacleOptions &options,
                                       std::unique_ptr<const Obstacle> surface) const override
  {
    return std::make_unique<ElasticHalfSpace>(std::move(surface), options.material);
  }
};

/// The scene makes the second body, which is no obstacle but a body like the first one.
class BodyKind : public PlainKind<BodyKind>
{
public:
  bool gives_way() const override { return true; }
};

template<typename Options>
Kind<ObstacleKindOptions> obstacle_kind(const ObstacleKind &kind, const char *const help)
{
  return {std::string(kind.word), help, [] { return std::make_unique<Options>(); }};
}
} // namespace

template<>
std::vector<Kind<ObstacleKindOptions>> &kinds_of<ObstacleKindOptions>()
{
  static std::vector<Kind<ObstacleKindOptions>> kinds{
      obstacle_kind<RigidKind>(ObstacleKind::rigid, "what does not give way"),
      obstacle_kind<HalfSpaceKind>(ObstacleKind::half_space, "an elastic half-space, which needs no mesh"),
      obstacle_kind<BodyKind>(ObstacleKind::body,
                              "a second elastic body, that of the sections Lower geometry, Lower mesh and "
                              "Lower material (neither elastic one in the axisymmetric model, nor with "
                              "Mesh/Backend = multigrid)")};
  return kinds;
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
