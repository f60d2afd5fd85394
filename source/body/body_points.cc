// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/body_points.h>

#include <orthocone/base/ranks.h>
#include <orthocone/body/fe/recovered_stress.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/curved_cells.h>
#include <orthocone/surface/half_space_fields.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace orthocone
{
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace
{
constexpr double rounding_in_cells = 1e-7; // in sizes of a cell
constexpr unsigned int n_values = 10;

void set_point(const Vector3d &from, dealii::Point<3> &to)
{
  to = dealii::Point<3>(from[0], from[1], from[2]);
}
void set_point(const Vector3d &from, dealii::Point<2> &to)
{
  to = dealii::Point<2>(from[0], from[2]);
}

template<int dim>
std::vector<dealii::Point<dim>> points_of(const std::vector<Vector3d> &points)
{
  std::vector<dealii::Point<dim>> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    set_point(points[i], all[i]);
  return all;
}

/// The place of a point in the unit cell, within its bounds; nothing if it lies outside.
template<int dim>
std::optional<dealii::Point<dim>> unit_point(const DisplacementSpace<dim> &space,
                                             const typename DisplacementSpace<dim>::Cell &cell,
                                             const dealii::Point<dim> &point)
{
  try
  {
    const dealii::Point<dim> unit = space.mapping().transform_real_to_unit_cell(cell, point);
    if (dealii::GeometryInfo<dim>::distance_to_unit_cell(unit) <= rounding_in_cells)
      return dealii::GeometryInfo<dim>::project_to_unit_cell(unit);
  }
  catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &) // it is far outside
  {
  }
  return std::nullopt;
}

/// A box that holds the cell, also where its faces are curved between the nodes.
template<int dim>
dealii::BoundingBox<dim> box_around(const DisplacementSpace<dim> &space,
                                    const typename DisplacementSpace<dim>::Cell &cell)
{
  const double bulge = has_curved_cells(space.dof_handler().get_triangulation()) ? 0.5 : 0.1;
  dealii::BoundingBox<dim> box = space.mapping().get_bounding_box(cell);
  box.extend(bulge * cell->diameter());
  return box;
}

/// The cells of this process with faces of the contact surface, and these, by the cells' numbers.
template<int dim>
std::map<unsigned int, std::vector<unsigned int>> faces_by_cells(const DisplacementSpace<dim> &space)
{
  std::map<unsigned int, std::vector<unsigned int>> faces;
  for (unsigned int face = 0; face < space.contact_cells().size(); ++face)
    if (space.contact_cells()[face] != dealii::numbers::invalid_unsigned_int)
      faces[space.contact_cells()[face]].push_back(face);
  return faces;
}

/// Number of the face of the contact surface on which a place in the unit cell lies, or -1. `faces` are those
/// of the cell, in the order of its faces.
template<int dim>
double face_at(const typename DisplacementSpace<dim>::Cell &cell, const dealii::Point<dim> &unit,
               const std::vector<unsigned int> &faces)
{
  std::size_t k = 0;
  for (const unsigned int face : cell->face_indices())
    if (cell->face(face)->at_boundary() && is_contact(cell->face(face)->boundary_id()))
    {
      if (std::abs(unit[face / 2] - face % 2) <= rounding_in_cells && k < faces.size())
        return faces[k];
      ++k;
    }
  return -1;
}
} // namespace

template<int dim>
void BodyPoints::find(const DisplacementSpace<dim> &space, const std::vector<Vector3d> &points)
{
  const std::vector<dealii::Point<dim>> places = points_of<dim>(points);
  const auto tree = dealii::pack_rtree_of_indices(places);
  const auto faces = faces_by_cells(space);
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      std::vector<std::size_t> near;
      tree.query(boost::geometry::index::intersects(box_around(space, cell)), std::back_inserter(near));
      std::sort(near.begin(), near.end());
      InCell in{cell->level(), cell->index()};
      for (const std::size_t i : near)
        if (const auto unit = unit_point(space, cell, places[i]))
        {
          in.points.push_back(i);
          in.unit_points.emplace_back((*unit)[0], (*unit)[1], (*unit)[dim - 1]);
          ++n_cells_[i];
          if (const auto of_cell = faces.find(cell->active_cell_index()); of_cell != faces.end())
            faces_[i] = std::max(faces_[i], face_at<dim>(cell, *unit, of_cell->second));
        }
      if (!in.points.empty())
        cells_.push_back(std::move(in));
    }
}

