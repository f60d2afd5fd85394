// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A program with a material of its own: one that is the same in all directions normal to z, as fibres along z
// make it. Its stiffness is written with Hill's moduli (J. Mech. Phys. Solids 12 (1964) 199-212), not as the
// inverse of a compliance, which the program's own orthotropic law is.
#include <orthocone/app/program.h>
#include <orthocone/body/options.h>

namespace
{
class TransverseLaw : public orthocone::MaterialLaw
{
public:
  std::unique_ptr<MaterialLaw> clone() const override { return std::make_unique<TransverseLaw>(*this); }

  void declare(orthocone::Section &section, const orthocone::Condition &is_chosen) override
  {
    using namespace orthocone;
    const auto modulus = number_codec(positive);
    const auto ratio = number_codec(any_number);
    section.add("Axial modulus", axial_modulus_, modulus, "Young's modulus along z, MPa.").only_if(is_chosen);
    section.add("Axial ratio", axial_ratio_, ratio, "-strain along x / strain along z, under stress along z.")
        .only_if(is_chosen);
    section.add("Axial shear modulus", axial_shear_, modulus, "G_xz = G_yz, MPa.").only_if(is_chosen);
    section.add("Plane modulus", plane_modulus_, modulus, "Young's modulus along x and y, MPa.")
        .only_if(is_chosen);
    section.add("Plane ratio", plane_ratio_, ratio, "-strain along y / strain along x, under stress along x.")
        .only_if(is_chosen);
  }

  std::optional<orthocone::ElasticTangent> tangent() const override
  {
    const double k = 1 / (2 * (1 - plane_ratio_) / plane_modulus_ -
                          4 * axial_ratio_ * axial_ratio_ / axial_modulus_), // against change of area
        l = 2 * k * axial_ratio_, n = axial_modulus_ + 4 * k * axial_ratio_ * axial_ratio_,
                 m = plane_modulus_ / (2 * (1 + plane_ratio_)); // against shear in the plane
    orthocone::ElasticTangent c;
    c[0][0][0][0] = c[1][1][1][1] = k + m;
    c[0][0][1][1] = c[1][1][0][0] = k - m;
    c[0][0][2][2] = c[2][2][0][0] = c[1][1][2][2] = c[2][2][1][1] = l;
    c[2][2][2][2] = n;
    c[0][1][0][1] = m;
    c[0][2][0][2] = c[1][2][1][2] = axial_shear_;
    return c;
  }

private:
  double axial_modulus_ = 210000, axial_ratio_ = 0.3, axial_shear_ = 80000; // MPa, -, MPa
  double plane_modulus_ = 210000, plane_ratio_ = 0.3;                       // MPa, -
};
} // namespace

int main(const int argc, const char *const *const argv)
{
  orthocone::kinds_of<orthocone::MaterialLaw>().push_back(
      {"transverse", "the same in all directions normal to z, by its five constants",
       [] { return std::make_unique<TransverseLaw>(); }});
  orthocone::run_program(argc, argv);
}
