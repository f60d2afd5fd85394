// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/body/fe/recovered_stress.h>
#include <orthocone/output/vtu.h>
#include <orthocone/results/volume_fields.h>

#include <deal.II/base/quadrature_lib.h>

#include <optional>
#include <sstream>
#include <tuple>

namespace orthocone
{
namespace
{
unsigned int n_rows()
{
  unsigned int n = 0;
  for (const VolumeField &field : volume_field_list())
    n += field.n_components();
  return n;
}

/// The mirror image about z = 0.
PointFields mirrored(PointFields point)
{
  point.place[2] = -point.place[2];
  point.displacement[2] = -point.displacement[2];
  for (const unsigned int d : {0, 1})
    point.stress[d][2] = -point.stress[d][2]; // the tensor is symmetric: this sets the transposed entry, too
  return point;
}

/// The points of a mirrored cell, in an order that leaves it right-handed.
std::vector<PointFields> mirrored(const std::vector<PointFields> &points, const unsigned int degree)
{
  const std::size_t n = degree + 1;
  std::vector<PointFields> images;
  for (std::size_t i = 0; i < points.size(); ++i)
    images.push_back(mirrored(points[i - i % n + degree - i % n]));
  return images;
}

/// Fills a column with the fields of a point, and its place behind them.
void fill_column(const PointFields &point, const unsigned int column, dealii::Table<2, float> &data)
{
  unsigned int row = 0;
  for (const VolumeField &field : volume_field_list())
  {
    const auto values = field.value(point);
    for (unsigned int i = 0; i < field.n_components(); ++i)
      data(row++, column) = static_cast<float>(values[i]);
  }
  for (unsigned int i = 0; i < 3; ++i)
    data(row + i, column) = static_cast<float>(point.place[i]);
}

template<int dim>
dealii::DataOutBase::Patch<dim, 3> patch_of(const std::vector<PointFields> &points, const unsigned int index,
                                            const unsigned int degree)
{
  dealii::DataOutBase::Patch<dim, 3> patch;
  patch.patch_index = index;
  patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>(); // its constructor leaves it invalid
  patch.n_subdivisions = degree;
  patch.points_are_available = true;
  patch.data.reinit(n_rows() + 3, points.size());
  for (unsigned int column = 0; column < points.size(); ++column)
    fill_column(points[column], column, patch.data);
  return patch;
}

std::vector<std::string> row_names()
{
  std::vector<std::string> names;
  for (const VolumeField &field : volume_field_list())
    names.insert(names.end(), field.n_components(), field.name);
  return names;
}

using Ranges = std::vector<std::tuple<unsigned int, unsigned int, std::string,
                                      dealii::DataComponentInterpretation::DataComponentInterpretation>>;

Ranges row_ranges()
{
  using namespace dealii::DataComponentInterpretation;
  Ranges ranges;
  unsigned int row = 0;
  for (const VolumeField &field : volume_field_list())
  {
    const unsigned int n = field.n_components();
    if (n > 1)
      ranges.emplace_back(row, row + n - 1, field.name,
                          n == 3 ? component_is_part_of_vector : component_is_part_of_tensor);
    row += n;
  }
  return ranges;
}

/// Adds the names of the components of the stress, which deal.II does not write.
std::string with_component_names(std::string text)
{
  static const std::string here = "Name=\"stress\" NumberOfComponents=\"9\"";
  std::string names;
  for (unsigned int i = 0; i < 9; ++i)
    names += " ComponentName" + std::to_string(i) + "=\"" + "xyz"[i / 3] + "xyz"[i % 3] + "\"";
  if (const std::size_t at = text.find(here); at != std::string::npos)
    text.insert(at + here.size(), names);
  return text;
}
} // namespace

template<int dim>
std::string volume_vtu(const DisplacementSpace<dim> &space, const Materials &materials,
                       const Deformation &deformation, const bool is_mirrored)
{
  const unsigned int degree = space.fe().degree;
  const dealii::QIterated<dim> nodes(dealii::QTrapezoid<1>(), degree);
  CellFields<dim> fields(space, materials, nodes, deformation.displacement, deformation.free_strain);
  std::optional<RecoveredStress<dim>> recovered;
  if (!space.is_shared())
    recovered.emplace(space, materials, deformation);
  std::vector<dealii::DataOutBase::Patch<dim, 3>> patches;
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      std::vector<PointFields> points = fields.in(cell);
      if (recovered)
        recovered->enter(cell, nodes.get_points(), points);
      patches.push_back(
          patch_of<dim>(is_mirrored ? mirrored(points, degree) : points, patches.size(), degree));
    }
  if (patches.empty())
    return {};
  std::ostringstream text;
  // The section has rectangles, which Lagrange cells show without loss.
  dealii::DataOutBase::write_vtu(patches, row_names(), row_ranges(),
                                 dim == 2 ? lagrange_vtu_flags(degree) : vtu_flags(), text);
  return with_component_names(text.str());
}

std::string volume_pvtu(const std::vector<std::string> &pieces)
{
  std::ostringstream text;
  dealii::DataOutBase::write_pvtu_record(text, pieces, row_names(), row_ranges(), vtu_flags());
  return with_component_names(text.str());
}

template std::string volume_vtu(const Discretization &, const Materials &, const Deformation &, bool);
template std::string volume_vtu(const SectionDiscretization &, const Materials &, const Deformation &, bool);
} // namespace orthocone
