// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/materials.h>

#include <orthocone/body/shapes/imported_mesh.h>

namespace orthocone
{
Materials::Materials(const BodyOptions &options)
    : other_(options.material)
{
  if (options.material.regions.empty())
    return;
  const GmshFile file = read_mesh_file(options.geometry);
  for (const MaterialRegion &region : options.material.regions)
  {
    MaterialOptions isotropic;
    isotropic.young_modulus = region.young_modulus;
    isotropic.poisson_ratio = region.poisson_ratio;
    regions_.emplace(file.find(3, region.volume)->number, Material(isotropic));
  }
}
} // namespace orthocone
