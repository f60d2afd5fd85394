// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/materials/material.h>

#include <deal.II/base/types.h>

#include <map>

namespace orthocone
{
/// The material of every cell, by the number of its volume: the material of a region, or the one for all
/// other cells.
class Materials
{
public:
  /// One material everywhere. Not explicit, because a material is such a choice.
  Materials(const Material &everywhere)
      : other_(everywhere)
  {
  }
  Materials(const MaterialOptions &everywhere)
      : other_(everywhere)
  {
  }

  /// With the regions of a mesh file, which has their names. Throws as read_gmsh_file() does.
  explicit Materials(const BodyOptions &options);

  /// The material of the cells with this number; throws nothing.
  const Material &of(const dealii::types::material_id volume) const
  {
    const auto found = regions_.find(volume);
    return found == regions_.end() ? other_ : found->second;
  }

private:
  Material other_;
  std::map<dealii::types::material_id, Material> regions_;
};
} // namespace orthocone
