// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "vtu_flags.h"

#include <orthocone/simulation/vtu.h>

#include <sstream>

namespace orthocone
{
namespace
{
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

/// Reflection about the planes x = 0 and y = 0: factors of the components of vectors.
ContactFields mirrored(ContactFields fields, const Vector3d &signs)
{
  for (Vector3d *const vector :
       {&fields.displacement, &fields.slip, &fields.friction_traction, &fields.nodal_force})
    *vector = vector->cwiseProduct(signs);
  return fields;
}

std::vector<Vector3d> image_signs(const SymmetryPlanes &planes)
{
  std::vector<Vector3d> signs;
  for (const double x : {1., -1.})
    for (const double y : {1., -1.})
      if ((x > 0 || planes.normal_to_x) && (y > 0 || planes.normal_to_y))
        signs.emplace_back(x, y, 1);
  return signs;
}

/// Values of all fields at all nodes, in one image.
std::vector<std::vector<double>> image_values(const std::vector<ContactFields> &fields, const Vector3d &signs)
{
  std::vector<std::vector<double>> values;
  values.reserve(fields.size());
  for (const ContactFields &node : fields)
    values.push_back(FieldList(mirrored(node, signs)).values);
  return values;
}

/// A face in one image. Its points are the nodes themselves, written as the last three rows of the data.
Patch make_patch(const ContactSurface &surface, const std::vector<unsigned int> &face,
                 const std::vector<std::vector<double>> &values, const Vector3d &signs)
{
  Patch patch;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral; // its constructor leaves it invalid
  patch.n_subdivisions = surface.degree;
  patch.points_are_available = true;
  const unsigned int n_rows = values.front().size();
  patch.data.reinit(n_rows + 3, face.size());
  // A reflection turns the face over; running through its first direction backwards turns it back.
  const bool is_turned = signs.prod() < 0;
  const unsigned int n_side = surface.degree + 1;
  for (unsigned int i = 0; i < face.size(); ++i)
  {
    const unsigned int node = face[is_turned ? i - i % n_side + (n_side - 1 - i % n_side) : i];
    for (unsigned int row = 0; row < n_rows; ++row)
      patch.data(row, i) = static_cast<float>(values[node][row]);
    for (unsigned int d = 0; d < 2; ++d)
      patch.data(n_rows + d, i) = static_cast<float>(signs[d] * surface.nodes[node].position[d]);
    patch.data(n_rows + 2, i) = 0;
  }
  return patch;
}
} // namespace

std::string contact_vtu(const ContactFieldEvaluator &evaluator, const ContactState &state)
{
  const auto fields = evaluator.all_fields(state);
  std::vector<Patch> patches;
  for (const Vector3d &signs : image_signs(evaluator.planes()))
  {
    const auto values = image_values(fields, signs);
    for (const auto &face : evaluator.surface().faces)
    {
      patches.push_back(make_patch(evaluator.surface(), face, values, signs));
      patches.back().patch_index = patches.size() - 1;
    }
  }
  const FieldList list{ContactFields()};
  std::ostringstream text;
  dealii::DataOutBase::write_vtu(patches, list.names, list.vectors, vtu_flags(evaluator.surface().degree),
                                 text);
  return text.str();
}
} // namespace orthocone
