// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/body/options.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include "../names_of_groups.h"
#include "fatigue_constants.h"

#include <cmath>
#include <set>

namespace orthocone
{
namespace
{
std::optional<MaterialRegion> parse_region(const std::string &text)
{
  const NumberRange poisson{-1, 0.5};
  const auto parts = split(text, ':');
  if (parts.size() != 2 || parts[0].empty() || !is_group_name(parts[0]))
    return std::nullopt;
  const auto constants = parse_numbers(parts[1], 2, ',');
  if (!constants || !positive.contains((*constants)[0]) || !poisson.contains((*constants)[1]))
    return std::nullopt;
  return MaterialRegion{parts[0], (*constants)[0], (*constants)[1]};
}

/// Isotropic constants of physical volumes, each of which may be named once.
Codec<std::vector<MaterialRegion>> regions_codec()
{
  const auto is_new = [](const std::vector<MaterialRegion> &before, const MaterialRegion &region)
  {
    return std::none_of(before.begin(), before.end(),
                        [&](const MaterialRegion &other) { return other.volume == region.volume; });
  };
  const auto print = [](const MaterialRegion &region)
  { return region.volume + ": " + to_text(region.young_modulus) + ", " + to_text(region.poisson_ratio); };
  return list_codec<MaterialRegion>(
      "nothing, or regions \"name: E, nu\" (E > 0 in MPa, nu > -1 and < 0.5; each volume once), "
      "separated by ';'",
      ';', " ; ", parse_region, print, is_new);
}

void check_regions(const BodyOptions &body)
{
  const std::string entry = body.material.section + "/Regions";
  if (body.material.regions.empty())
    return;
  if (!body.geometry.is_from_file())
    throw InputError(entry + " is set without a mesh file: allowed is nothing, or " + body.geometry.section +
                     "/Shape = file, because regions are physical volumes of the file");
  const GmshFile file = read_mesh_file(body.geometry);
  std::set<const PhysicalGroup *> seen;
  FaultList faults;
  for (const MaterialRegion &region : body.material.regions)
  {
    const PhysicalGroup *const group = file.find(3, region.volume);
    const std::string given = "'" + shown(region.volume) + "' ";
    if (group == nullptr || group->n_elements == 0)
      faults.add(given + (group == nullptr ? "is no physical volume" : "has no cells"));
    else if (!seen.insert(group).second)
      faults.add(given + "names a volume a second time, by its name or its number");
  }
  faults.throw_if_any(entry + ": ", ": allowed in " + file.path + " are " + file.list(3) + ", each once");
}

/// The largest Poisson's ratio of a material, and the entry that it stands in.
std::pair<std::string, double> most_incompressible(const MaterialOptions &material)
{
  const double ratio = material.isotropic().poisson_ratio;
  constexpr double shown_digits = 1e4; // of the average, which has rounding in its last ones
  std::pair most(material.section +
                     (material.is_isotropic()
                          ? "/Poisson ratio = " + to_text(ratio)
                          : "/" + material.law.chosen().poisson_ratios_entry() + ", on average " +
                                to_text(std::round(shown_digits * ratio) / shown_digits)),
                 ratio);
  for (const MaterialRegion &region : material.regions)
    if (region.poisson_ratio > most.second)
      most = {material.section + "/Regions: a Poisson ratio of " + to_text(region.poisson_ratio),
              region.poisson_ratio};
  return most;
}
} // namespace

MaterialOptions MaterialOptions::isotropic() const
{
  if (is_isotropic())
    return {young_modulus, poisson_ratio};
  const IsotropicConstants average = law.chosen().average();
  return {average.young_modulus, average.poisson_ratio};
}

std::string MaterialOptions::regions_text() const
{
  return regions_codec().print(regions);
}

void declare_material(MaterialOptions &material, Section &section)
{
  section.add("Young modulus", material.young_modulus, number_codec(positive), "Young's modulus in MPa.")
      .unit("MPa")
      .also_called({"e", "young", "modulus", "elastic modulus"});
  section.add("Poisson ratio", material.poisson_ratio, number_codec(NumberRange{-1, 0.5}), "Poisson's ratio.")
      .also_called({"nu"});
  material.law.declare("Law", "Elastic law of the body.", section);
  section.add("Regions", material.regions, regions_codec(),
              "Isotropic constants of single physical volumes of a Mesh file, in place of those above: "
              "'name: E, nu ; ...'.");
  section
      .add("Thermal expansion", material.thermal_expansion, number_codec(NumberRange{-0.01, 0.01}),
           "Coefficient of thermal expansion: strain per kelvin, the same in all directions and in all "
           "volumes, for loads of the kind temperature; 1.2e-5 for steel.")
      .unit("1/K")
      .also_called({"alpha", "expansion", "cte"});
  declare_fatigue(material, section);
}

void check_material(const BodyOptions &body)
{
  body.material.law.chosen().check(body.material);
  check_regions(body);
  check_fatigue(body.material);
}

void warn_of_locking(const BodyOptions &body, std::vector<std::string> &warnings)
{
  constexpr double nearly_incompressible = 0.48; // docs/stability.md, "Nearly incompressible bodies"
  if (body.mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected)
    return;
  const auto [entry, ratio] = most_incompressible(body.material);
  if (ratio > nearly_incompressible)
    warnings.push_back(entry + " with " + body.mesh.section +
                       "/Degree = " + std::to_string(body.mesh.degree) +
                       " and full volumetric quadrature: the elements lock, so that pressures and forces "
                       "come out too large; take " +
                       body.mesh.section + "/Volumetric quadrature = projected");
}
} // namespace orthocone
