// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/simulation/vtu.h>

#include <sstream>

namespace orthocone
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Patch = dealii::DataOutBase::Patch<2, 3>;
using VectorRanges =
    std::vector<std::tuple<unsigned int, unsigned int, std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>;

/// Names and values of the fields, in one order for all nodes.
class FieldList
{
public:
  explicit FieldList(const ContactFields &fields)
  {
    add("displacement", fields.displacement);
    add("slip", fields.slip);
    add("slip_magnitude", fields.slip.norm());
    add("accumulated_slip", fields.accumulated_slip);
    add("gap", fields.gap);
    add("pressure", fields.pressure);
    add("friction_traction", fields.friction_traction);
    add("friction_criterion", fields.friction_criterion);
    add("status", static_cast<int>(fields.status));
    add("nodal_force", fields.nodal_force);
    add("dissipated_energy", fields.dissipated_energy);
  }

  std::vector<std::string> names;
  std::vector<double> values;
  VectorRanges vectors;

private:
  void add(const std::string &name, const double value)
  {
    names.push_back(name);
    values.push_back(value);
  }

  void add(const std::string &name, const Vector3d &value)
  {
    const unsigned int first = values.size();
    for (const double component : value)
    {
      names.push_back(name);
      values.push_back(component);
    }
    vectors.emplace_back(first, first + 2, name,
                         dealii::DataComponentInterpretation::component_is_part_of_vector);
  }
};

ContactFields mapped(ContactFields fields, const Matrix2d &map)
{
  for (Vector3d *const vector :
       {&fields.displacement, &fields.slip, &fields.friction_traction, &fields.nodal_force})
    vector->head<2>() = map * vector->head<2>().eval();
  return fields;
}

/// Values of all fields at all nodes, in one image, with the positions in the last three rows.
Eigen::MatrixXf image_values(const ContactSurface &surface, const std::vector<ContactFields> &fields,
                             const Matrix2d &map)
{
  const Eigen::Index n_rows = FieldList{ContactFields()}.values.size();
  Eigen::MatrixXf values(n_rows + 3, fields.size());
  for (std::size_t node = 0; node < fields.size(); ++node)
  {
    const FieldList list(mapped(fields[node], map));
    const auto &place = surface.nodes[node].position;
    const Vector2d position = map * Vector2d(place[0], place[1]);
    values.col(node) << Eigen::Map<const Eigen::VectorXd>(list.values.data(), n_rows).cast<float>(),
        static_cast<float>(position[0]), static_cast<float>(position[1]), 0;
  }
  return values;
}

/// A face of the whole surface. Its points are the nodes themselves.
Patch make_patch(const unsigned int degree, const std::vector<WholeSurface::Node> &face,
                 const std::vector<Eigen::MatrixXf> &values)
{
  Patch patch;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral; // its constructor leaves it invalid
  patch.n_subdivisions = degree;
  patch.points_are_available = true;
  const Eigen::Index n_rows = values.front().rows();
  patch.data.reinit(n_rows, face.size());
  for (unsigned int i = 0; i < face.size(); ++i)
    for (Eigen::Index row = 0; row < n_rows; ++row)
      patch.data(row, i) = values[face[i].image](row, face[i].node);
  return patch;
}
} // namespace

std::string contact_vtu(const ContactFieldEvaluator &evaluator, const ContactState &state)
{
  const auto fields = evaluator.all_fields(state);
  const ContactSurface &surface = evaluator.surface();
  const WholeSurface whole = evaluator.symmetry().whole(surface);
  std::vector<Eigen::MatrixXf> values;
  for (const Matrix2d &map : whole.images)
    values.push_back(image_values(surface, fields, map));
  std::vector<Patch> patches;
  for (const auto &face : whole.faces)
  {
    patches.push_back(make_patch(surface.degree, face, values));
    patches.back().patch_index = patches.size() - 1;
  }
  const FieldList list{ContactFields()};
  std::ostringstream text;
  dealii::DataOutBase::write_vtu(patches, list.names, list.vectors, vtu_flags(surface.degree), text);
  return text.str();
}
} // namespace orthocone
