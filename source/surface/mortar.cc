// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mortar.h>

#include "face_basis.h"
#include "face_pieces.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace
{
template<typename Places>
Eigen::AlignedBox2d box_of(const Places &places)
{
  Eigen::AlignedBox2d box;
  for (const Vector2d &place : places)
    box.extend(place);
  return box;
}

/// Whether two boxes share more than an edge.
bool overlap(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b)
{
  return (a.max().cwiseMin(b.max()).array() > a.min().cwiseMax(b.min()).array()).all();
}

/// A triangle of an outline.
struct Part
{
  SignedTriangle triangle;
  Eigen::AlignedBox2d box;
};

/// A face and the triangles of its outline.
struct CutFace
{
  CutFace(const unsigned int degree, std::vector<Vector2d> places)
      : face(degree, std::move(places)),
        area(std::abs(signed_area(face.outline()))),
        box(box_of(face.outline()))
  {
    for (const SignedTriangle &triangle : triangles(face.outline()))
      parts.push_back({triangle, box_of(triangle.corners)});
  }
  PlaneFace face;
  std::vector<Part> parts{};
  double area;
  Eigen::AlignedBox2d box;
};

std::vector<CutFace> cut_faces(const ContactSurface &surface)
{
  std::vector<CutFace> faces;
  for (const auto &face : surface.faces)
  {
    std::vector<Vector2d> places;
    for (const unsigned int node : face)
      places.emplace_back(surface.nodes[node].position[0], surface.nodes[node].position[1]);
    faces.emplace_back(surface.degree, std::move(places));
  }
  return faces;
}

/// Calls use(polygon, sign) with the convex parts, and signs, of which the intersection of two faces is the
/// sum. What they share along an edge, by rounding, is no part.
template<typename Use>
void at_common_parts(const CutFace &own, const CutFace &other, const Use &use)
{
  constexpr double rounding = 1e-14; // of an area
  if (!overlap(own.box, other.box))
    return;
  for (const auto &[part, box] : own.parts)
    for (const auto &[of_other, other_box] : other.parts)
      if (overlap(box, other_box))
        if (const PlanePolygon common = common_part(part.corners, of_other.corners);
            signed_area(common) > rounding * own.area)
          use(common, part.sign * of_other.sign);
}

/// Area of a face that others cover, mm^2.
double covered_area(const CutFace &face, const std::vector<CutFace> &others)
{
  double area = 0;
  for (const CutFace &below : others)
    at_common_parts(face, below,
                    [&](const PlanePolygon &common, const double sign)
                    { area += sign * signed_area(common); });
  return area;
}

/// Takes a face of which `area` is covered into account.
void look_at(const CutFace &face, const double area, SurfaceCover &cover)
{
  if (const double part = area / face.area; part < cover.least)
  {
    const Vector2d centre = face.face.position({0.5, 0.5});
    cover = {part, {{centre[0], centre[1]}}};
  }
}

/// Gauss points of a triangle, with one corner as the end of a square.
class TriangleRule
{
public:
  explicit TriangleRule(const unsigned int n)
      : rule_(gauss_rule(n))
  {
  }

  /// Calls use(position, area) at the points of the triangles of a convex polygon.
  template<typename Use>
  void at_points(const PlanePolygon &polygon, const Use &use) const
  {
    for (const auto &[corners, sign] : triangles(polygon))
    {
      const double twice_area = 2 * sign * signed_area(corners);
      for (const auto &[u, weight_u] : rule_)
        for (const auto &[v, weight_v] : rule_)
          use(corners[0] + u * (corners[1] - corners[0] + v * (corners[2] - corners[1])),
              weight_u * weight_v * u * twice_area);
    }
  }

private:
  std::vector<std::array<double, 2>> rule_;
};

/// Integrals over a face: of its nodes' functions, of products of two of them, and of products of one of them
/// with a function of the other surface.
struct FaceIntegrals
{
  explicit FaceIntegrals(const Index n)
      : single(VectorXd::Zero(n)),
        products(MatrixXd::Zero(n, n))
  {
  }
  VectorXd single;
  MatrixXd products;
  std::vector<std::pair<std::size_t, MatrixXd>> mixed; ///< with the nodes of a face of the other surface
  double area = 0;
};

/// Adds the integrals over the intersection of two faces.
void add_common(const CutFace &own, const CutFace &other, const TriangleRule &rule, FaceIntegrals &sums,
                MatrixXd &mixed)
{
  Vector2d at(0.5, 0.5), at_other = at; // the points follow each other closely
  at_common_parts(own, other,
                  [&](const PlanePolygon &common, const double sign)
                  {
                    sums.area += sign * signed_area(common);
                    rule.at_points(common,
                                   [&](const Vector2d &position, const double area)
                                   {
                                     at = own.face.unit_of(position, at);
                                     at_other = other.face.unit_of(position, at_other);
                                     const PlaneFace::Values values = own.face.values(at);
                                     const PlaneFace::Values weighted = sign * area * values;
                                     sums.single += weighted;
                                     sums.products.noalias() += weighted * values.transpose();
                                     mixed.noalias() += weighted * other.face.values(at_other).transpose();
                                   });
                  });
}

FaceIntegrals integrals(const CutFace &own, const std::vector<CutFace> &others, const TriangleRule &rule)
{
  FaceIntegrals sums(own.face.values({0, 0}).size());
  for (std::size_t k = 0; k < others.size(); ++k)
  {
    if (!overlap(own.box, others[k].box))
      continue;
    MatrixXd mixed = MatrixXd::Zero(sums.single.size(), others[k].face.values({0, 0}).size());
    add_common(own, others[k], rule, sums, mixed);
    if (!mixed.isZero(0))
      sums.mixed.emplace_back(k, std::move(mixed));
  }
  return sums;
}

/// The sums over faces that make the map.
class MapSums
{
public:
  MapSums(const ContactSurface &surface, const ContactSurface &other)
      : surface_(surface),
        other_(other),
        single_(VectorXd::Zero(static_cast<Index>(surface.nodes.size())))
  {
  }

  /// A dual function is the sum of the nodes' functions whose product with all but one of them has no
  /// integral.
  void add(const std::vector<unsigned int> &face, const FaceIntegrals &of)
  {
    const MatrixXd dual = of.single.asDiagonal() * of.products.inverse();
    for (std::size_t i = 0; i < face.size(); ++i)
      single_[face[i]] += of.single[static_cast<Index>(i)];
    for (const auto &[number, mixed] : of.mixed)
    {
      const MatrixXd seen = dual * mixed;
      for (std::size_t i = 0; i < face.size(); ++i)
        for (std::size_t j = 0; j < other_.faces[number].size(); ++j)
          terms_.emplace_back(face[i], other_.faces[number][j],
                              seen(static_cast<Index>(i), static_cast<Index>(j)));
    }
  }

  Eigen::SparseMatrix<double> map() const
  {
    Eigen::SparseMatrix<double> map(static_cast<Index>(surface_.nodes.size()),
                                    static_cast<Index>(other_.nodes.size()));
    map.setFromTriplets(terms_.begin(), terms_.end());
    return single_.cwiseInverse().asDiagonal() * map;
  }

private:
  const ContactSurface &surface_, &other_;
  VectorXd single_;
  std::vector<Eigen::Triplet<double>> terms_;
};
} // namespace

