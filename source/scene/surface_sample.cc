// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/surface_sample.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/body.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/mesh_ladder.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/contact_mesh.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
/// A mesh with the same contact surface, and the smallest body above it where that is the base.
MeshOptions flat_mesh(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  constexpr unsigned int most_of_solids = 3;
  const bool is_axisymmetric = symmetry.is_axisymmetric();
  MeshOptions mesh = parameters.mesh.accuracy != 0
                         ? ladder_mesh(parameters, is_axisymmetric, n_ladder_levels(is_axisymmetric) - 1)
                         : resolved_mesh(parameters, is_axisymmetric);
  if (parameters.geometry.touches_with_base_only())
    mesh.layers = mesh.cells[2] = 1;
  mesh.refined_cells.clear(); // numbers of other cells
  mesh.degree = symmetry.is_section() ? mesh.degree : std::min(mesh.degree, most_of_solids);
  return mesh;
}

/// The nodes of the part of the body in the file, and their mirror images.
SurfaceSample sample_of_file(const Parameters &parameters)
{
  const SymmetryPlanes planes = ImportedMesh(parameters.geometry).planes();
  const ModelSymmetry symmetry = parameters.geometry.is_plane_strain()
                                     ? plane_strain(parameters, false, planes.normal_to_x)
                                     : ModelSymmetry(planes);
  const Body body(parameters, symmetry);
  SurfaceSample sample;
  for (const double x : {1., -1.})
    for (const double y : {1., -1.})
      if ((x > 0 || planes.normal_to_x) && (y > 0 || planes.normal_to_y))
        for (const SurfacePoint &point : points_of(body.unknowns().contact_surface()))
          sample.points.push_back(point.mapped(Eigen::Affine2d(Eigen::Scaling(x, y))));
  sample.held_centre = body.unknowns().held_centre();
  return sample;
}

std::vector<SurfacePoint> contact_points(const Parameters &given, const ModelSymmetry &symmetry)
{
  Parameters parameters = given;
  parameters.mesh = flat_mesh(given, symmetry);
  parameters.geometry.top_face = TopFace::clamped;
  return points_of(Body(parameters, symmetry).unknowns().contact_surface());
}
} // namespace

ModelSymmetry plane_strain(const Parameters &parameters, const bool has_third, const bool is_mirrored_about_x)
{
  return ModelSymmetry::of_plane_strain(parameters.geometry.section_thickness(), has_third,
                                        is_mirrored_about_x);
}

std::vector<SurfacePoint> points_of(const ContactSurface &surface)
{
  std::vector<SurfacePoint> points;
  for (const ContactNode &node : surface.nodes)
    points.push_back({node.place(), node.inward});
  return points;
}

SurfaceSample surface_sample(const Parameters &parameters)
{
  if (parameters.geometry.is_from_file())
    return sample_of_file(parameters);
  const ModelSymmetry whole =
      parameters.geometry.is_plane_strain() ? plane_strain(parameters, false) : ModelSymmetry();
  SurfaceSample sample{contact_points(parameters, whole), {}};
  if (kind_of(parameters.geometry).is_meshed())
    sample.held_centre[2] = parameters.geometry.held_height();
  const auto shape = make_shape(parameters.geometry, parameters.mesh);
  if (const auto section = ModelSymmetry::of_revolution(); shape->asymmetry(section).empty())
    sample.rings = contact_points(parameters, section);
  return sample;
}

namespace
{
/// Of a section, without mirrors: turns by golden angles or shifts by golden parts of the thickness, under
/// which no number of waves repeats (docs/theory.md, section 3, "Gaps and friction that varies").
std::vector<Eigen::Affine2d> maps_of(const SectionModel &section)
{
  constexpr int n_maps = 16;
  const double golden = (3 - std::sqrt(5)) / 2;
  std::vector<Eigen::Affine2d> maps;
  for (int i = 1; i <= n_maps; ++i)
    if (section.is_revolved())
      maps.emplace_back(Eigen::Rotation2Dd(i * golden * 2 * pi));
    else
      maps.emplace_back(
          Eigen::Translation2d(0, section.thickness * (i * golden - std::floor(i * golden) - 0.5)));
  return maps;
}
} // namespace

std::vector<Eigen::Affine2d> symmetry_maps(const ModelSymmetry &symmetry)
{
  Eigen::Affine2d mirror_x = Eigen::Affine2d::Identity(), mirror_y = mirror_x;
  mirror_x.linear()(0, 0) = -1;
  mirror_y.linear()(1, 1) = -1;
  std::vector<Eigen::Affine2d> maps;
  if (symmetry.planes().normal_to_x)
    maps.push_back(mirror_x);
  if (symmetry.planes().normal_to_y)
    maps.push_back(mirror_y);
  if (!symmetry.is_section())
    return maps;
  for (const Eigen::Affine2d &map : maps_of(*symmetry.section()))
    maps.push_back(map);
  if (!symmetry.has_third())
    maps.push_back(mirror_y);
  return maps;
}

std::string value_text(const double value)
{
  return std::isnan(value) ? "not a number" : std::isinf(value) ? "infinite" : to_text(value);
}

std::string place_text(const Vector2d &place)
{
  std::ostringstream text;
  text << std::setprecision(4) << "(" << place[0] << ", " << place[1] << ") mm";
  return text.str();
}

std::string place_text(const Eigen::Vector3d &place)
{
  if (place[2] == 0)
    return place_text(Vector2d(place.head<2>()));
  std::ostringstream text;
  text << std::setprecision(4) << "(" << place[0] << ", " << place[1] << ", " << place[2] << ") mm";
  return text.str();
}
} // namespace orthocone
