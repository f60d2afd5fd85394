// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/volume_fields.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace orthocone
{
namespace
{
double von_mises_stress(const PointFields &point)
{
  return std::sqrt(1.5) * deviator(point.stress).norm();
}

/// The i-th of the principal stresses; the first one is the largest.
template<unsigned int i>
double principal_stress(const PointFields &point)
{
  return dealii::eigenvalues(point.stress)[i];
}

double stress_error(const PointFields &point)
{
  return point.stress_error;
}

double volume(const PointFields &point)
{
  return point.volume;
}
} // namespace

const std::vector<VolumeField> &volume_field_list()
{
  static const std::vector<VolumeField> fields{
      {"displacement", "mm", "displacement from the undeformed body", &PointFields::displacement},
      {"stress", "MPa", "Cauchy stress in global axes: xx, xy, xz, yx, ..., zz", &PointFields::stress},
      {"von_mises_stress", "MPa", "sqrt(3/2) times the norm of the deviator", von_mises_stress},
      {"principal_stress_1", "MPa", "largest principal stress, tension is > 0", principal_stress<0>},
      {"principal_stress_2", "MPa", "middle principal stress", principal_stress<1>},
      {"principal_stress_3", "MPa", "smallest principal stress", principal_stress<2>},
      {"stress_error", "MPa", "estimated error of the stress, as a von Mises stress", stress_error},
      {"region", "", "number of the physical volume of the mesh file; 0 where there is none", volume}};
  return fields;
}

unsigned int VolumeField::n_components() const
{
  return std::holds_alternative<Vector>(of) ? 3 : std::holds_alternative<Tensor>(of) ? 9 : 1;
}

std::array<double, 9> VolumeField::value(const PointFields &point) const
{
  std::array<double, 9> values{};
  if (const auto *const vector = std::get_if<Vector>(&of))
    for (unsigned int i = 0; i < 3; ++i)
      values[i] = (point.*(*vector))[i];
  else if (const auto *const tensor = std::get_if<Tensor>(&of))
    for (unsigned int i = 0; i < 9; ++i)
      values[i] = (point.*(*tensor))[i / 3][i % 3];
  else
    values[0] = std::get<Derived>(of)(point);
  return values;
}
} // namespace orthocone
