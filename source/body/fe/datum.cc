// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "datum.h"

#include "dof_places.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/surface/rigid_motion.h>

#include <algorithm>
#include <set>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;

// Nothing but contact may hold a body in some of its rigid motions. Let N be a basis of the k motions that
// supports and symmetry leave, which are those of m^T H m = 0 with H = sum of R_i^T R_i over what they hold.
// The stiffness becomes regular if k more displacements d are held, such that R_d N is regular. These follow
// k components of a rigid motion c, such that R_d,c is regular, and the components are driven by forces of
// zero: then nothing acts on the k displacements, wherever they are. Both choices are those of complete
// pivoting.
namespace
{
/// Displacements along a direction at a place, by the components of a rigid motion.
struct RigidRow
{
  unsigned int vertex;
  unsigned int direction;
  RowVectorXd row;
};

template<int dim>
class DatumSearch
{
public:
  DatumSearch(const dealii::Triangulation<dim> &triangulation, const SectionModel &section)
      : triangulation_(triangulation),
        section_(section)
  {
    // The coarsest mesh is the same in all processes and on all levels.
    double n = 0;
    for_vertices_of_top([&](const unsigned int, const Vector3d &place) { centre_ += place, ++n; });
    centre_ /= n;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        reach_ = std::max(reach_, (in_space(cell->vertex(v)) - centre_).norm());
    for (unsigned int j = 0; j < n_rigid_components; ++j)
      if (leaves(j))
        components_.push_back(j);
  }

  Datum run(const HeldSurfaces &held)
  {
    const MatrixXd free = free_motions(held);
    const std::vector<RigidRow> rows = rows_of_top();
    if (static_cast<Index>(rows.size()) < free.cols())
      throw InputError("Geometry/Top face = free: too few corners of cells on the top are off the contact "
                       "surface to tell how the body moves: allowed are more cells there, or supports");
    MatrixXd moved(static_cast<Index>(rows.size()), free.cols()),
        all(moved.rows(), static_cast<Index>(components_.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      all.row(static_cast<Index>(i)) = rows[i].row;
      moved.row(static_cast<Index>(i)) = rows[i].row * free;
    }
    Datum datum;
    MatrixXd of_datum(free.cols(), all.cols());
    for (const Index i : pivots(moved.transpose(), free.cols()))
    {
      of_datum.row(static_cast<Index>(datum.held.size())) = all.row(i);
      datum.held.emplace_back(rows[static_cast<std::size_t>(i)].vertex,
                              rows[static_cast<std::size_t>(i)].direction);
    }
    for (const Index j : pivots(of_datum, free.cols()))
      datum.components.push_back(components_[static_cast<std::size_t>(j)]);
    std::sort(datum.components.begin(), datum.components.end());
    return datum;
  }

private:
  /// Whether a rigid motion strains no section and moves one.
  bool leaves(const unsigned int component) const
  {
    if (dim == 3)
      return true;
    const std::array<bool, n_rigid_components> revolved{
        {false, false, true, false, false, section_.has_third}},
        plane{{true, section_.has_third, true, false, true, false}};
    return section_.is_revolved() ? revolved[component] : plane[component];
  }

  /// How a rigid motion moves a place along a direction, with rotations scaled to lengths.
  RowVectorXd row_at(const Vector3d &place, const unsigned int direction) const
  {
    RowVectorXd row(static_cast<Index>(components_.size()));
    for (std::size_t j = 0; j < components_.size(); ++j)
    {
      RigidMotion unit;
      unit[components_[j]] = components_[j] < 3 ? 1 : 1 / reach_;
      row[static_cast<Index>(j)] = unit.at(place - centre_)[direction];
    }
    return row;
  }

  template<typename Use>
  void for_vertices_of_top(const Use &use) const
  {
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == Boundary::top_face)
          for (const unsigned int v : face->vertex_indices())
            use(face->vertex_index(v), in_space(face->vertex(v)));
  }

  /// N, in columns: what neither supports nor planes of symmetry hold.
  MatrixXd free_motions(const HeldSurfaces &held) const
  {
    constexpr double rounding = 1e-10;
    std::vector<HeldBoundary> all = held.supports;
    all.push_back({Boundary::plane_normal_to_x, {{true, false, false}}});
    all.push_back({Boundary::plane_normal_to_y, {{false, true, false}}});
    const auto n = static_cast<Index>(components_.size());
    MatrixXd hold = MatrixXd::Zero(n, n);
    for (const auto &cell : triangulation_.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          for (const HeldBoundary &boundary : all)
            if (face->at_boundary() && face->boundary_id() == boundary.id)
              for (const unsigned int v : face->vertex_indices())
                for (unsigned int d = 0; d < 3; ++d)
                  if (boundary.directions[d])
                  {
                    const RowVectorXd row = row_at(in_space(face->vertex(v)), d);
                    hold += row.transpose() * row;
                  }
    sum_over_ranks(hold.data(), static_cast<std::size_t>(hold.size()));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(hold);
    Index n_free = 0;
    while (n_free < n && modes.eigenvalues()[n_free] <= rounding * std::max(1., modes.eigenvalues()[n - 1]))
      ++n_free;
    return modes.eigenvectors().leftCols(n_free);
  }

  /// Vertices of the contact surface, which the counterface alone may hold.
  std::set<unsigned int> vertices_of_contact() const
  {
    std::set<unsigned int> vertices;
    for (const auto &cell : triangulation_.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && is_contact(face->boundary_id()))
          for (const unsigned int v : face->vertex_indices())
            vertices.insert(face->vertex_index(v));
    return vertices;
  }

  std::vector<RigidRow> rows_of_top() const
  {
    const std::set<unsigned int> touching = vertices_of_contact();
    std::vector<RigidRow> rows;
    for_vertices_of_top(
        [&](const unsigned int vertex, const Vector3d &place)
        {
          for (unsigned int d = 0; d < 3; ++d)
            if (touching.count(vertex) == 0 && (dim == 3 || d != 1 || section_.has_third))
              rows.push_back({vertex, d, row_at(place, d)});
        });
    return rows;
  }

  /// The numbers of `n` columns that are independent: each time the one that is longest across those before,
  /// and the first of equally long ones.
  static std::vector<Index> pivots(MatrixXd columns, const Index n)
  {
    std::vector<Index> chosen;
    for (Index k = 0; k < n; ++k)
    {
      constexpr double rounding = 1e-6;
      const RowVectorXd lengths = columns.colwise().squaredNorm();
      Index longest = 0;
      while (lengths[longest] < (1 - rounding) * lengths.maxCoeff())
        ++longest;
      const Eigen::VectorXd direction = columns.col(longest).normalized();
      columns -= direction * (direction.transpose() * columns);
      chosen.push_back(longest);
    }
    return chosen;
  }

  const dealii::Triangulation<dim> &triangulation_;
  const SectionModel section_;
  Vector3d centre_ = Vector3d::Zero(); ///< of the vertices of the top
  std::vector<unsigned int> components_;
  double reach_ = 0;
};
} // namespace

template<int dim>
Datum datum_of(const dealii::Triangulation<dim> &triangulation, const HeldSurfaces &held,
               const SectionModel &section)
{
  return held.has_datum ? DatumSearch<dim>(triangulation, section).run(held) : Datum();
}

template Datum datum_of(const dealii::Triangulation<2> &, const HeldSurfaces &, const SectionModel &);
template Datum datum_of(const dealii::Triangulation<3> &, const HeldSurfaces &, const SectionModel &);
} // namespace orthocone
