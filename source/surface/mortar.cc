// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mortar.h>

#include "opposed_faces.h"

#include <Eigen/Dense>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace
{
/// Area of a face that others cover, mm^2.
double covered_area(const Opposition &faces)
{
  double area = 0;
  for (const auto &other : faces.others)
    at_common_parts(*faces.own, *other,
                    [&](const PlanePolygon &common, const double sign)
                    { area += sign * signed_area(common); });
  return area;
}

/// Takes a face of which `area` is covered into account.
void look_at(const CutFace &face, const double area, SurfaceCover &cover)
{
  if (const double part = area / face.area; part < cover.least)
    cover = {part, face.centre};
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
  std::vector<std::pair<std::vector<unsigned int>, MatrixXd>> mixed; ///< with nodes of the other surface
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
                                     const PlaneFace::Values weighted =
                                         sign * area * own.steepness(values) * values;
                                     sums.single += weighted;
                                     sums.products.noalias() += weighted * values.transpose();
                                     mixed.noalias() += weighted * other.face.values(at_other).transpose();
                                   });
                  });
}

FaceIntegrals integrals(const Opposition &faces, const TriangleRule &rule)
{
  FaceIntegrals sums(static_cast<Index>(faces.own->nodes.size()));
  for (const auto &other : faces.others)
  {
    if (!overlap(faces.own->box, other->box))
      continue;
    MatrixXd mixed = MatrixXd::Zero(sums.single.size(), static_cast<Index>(other->nodes.size()));
    add_common(*faces.own, *other, rule, sums, mixed);
    if (!mixed.isZero(0))
      sums.mixed.emplace_back(other->nodes, std::move(mixed));
  }
  return sums;
}

/// The sums over faces that make the map.
class MapSums
{
public:
  MapSums(const std::size_t n_nodes, const std::size_t n_others)
      : n_others_(static_cast<Index>(n_others)),
        single_(VectorXd::Zero(static_cast<Index>(n_nodes)))
  {
  }

  /// A dual function is the sum of the nodes' functions whose product with all but one of them has no
  /// integral.
  void add(const std::vector<unsigned int> &face, const FaceIntegrals &of)
  {
    const MatrixXd dual = of.single.asDiagonal() * of.products.inverse();
    for (std::size_t i = 0; i < face.size(); ++i)
      single_[face[i]] += of.single[static_cast<Index>(i)];
    for (const auto &[others, mixed] : of.mixed)
    {
      const MatrixXd seen = dual * mixed;
      for (std::size_t i = 0; i < face.size(); ++i)
        for (std::size_t j = 0; j < others.size(); ++j)
          terms_.emplace_back(face[i], others[j], seen(static_cast<Index>(i), static_cast<Index>(j)));
    }
  }

  Eigen::SparseMatrix<double> map() const
  {
    Eigen::SparseMatrix<double> map(single_.size(), n_others_);
    map.setFromTriplets(terms_.begin(), terms_.end());
    return single_.cwiseInverse().asDiagonal() * map;
  }

private:
  Index n_others_;
  VectorXd single_;
  std::vector<Eigen::Triplet<double>> terms_;
};
} // namespace

SurfaceCover surface_cover(const ContactSurface &surface, const ContactSurface &other, const Facing facing)
{
  const OpposedFaces faces(surface, other, facing);
  SurfaceCover cover;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Opposition opposed = faces.at(i);
    look_at(*opposed.own, covered_area(opposed), cover);
  }
  return cover;
}

double covered_share(const ContactSurface &surface, const ContactSurface &other, const Facing facing)
{
  const OpposedFaces faces(surface, other, facing);
  double covered = 0, area = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Opposition opposed = faces.at(i);
    covered += covered_area(opposed);
    area += opposed.own->area;
  }
  return area > 0 ? covered / area : 1;
}

MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other, const Facing facing)
{
  const OpposedFaces faces(surface, other, facing);
  // This is exact for products of two functions on parallelograms.
  const TriangleRule rule(2 * std::max(surface.degree, other.degree) + 1);
  MortarMap result;
  MapSums sums(surface.nodes.size(), other.nodes.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Opposition opposed = faces.at(i);
    const FaceIntegrals of = integrals(opposed, rule);
    look_at(*opposed.own, of.area, result.cover);
    if (result.cover.is_enough())
      sums.add(opposed.own->nodes, of);
  }
  if (result.cover.is_enough())
    result.map = sums.map();
  return result;
}

VectorXd distances(const ContactSurface &surface, const ContactSurface &other,
                   const Eigen::SparseMatrix<double> &map)
{
  MatrixXd places(static_cast<Index>(other.nodes.size()), 3);
  for (std::size_t j = 0; j < other.nodes.size(); ++j)
    places.row(static_cast<Index>(j)) = other.nodes[j].place();
  const MatrixXd seen = map * places;
  VectorXd distances(seen.rows());
  for (Index i = 0; i < seen.rows(); ++i)
  {
    const ContactNode &node = surface.nodes[static_cast<std::size_t>(i)];
    distances[i] = node.inward.dot(node.place() - seen.row(i).transpose());
  }
  return distances;
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
