// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/half_space_obstacle.h>

#include <orthocone/scene/obstacle.h>
#include <orthocone/surface/half_plane.h>
#include <orthocone/surface/hierarchical_half_space.h>

#include <utility>

namespace orthocone
{
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
  double gap(const SurfacePoint &point) const override { return surface_->gap(point); }
  void check(const std::vector<SurfacePoint> &points) const override { surface_->check(points); }
  std::optional<MaterialOptions> material() const override { return material_; }
  Eigen::MatrixXd compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                             const LocalAxes &axes) const override
  {
    return symmetry.is_plane_strain() ? half_plane_compliance(half_space(), surface, symmetry, axes)
                                      : half_space_compliance(half_space(), surface, symmetry, axes);
  }
  std::unique_ptr<const Compliance> compliance_by_products(const ContactSurface &surface,
                                                           const ModelSymmetry &symmetry,
                                                           const LocalAxes &axes) const override
  {
    return std::make_unique<HierarchicalHalfSpace>(half_space(), surface, symmetry, axes);
  }

private:
  HalfSpace half_space() const { return {material_.young_modulus, material_.poisson_ratio}; }

  std::unique_ptr<const Obstacle> surface_;
  MaterialOptions material_;
};
} // namespace

void HalfSpaceKind::declare(Section &section, const Condition &is_chosen)
{
  const std::string of_half_space = " of the half-space of Kind = half-space.";
  section
      .add("Young modulus", half_space.young_modulus, number_codec(positive),
           "Young's modulus in MPa" + of_half_space)
      .unit("MPa")
      .only_if(is_chosen);
  section
      .add("Poisson ratio", half_space.poisson_ratio, number_codec(NumberRange{-1, 0.5}),
           "Poisson's ratio" + of_half_space)
      .only_if(is_chosen);
}

std::unique_ptr<const Obstacle> HalfSpaceKind::make(const ObstacleOptions &,
                                                    std::unique_ptr<const Obstacle> surface) const
{
  return std::make_unique<ElasticHalfSpace>(std::move(surface), half_space);
}

Kind<ObstacleKindOptions> half_space_obstacle()
{
  return {std::string(ObstacleKind::half_space.word), "an elastic half-space, which needs no mesh",
          [] { return std::make_unique<HalfSpaceKind>(); }};
}
} // namespace orthocone
