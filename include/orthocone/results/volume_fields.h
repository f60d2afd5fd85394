// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/cell_fields.h>

#include <array>
#include <variant>
#include <vector>

namespace orthocone
{
/// A field of the files of the volume. A new one is a line in volume_field_list().
struct VolumeField
{
  using Vector = Eigen::Vector3d PointFields::*;
  using Tensor = Stress PointFields::*;
  using Derived = double (*)(const PointFields &);

  const char *name;
  const char *unit;
  const char *how;
  std::variant<Vector, Tensor, Derived> of;

  unsigned int n_components() const;

  /// The value; its first n_components() numbers count, for a tensor row by row.
  std::array<double, 9> value(const PointFields &point) const;
};

/// The fields in the order of the files.
const std::vector<VolumeField> &volume_field_list();
} // namespace orthocone