SurfaceCover surface_cover(const ContactSurface &surface, const ContactSurface &other)
{
  const std::vector<CutFace> others = cut_faces(other);
  SurfaceCover cover;
  for (const CutFace &face : cut_faces(surface))
    look_at(face, covered_area(face, others), cover);
  return cover;
}

double covered_share(const ContactSurface &surface, const ContactSurface &other)
{
  const std::vector<CutFace> others = cut_faces(other);
  double covered = 0, area = 0;
  for (const CutFace &face : cut_faces(surface))
  {
    covered += covered_area(face, others);
    area += face.area;
  }
  return area > 0 ? covered / area : 1;
}

MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other)
{
  const std::vector<CutFace> own = cut_faces(surface), others = cut_faces(other);
  // This is exact for products of two functions on parallelograms.
  const TriangleRule rule(2 * std::max(surface.degree, other.degree) + 1);
  MortarMap result;
  MapSums sums(surface, other);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const FaceIntegrals of = integrals(own[i], others, rule);
    look_at(own[i], of.area, result.cover);
    if (result.cover.is_enough())
      sums.add(surface.faces[i], of);
  }
  if (result.cover.is_enough())
    result.map = sums.map();
  return result;
}

MatrixXd mapped_compliance(const Eigen::SparseMatrix<double> &map, const DenseView &compliance)
{
  // Few rows at a time stay in the cache. Sums run over entries that lie side by side.
  constexpr Index most_rows = 16;
  const Eigen::SparseMatrix<double> across = map.transpose();
  const Index n = map.rows();
  MatrixXd mapped(n, n);
  for (Index first = 0; first < n; first += most_rows)
  {
    const Index n_rows = std::min(most_rows, n - first), rest = n - first - n_rows;
    const MatrixXd half = compliance * across.middleCols(first, n_rows);
    const MatrixXd turned = half.transpose();
    const MatrixXd rows = turned * across.rightCols(n - first);
    mapped.block(first, first, n_rows, n_rows) = rows.leftCols(n_rows).selfadjointView<Eigen::Upper>();
    mapped.block(first, first + n_rows, n_rows, rest) = rows.rightCols(rest);
    mapped.block(first + n_rows, first, rest, n_rows) = rows.rightCols(rest).transpose();
  }
  return mapped;
}
} // namespace orthocone
