// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/errors.h>
#include <orthocone/body/options.h>
#include <orthocone/body/shapes/imported_mesh.h>

#include "../names_of_groups.h"

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

/// Requires the leading minors of the compliance, each times the moduli of its axes, to be positive
/// (docs/theory.md, section 2, "Materials").
void check_orthotropic(const MaterialOptions &material)
{
  const auto &[e_x, e_y, e_z] = material.young_moduli;
  const auto &[nu_xy, nu_xz, nu_yz] = material.poisson_ratios;
  const double xy = nu_xy * nu_xy * e_y / e_x, xz = nu_xz * nu_xz * e_z / e_x, yz = nu_yz * nu_yz * e_z / e_y;
  const double all = 1 - xy - xz - yz - 2 * nu_xy * nu_yz * nu_xz * e_z / e_x;
  if (xy < 1 && xz < 1 && yz < 1 && all > 0)
    return;
  const std::string ratios = to_text(nu_xy) + ", " + to_text(nu_xz) + ", " + to_text(nu_yz);
  throw InputError(material.section + "/Poisson ratios = " + ratios +
                   " with these Young moduli do not store energy under every strain: allowed are |nu_xy| < "
                   "sqrt(E_x/E_y) = " +
                   to_text(std::sqrt(e_x / e_y)) +
                   ", |nu_xz| < sqrt(E_x/E_z) = " + to_text(std::sqrt(e_x / e_z)) +
                   ", |nu_yz| < sqrt(E_y/E_z) = " + to_text(std::sqrt(e_y / e_z)) +
                   " and 1 - nu_xy^2 E_y/E_x - nu_xz^2 E_z/E_x - nu_yz^2 E_z/E_y - 2 nu_xy nu_yz nu_xz "
                   "E_z/E_x > 0");
}

void check_regions(const BodyOptions &body)
{
  const std::string entry = body.material.section + "/Regions";
  if (body.material.regions.empty())
    return;
  if (!body.geometry.is_from_file())
    throw InputError(entry + " is set without a mesh file: allowed is nothing, or " + body.geometry.section +
                     "/Shape = file, whose physical volumes they name");
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
      faults.add(given + "is a volume that stands there before, by its name or its number");
  }
  faults.throw_if_any(entry + ": ", ": allowed in " + file.path + " are " + file.list(3) + ", each once");
}

/// The largest Poisson's ratio of a material, and the entry that it stands in.
std::pair<std::string, double> most_incompressible(const MaterialOptions &material)
{
  const double ratio = material.isotropic().poisson_ratio;
  constexpr double shown_digits = 1e4; // of the average, which has rounding in its last ones
  std::pair most(material.section + (material.is_orthotropic()
                                         ? "/Poisson ratios, on average " +
                                               to_text(std::round(shown_digits * ratio) / shown_digits)
                                         : "/Poisson ratio = " + to_text(ratio)),
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
  MaterialOptions same;
  same.young_modulus = young_modulus;
  same.poisson_ratio = poisson_ratio;
  if (!is_orthotropic())
    return same;
  // Sums of the compliances S_ii, S_ij and 1/G_ij; 1/K is the sum of all S_ij, and
  // 15/G = 4 sum S_ii - 4 sum_{i<j} S_ij + 3 sum 1/G_ij.
  double along = 0, shear = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    along += 1 / young_moduli[i];
    shear += 1 / shear_moduli[i];
  }
  const auto &[nu_xy, nu_xz, nu_yz] = poisson_ratios;
  const double across = -(nu_xy + nu_xz) / young_moduli[0] - nu_yz / young_moduli[1];
  const double bulk_modulus = 1 / (along + 2 * across),
               shear_modulus = 15 / (4 * along - 4 * across + 3 * shear);
  same.young_modulus = 9 * bulk_modulus * shear_modulus / (3 * bulk_modulus + shear_modulus);
  same.poisson_ratio = (3 * bulk_modulus - 2 * shear_modulus) / (2 * (3 * bulk_modulus + shear_modulus));
  return same;
}

std::string MaterialOptions::regions_text() const
{
  return regions_codec().print(regions);
}

void declare_material(MaterialOptions &material, Section &section)
{
  const Codec<std::array<double, 3>> moduli = three_numbers_codec(positive);
  section.add("Young modulus", material.young_modulus, number_codec(positive), "Young's modulus in MPa.")
      .also_called({"e", "young", "modulus", "elastic modulus"});
  section.add("Poisson ratio", material.poisson_ratio, number_codec(NumberRange{-1, 0.5}), "Poisson's ratio.")
      .also_called({"nu"});
  section.add_word("Law", material.law,
                   "isotropic: the two constants above; orthotropic: the nine below, along x, y and z.");
  section.add("Young moduli", material.young_moduli, moduli, "E_x, E_y, E_z in MPa.");
  section.add("Poisson ratios", material.poisson_ratios, three_numbers_codec(any_number),
              "nu_xy, nu_xz, nu_yz: under stress along x alone nu_xy = -strain along y / strain along x.");
  section.add("Shear moduli", material.shear_moduli, moduli, "G_xy, G_xz, G_yz in MPa.");
  section.add("Regions", material.regions, regions_codec(),
              "Other, isotropic constants of physical volumes of a Mesh file: 'name: E, nu ; ...'.");
}

void check_material(const BodyOptions &body)
{
  if (body.material.is_orthotropic())
    check_orthotropic(body.material);
  check_regions(body);
}

void warn_of_locking(const BodyOptions &body, std::vector<std::string> &warnings)
{
  constexpr double nearly_incompressible = 0.48; // docs/stability.md, "Nearly incompressible bodies"
  if (body.mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected)
    return;
  const auto [entry, ratio] = most_incompressible(body.material);
  if (ratio > nearly_incompressible)
    warnings.push_back(
        entry + " with " + body.mesh.section + "/Degree = " + std::to_string(body.mesh.degree) +
        " and full volumetric quadrature: the elements lock, pressures and forces come out too "
        "large; take " +
        body.mesh.section + "/Volumetric quadrature = projected");
}
} // namespace orthocone