BodyPoints::BodyPoints(const Body &body, const std::vector<Vector3d> &points)
    : body_(body),
      n_cells_(points.size(), 0),
      faces_(points.size(), -1)
{
  if (!body.has_mesh())
  {
    find_in_half_space(points);
    return;
  }
  const bool is_shared = body.visit([](const auto &space) { return space.is_shared(); });
  body.visit([&](const auto &space) { find(space, points); });
  if (is_shared)
  {
    sum_over_ranks(n_cells_.data(), n_cells_.size());
    largest_of_ranks(faces_.data(), faces_.size());
  }
}

/// All that is not below the plane is inside, as if it were one cell; the faces of the contact surface lie
/// between the middles of patches.
void BodyPoints::find_in_half_space(const std::vector<Vector3d> &points)
{
  places_ = points;
  const SurfaceGrid &grid = body_.surface_grid();
  const auto face_along = [](const double place, const Eigen::Index n, const double width)
  { return std::floor(place / width + static_cast<double>(n - 1) / 2); };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    n_cells_[i] = points[i][2] >= 0 ? 1 : 0;
    const double along_x = face_along(points[i][0], grid.n_x, grid.width),
                 along_y = face_along(points[i][1], grid.n_y, grid.height);
    const auto last_x = static_cast<double>(grid.n_x - 2), last_y = static_cast<double>(grid.n_y - 2);
    if (points[i][2] == 0 && along_x >= 0 && along_y >= 0 && along_x <= last_x && along_y <= last_y)
      faces_[i] = along_y * (last_x + 1) + along_x;
  }
}

std::vector<PointFields> BodyPoints::fields_in_half_space(const Deformation &deformation) const
{
  const Material &material = body_.materials().of(0);
  const double lambda = material.volumetric_modulus(), mu = material.shear_modulus();
  const HalfSpace half_space{mu * (3 * lambda + 2 * mu) / (lambda + mu), lambda / (2 * (lambda + mu))};
  std::vector<PointFields> all(places_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const HalfSpaceFields own =
        fields_below(body_.surface_grid(), half_space, deformation.tractions, places_[i]);
    all[i].displacement =
        own.displacement + deformation.motion.at(places_[i] - body_.unknowns().held_centre());
    Strain strain;
    for (unsigned int row = 0; row < 3; ++row)
      for (unsigned int column = row; column < 3; ++column)
        strain[row][column] = (own.gradient(row, column) + own.gradient(column, row)) / 2;
    all[i].stress = material.stress(strain);
  }
  return all;
}

template<int dim>
void BodyPoints::add_fields(const DisplacementSpace<dim> &space, const Deformation &deformation,
                            MatrixXd &sums) const
{
  const auto &mesh = space.dof_handler().get_triangulation();
  std::optional<RecoveredStress<dim>> recovered;
  if (!space.is_shared())
    recovered.emplace(space, body_.materials(), deformation);
  for (const InCell &in : cells_)
  {
    std::vector<dealii::Point<dim>> unit_points(in.points.size());
    for (std::size_t i = 0; i < in.points.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        unit_points[i][d] = in.unit_points[i][d];
    const typename DisplacementSpace<dim>::Cell cell(&mesh, in.level, in.index, &space.dof_handler());
    std::vector<PointFields> fields =
        CellFields<dim>(space, body_.materials(), dealii::Quadrature<dim>(unit_points),
                        deformation.displacement, deformation.free_strain)
            .in(cell);
    if (recovered)
      recovered->enter(cell, unit_points, fields);
    for (std::size_t i = 0; i < in.points.size(); ++i)
    {
      auto sum = sums.col(static_cast<Eigen::Index>(in.points[i]));
      sum.head<3>() += fields[i].displacement;
      for (unsigned int k = 0; k < Stress::n_independent_components; ++k)
        sum[3 + k] += fields[i].stress.access_raw_entry(k);
      sum[n_values - 1] += fields[i].stress_error;
    }
  }
}

std::vector<PointFields> BodyPoints::fields(const Deformation &deformation) const
{
  if (!body_.has_mesh())
    return fields_in_half_space(deformation);
  MatrixXd sums = MatrixXd::Zero(n_values, static_cast<Eigen::Index>(n_cells_.size()));
  const bool is_shared = body_.visit([](const auto &space) { return space.is_shared(); });
  body_.visit([&](const auto &space) { add_fields(space, deformation, sums); });
  if (is_shared)
    sum_over_ranks(sums.data(), static_cast<std::size_t>(sums.size()));
  std::vector<PointFields> all(n_cells_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Eigen::VectorXd mean = sums.col(static_cast<Eigen::Index>(i)) / std::max(1., n_cells_[i]);
    all[i].displacement = mean.head<3>();
    for (unsigned int k = 0; k < Stress::n_independent_components; ++k)
      all[i].stress.access_raw_entry(k) = mean[3 + k];
    all[i].stress_error = mean[n_values - 1];
  }
  return all;
}
} // namespace orthocone
